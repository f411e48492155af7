#pragma once

#include <string>
#include <string_view>

namespace underway {

/// The text with everything that moves a cursor or breaks a line replaced by a space: names come from files.
[[nodiscard]] std::string printable(std::string_view text);

/// One line on standard error: "underway: " and the sentence.
void complain(std::string_view sentence);

/// Whether standard output is a terminal that wants colours (NO_COLOR is honoured).
[[nodiscard]] bool wantsColour();

/// A bar on standard error while something long goes on; silent when that is no terminal. Gone when
/// destroyed.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Share that is done, 0..1. Called by one thread at a time.
  void show(double share);
  /// A line on standard error, above the bar.
  void say(std::string_view sentence);

 private:
  void erase();

  std::string what_;
  bool is_terminal_;
  int shown_percent_ = -1;
};

}  // namespace underway
