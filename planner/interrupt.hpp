#pragma once

#include <chrono>
#include <stop_token>

namespace underway {

/// When to give up: a deadline or a stop. Asked in every inner loop. One for each thread.
class Interrupt {
 public:
  using Clock = std::chrono::steady_clock;
  Interrupt(Clock::time_point deadline, std::stop_token stop) : deadline_(deadline), stop_(std::move(stop)) {}

  /// For loops whose rounds take less than a microsecond: looks at the clock every few calls only.
  [[nodiscard]] bool isDue() { return due_ || (calls_++ % kCallsPerLook == 0 && isDueNow()); }
  /// For all others.
  [[nodiscard]] bool isDueNow() {
    if (!due_) due_ = stop_.stop_requested() || Clock::now() >= deadline_;
    return due_;
  }
  [[nodiscard]] Clock::time_point deadline() const { return deadline_; }
  [[nodiscard]] const std::stop_token& stop() const { return stop_; }

 private:
  static constexpr unsigned kCallsPerLook = 16;
  Clock::time_point deadline_;
  std::stop_token stop_;
  unsigned calls_ = 0;
  bool due_ = false;
};

}  // namespace underway
