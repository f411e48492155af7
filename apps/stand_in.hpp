#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

#include "server/robot/robot_end.hpp"
#include "sim/robot.hpp"

namespace underway {

/// What a robot was told last, as long as that holds: without another command for 0.5 s it stands still.
class CommandWatchdog {
 public:
  static constexpr std::uint64_t kLongest_ticks = 5;

  void hear(std::uint64_t tick, const Command& command) { told_ = command, told_at_ = tick, is_told_ = true; }
  /// What to do in a tick.
  [[nodiscard]] Command at(std::uint64_t tick) const { return isSilent(tick) ? Command{} : told_; }
  [[nodiscard]] bool isSilent(std::uint64_t tick) const {
    return !is_told_ || tick >= told_at_ + kLongest_ticks;
  }

 private:
  Command told_;
  std::uint64_t told_at_ = 0;
  bool is_told_ = false;
};

struct StandInSettings {
  /// Time stands still until each senses have been answered: the same seed gives the same run, however quick
  /// the answers are. Else the clock goes on, and the watchdog looks whether commands still come.
  bool is_in_step = false;
  double rate = 1.0;  ///< simulated seconds in a second; 0, only in step: as many as there can be
};

/// A robot to be driven over its wire that is none: a simulated robot at a robot's end.
class StandIn {
 public:
  /// Called after each tick.
  using Watch = std::function<void(std::uint64_t tick, const sim::SimulatedRobot&, bool is_silent)>;

  StandIn(sim::SimulatedRobot& robot, std::unique_ptr<RobotEnd> end, const StandInSettings& settings)
      : robot_(robot), end_(std::move(end)), settings_(settings) {}

  /// Lives until it is told to stop. Errors: those of the wire.
  [[nodiscard]] Expected<void> live(const std::stop_token& stop, const Watch& watch = {});

 private:
  using Clock = RobotEnd::Clock;
  [[nodiscard]] Expected<Command> answerTo(const Senses& senses, const std::stop_token& stop);
  [[nodiscard]] Expected<Command> commandBy(Clock::time_point end_of_tick, const std::stop_token& stop);

  sim::SimulatedRobot& robot_;
  std::unique_ptr<RobotEnd> end_;
  StandInSettings settings_;
  CommandWatchdog watchdog_;
  std::uint64_t tick_ = 0;
};

}  // namespace underway
