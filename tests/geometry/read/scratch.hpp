#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "geometry/error.hpp"

namespace underway {

/// A folder of its own for a test's files, gone when the test ends.
class Scratch {
 public:
  Scratch() {
    std::string pattern = (std::filesystem::temp_directory_path() / "underway_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no scratch folder: " + pattern);
    folder_ = pattern;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  /// The path of a new file with this content.
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    // A new file, not the old one cut to nothing: disks are slow at making sure of that.
    std::filesystem::remove(folder_ / name);
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

/// Whether a result is a refusal whose sentence, on one line, names all of these.
template <class T>
testing::AssertionResult refusedNaming(const Expected<T>& result, std::initializer_list<std::string> words) {
  if (result.has_value()) return testing::AssertionFailure() << "was not refused";
  const std::string& sentence = result.error().message;
  if (sentence.find('\n') != std::string::npos)
    return testing::AssertionFailure() << "more than a line: " << sentence;
  for (const std::string& word : words)
    if (sentence.find(word) == std::string::npos)
      return testing::AssertionFailure() << "does not name '" << word << "': " << sentence;
  return testing::AssertionSuccess();
}

}  // namespace underway
