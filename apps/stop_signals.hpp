#pragma once

#include <stop_token>
#include <thread>

namespace underway {

/// Turns SIGINT and SIGTERM into a stop request while it lives. Make it before any other thread is started:
/// threads inherit that the signals are blocked, so that only this one takes them, where it may do more than
/// a handler may.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }

 private:
  std::stop_source stop_;
  std::thread waiter_;
};

}  // namespace underway
