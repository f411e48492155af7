#include "apps/terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace underway {

std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return result;
}

void complain(std::string_view sentence) {
  // One write: lines of several threads do not mix.
  const std::string line = "underway: " + printable(sentence) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

bool wantsColour() { return isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr; }

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)), is_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() { erase(); }

void ProgressBar::erase() {
  constexpr std::string_view kBackToStartAndErase = "\r\x1b[K";
  if (shown_percent_ >= 0) std::fwrite(kBackToStartAndErase.data(), 1, kBackToStartAndErase.size(), stderr);
  shown_percent_ = -1;
}

void ProgressBar::say(std::string_view sentence) {
  erase();
  const std::string line = printable(sentence) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void ProgressBar::show(double share) {
  constexpr int kCells = 32;
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  if (!is_terminal_ || percent == shown_percent_) return;
  shown_percent_ = percent;
  const std::size_t full = static_cast<std::size_t>(percent * kCells / 100);
  const std::string bar = std::string(full, '#') + std::string(kCells - full, '.');
  std::fprintf(stderr, "\r%s [%s] %3d %%", what_.c_str(), bar.c_str(), percent);
}

}  // namespace underway
