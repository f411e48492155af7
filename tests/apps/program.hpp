#pragma once

#include <sys/types.h>

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

/// The same with standard output closed too.
[[nodiscard]] Outcome runProgramWithoutOutput(const std::vector<std::string>& words);

/// The number of a DDS domain of this test's own, as a word.
[[nodiscard]] std::string testDomain();

/// A fresh folder for the files of one test; gone with the object.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// The path of a file in it.
  [[nodiscard]] std::string path(const std::string& file_name) const { return (path_ / file_name).string(); }
  /// Writes a file and returns its path.
  std::string write(const std::string& file_name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// `underway serve` in the background, killed at the latest with the object.
class Server {
 public:
  /// Returns when the program has printed its first line or ended.
  explicit Server(const std::vector<std::string>& words);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] const std::string& firstLine() const { return first_line_; }
  /// What it has written to standard error so far.
  [[nodiscard]] std::string errors() const;
  /// Sends the signal, waits for the end and returns the exit code, -1 if a signal ended it.
  int stop(int signal);

 private:
  Folder folder_;
  pid_t child_ = 0;
  std::string first_line_;
};

[[nodiscard]] std::string readAll(const std::filesystem::path& file);

}  // namespace underway
