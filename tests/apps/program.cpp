#include "tests/apps/program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/test_domain.hpp"

namespace underway {

namespace {

/// An open file, closed with the object.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {
    if (number < 0) throw std::runtime_error("cannot open a file for the program under test");
  }
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// `output`: null for none.
pid_t start(const std::vector<std::string>& words, const Descriptor* output, const Descriptor& errors) {
  std::vector<std::string> all{UNDERWAY_PROGRAM};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (output != nullptr)
    posix_spawn_file_actions_adddup2(&actions, output->number(), STDOUT_FILENO);
  else
    posix_spawn_file_actions_addclose(&actions, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.number(), STDERR_FILENO);
  pid_t child = 0;
  const int failed = posix_spawn(&child, UNDERWAY_PROGRAM, &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " UNDERWAY_PROGRAM);
  return child;
}

int waitFor(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int openNew(const std::string& file) { return ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600); }

}  // namespace

Outcome runProgram(const std::vector<std::string>& words) {
  // Into files, not pipes: neither stream can fill up and block the other.
  const Folder folder;
  const std::string output = folder.path("output");
  const std::string errors = folder.path("errors");
  const Descriptor into(openNew(output));
  const int exit_code = waitFor(start(words, &into, Descriptor(openNew(errors))));
  return {exit_code, readAll(output), readAll(errors)};
}

Outcome runProgramWithoutOutput(const std::vector<std::string>& words) {
  const Folder folder;
  const std::string errors = folder.path("errors");
  const int exit_code = waitFor(start(words, nullptr, Descriptor(openNew(errors))));
  return {exit_code, "", readAll(errors)};
}

Server::Server(const std::vector<std::string>& words) {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
  const Descriptor reading(ends[0]);
  {
    const Descriptor writing(ends[1]);  // closed at once: only the child's end keeps the pipe open
    const Descriptor errors(openNew(folder_.path("errors")));
    child_ = start(words, &writing, errors);
  }
  for (char c = 0; ::read(reading.number(), &c, 1) == 1 && c != '\n';) first_line_ += c;
}

Server::~Server() {
  if (child_ != 0) stop(SIGKILL);
}

std::string Server::errors() const { return readAll(folder_.path("errors")); }

int Server::stop(int signal) {
  ::kill(child_, signal);
  const int exit_code = waitFor(child_);
  child_ = 0;
  return exit_code;
}

std::string testDomain() { return std::to_string(test::testDomain()); }

Folder::Folder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "underway_test_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
  path_ = pattern;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& file_name, const std::string& text) const {
  std::ofstream(path(file_name), std::ios::binary) << text;
  return path(file_name);
}

std::string readAll(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace underway
