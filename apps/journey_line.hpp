#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "local/mission.hpp"

namespace underway {

/// Shows on standard error how a mission goes: a line whenever the state or the plan changes, and on a
/// terminal a bar that is renewed.
class JourneyLine {
 public:
  explicit JourneyLine(const Robot& robot);
  ~JourneyLine();
  JourneyLine(const JourneyLine&) = delete;
  JourneyLine& operator=(const JourneyLine&) = delete;

  /// After a tick, at a time since the beginning [s], with the state it told.
  void show(double time_s, const Mission& mission, State state);

 private:
  void showBar(double time_s, const Mission& mission, State state);
  void showLine(double time_s, const Mission& mission, State state);

  const Robot& robot_;
  bool is_terminal_;
  bool has_shown_ = false;
  State state_ = State::kIdle;
  int plans_ = 0;
  std::chrono::steady_clock::time_point shown_at_;
};

/// Metres of the plan that are still to go.
[[nodiscard]] double leftOf(const Executor& executor);
/// "walking (frontal), segment 2 of 7, 3.42 m to go".
[[nodiscard]] std::string describe(const Executor& executor, State state, const Robot& robot);

}  // namespace underway
