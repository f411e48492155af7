#pragma once

#include <chrono>
#include <stop_token>

namespace underway {

/// When to give up: a deadline or a stop. Asked in every inner loop; cheap, because it looks at the clock
/// only every few calls. One for each thread.
class Interrupt {
 public:
  using Clock = std::chrono::steady_clock;
  Interrupt(Clock::time_point deadline, std::stop_token stop) : deadline_(deadline), stop_(std::move(stop)) {}

  [[nodiscard]] bool isDue() {
    if (!due_ && calls_++ % kCallsPerLook == 0) due_ = stop_.stop_requested() || Clock::now() >= deadline_;
    return due_;
  }
  [[nodiscard]] bool isStopped() const { return stop_.stop_requested(); }

 private:
  static constexpr unsigned kCallsPerLook = 16;
  Clock::time_point deadline_;
  std::stop_token stop_;
  unsigned calls_ = 0;
  bool due_ = false;
};

}  // namespace underway
