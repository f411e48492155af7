#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace underway::test {

/// The number of a DDS domain that no other test on this machine has at the same time: its lock file is held
/// until the process ends.
inline std::uint32_t testDomain() {
  static const std::uint32_t kDomain = [] {
    constexpr std::uint32_t kFirst = 100;
    constexpr std::uint32_t kCount = 100;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const std::uint32_t domain = kFirst + (static_cast<std::uint32_t>(getpid()) + i) % kCount;
      const auto file =
          std::filesystem::temp_directory_path() / ("underway_test_domain_" + std::to_string(domain));
      const int lock = open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
      if (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) == 0) return domain;
      if (lock >= 0) close(lock);
    }
    throw std::runtime_error("no DDS domain from 100 to 199 is left for a test: remove " +
                             (std::filesystem::temp_directory_path() / "underway_test_domain_*").string());
  }();
  return kDomain;
}

}  // namespace underway::test
