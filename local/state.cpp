#include "local/state.hpp"

#include <array>

namespace underway {
namespace {

/// Which state does what comes next in the plan.
State stateFor(Next next) {
  switch (next) {
    case Next::kMove:
      return State::kWalking;
    case Next::kDown:
      return State::kAligning;
    case Next::kCrawl:
    case Next::kUp:  // it gets up from there, once there is room
      return State::kCrawling;
    case Next::kNothing:
      break;
  }
  return State::kArrived;
}

bool isStanding(State state) {
  return state == State::kSettling || state == State::kWalking || state == State::kAligning;
}

}  // namespace

std::string_view name(State state) {
  static constexpr std::array<std::string_view, 12> kNames{"idle",       "settling", "walking",    "aligning",
                                                           "going down", "crawling", "getting up", "arrived",
                                                           "blocked",    "lost",     "fallen",     "stalled"};
  return kNames.at(static_cast<std::size_t>(state));
}

State transition(State now, const Situation& is) {
  if (is.has_fallen) return State::kFallen;
  if (!is.has_plan) return now == State::kArrived ? State::kArrived : State::kIdle;
  if (isStanding(now) && is.is_lost) return State::kLost;
  switch (now) {
    case State::kIdle:
      return is.next == Next::kCrawl || is.next == Next::kUp ? State::kCrawling : State::kSettling;
    case State::kSettling:
      return is.is_settled ? stateFor(is.next) : now;
    case State::kWalking:
      return is.is_blocked ? State::kBlocked : stateFor(is.next);
    case State::kAligning:
      if (is.is_blocked) return State::kBlocked;
      if (is.next != Next::kDown) return stateFor(is.next);
      return is.is_aligned ? State::kGoingDown : now;
    case State::kGoingDown:
      if (is.is_stalled) return State::kStalled;
      return is.is_switching || is.next == Next::kDown ? now : stateFor(is.next);
    case State::kCrawling:
      if (is.next == Next::kUp && is.has_room_up) return State::kGettingUp;
      if (is.is_stalled) return State::kStalled;
      return is.next == Next::kMove ? State::kSettling : stateFor(is.next);
    case State::kGettingUp:
      if (is.is_stalled) return State::kStalled;
      return is.is_switching || is.next == Next::kUp ? now : State::kSettling;
    case State::kLost:
      return is.is_lost ? now : State::kSettling;
    case State::kArrived:
    case State::kBlocked:
    case State::kStalled:
    case State::kFallen:
      return now;  // until a new plan
  }
  return now;
}

}  // namespace underway
