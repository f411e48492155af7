#include "apps/journey_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "apps/table.hpp"
#include "apps/terminal.hpp"

namespace underway {
namespace {

constexpr std::chrono::milliseconds kRenew{100};

constexpr const char* kErase = "\r\x1b[K";

void say(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

std::string barOf(double share) {
  constexpr std::size_t kCells = 24;
  const auto full = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * kCells);
  std::string bar(kCells, '.');
  bar.replace(0, full, full, '#');
  return std::string("[").append(bar).append("]");
}

}  // namespace

double leftOf(const Executor& executor) {
  const auto& segments = executor.plan().segments;
  double left_m = 0.0;
  for (std::size_t i = executor.segment(); i < segments.size(); ++i) {
    const Motion& motion = segments[i].motion;
    const bool is_under_way = i == executor.segment() && motion.kind == MotionKind::kTranslate;
    left_m += is_under_way
                  ? std::min(distance(executor.pose().position(), motion.to.position()), length(motion))
                  : length(motion);
  }
  return left_m;
}

std::string describe(const Executor& executor, State state, const Robot& robot) {
  const std::size_t count = executor.plan().segments.size();
  std::string text = std::string(name(state)) + " (" + printable(robot.modes[executor.mode()].name) + ")";
  if (count == 0 || state == State::kArrived) return text;
  return text + ", segment " + std::to_string(std::min(executor.segment() + 1, count)) + " of " +
         std::to_string(count) + ", " + fixed(leftOf(executor), 2) + " m to go";
}

JourneyLine::JourneyLine(const Robot& robot) : robot_(robot), is_terminal_(isatty(STDERR_FILENO) == 1) {}

JourneyLine::~JourneyLine() {
  if (is_terminal_ && has_shown_) say(kErase);
}

void JourneyLine::show(double time_s, const Mission& mission, State state) {
  showLine(time_s, mission, state);
  if (is_terminal_) showBar(time_s, mission, state);
}

void JourneyLine::showBar(double time_s, const Mission& mission, State state) {
  const auto now = std::chrono::steady_clock::now();
  if (now - shown_at_ < kRenew) return;
  shown_at_ = now;
  const Executor& executor = mission.executor();
  const double all_m = executor.plan().length_m;
  const double share = all_m > 0.0 ? 1.0 - leftOf(executor) / all_m : 0.0;
  say(std::string("\r").append(barOf(share)) + " " + fixed(time_s, 1) + " s  " +
      describe(executor, state, robot_) + "\x1b[K");
}

void JourneyLine::showLine(double time_s, const Mission& mission, State state) {
  const Executor& executor = mission.executor();
  if (has_shown_ && state == state_ && mission.plans() == plans_) return;
  const bool is_new_plan = mission.plans() != plans_;
  has_shown_ = true;
  state_ = state;
  plans_ = mission.plans();
  std::string text = fixed(time_s, 1) + " s  " + describe(executor, state, robot_);
  if (is_new_plan)
    text += "; plan " + std::to_string(plans_) + ": " + fixed(executor.plan().length_m, 2) + " m, " +
            fixed(executor.plan().total_time_s, 1) + " s";
  if (!mission.why().empty()) text += "; " + printable(mission.why());
  say((is_terminal_ ? kErase : "") + text + "\n");
}

}  // namespace underway
