#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace underway {

/// What a run of the real program left behind.
struct Outcome {
  int exit_code = -1;  ///< -1 if a signal ended it
  std::string output;
  std::string errors;
};

/// Runs `underway` with these words, standard input closed, and waits for its end.
[[nodiscard]] Outcome runProgram(const std::vector<std::string>& words);

/// A fresh folder for the files of one test; gone with the object.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// The path of a file in it. Writes the text when there is one.
  [[nodiscard]] std::string path(const std::string& file_name) const { return (path_ / file_name).string(); }
  std::string write(const std::string& file_name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string readAll(const std::filesystem::path& file);

}  // namespace underway
