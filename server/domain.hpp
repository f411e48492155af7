#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "geometry/error.hpp"

namespace underway {

/// Where robots and servers meet.
struct DomainSettings {
  std::uint32_t id = 0;      ///< DDS domain, 0..Domain::kLargestId; only equal ids meet
  bool use_network = false;  ///< false: this machine only. CYCLONEDDS_URI, when set, decides instead
  std::string tag = {};      ///< only equal tags meet; letters, digits and -, for one that wants to be alone
};

/// This process's membership in a DDS domain. A process has one for each id: open it once and share it
/// between the services and clients of the process.
///
/// Without CYCLONEDDS_URI it talks over loopback, or with `use_network` over the interface that Cyclone DDS
/// picks. Either way a peer that dies is noticed within about 1 s; what CYCLONEDDS_URI says goes before these
/// settings. Thread safety: may be shared by any number of threads.
class Domain {
 public:
  /// Errors: kInvalidRequest for an id out of range, a domain that is already open in this process, or a
  /// configuration that Cyclone DDS refuses.
  [[nodiscard]] static Expected<std::shared_ptr<const Domain>> open(const DomainSettings& settings);
  ~Domain();
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  [[nodiscard]] std::uint32_t id() const { return id_; }

  static constexpr std::uint32_t kLargestId = 230;  ///< beyond, UDP ports run out

 private:
  Domain(std::uint32_t id, std::int32_t handle) : id_(id), handle_(handle) {}
  std::uint32_t id_;
  std::int32_t handle_;  ///< Cyclone DDS entity
};

}  // namespace underway
