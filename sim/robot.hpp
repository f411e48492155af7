#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <string>

#include "geometry/checker.hpp"
#include "local/command.hpp"
#include "local/senses.hpp"
#include "sim/second_judge.hpp"
#include "sim/sensors.hpp"

namespace underway::sim {

/// What only the judge knows.
struct Truth {
  Pose pose;
  ModeId mode = 0;
  bool has_collided = false;  ///< by the word of either judge
  std::string with;           ///< the first obstacle it touched
  bool is_disputed = false;   ///< the judges disagree on a motion by more than touching
  double moved_m = 0.0;       ///< length of the way so far
};

/// A robot that walks, sidesteps, turns and crawls in a world, within its gaits' speed limits. Every tick's
/// motion is made of a turn and two translations, and each of them, and every switch's box, is checked
/// against the true world twice: exactly (geometry/checker.hpp), and by a second judge that shares nothing
/// with that. Nobody who drives it sees them. The same seed and commands give the same run.
class SimulatedRobot {
 public:
  static constexpr double kTick_s = Sensors::kTick_s;

  /// `truth` is the world as it is, mapped or not.
  SimulatedRobot(std::shared_ptr<const World> truth, std::shared_ptr<const Robot> robot, const Pose& start,
                 ModeId mode, std::uint64_t seed, const Flaws& flaws = {});

  /// What its senses tell now; the scan is kept in the robot until the next call.
  [[nodiscard]] const Senses& sense();
  /// Does what it is told for one tick.
  void step(const Command& command);

  [[nodiscard]] const Truth& truth() const { return truth_; }
  [[nodiscard]] double now_s() const { return static_cast<double>(ticks_) * kTick_s; }

  /// Things that go wrong: it lies on the floor until further notice; the localisation is gone; the crawl
  /// only slips.
  void fall() { has_fallen_ = true; }
  void loseItself(bool is_lost) { is_lost_ = is_lost; }
  void stall(bool is_stalled) { is_stalled_ = is_stalled; }

 private:
  void walk(const Velocity& velocity);
  void crawl(double wanted_mps);
  void beginSwitch(ModeId to);
  void goOnSwitching();
  [[nodiscard]] bool isLying() const;
  void move(double x_m, double y_m, double turn_rad);
  void check(const Motion& motion);

  std::shared_ptr<const World> world_;
  std::shared_ptr<const Robot> robot_;
  Checker checker_;
  SecondJudge second_judge_;
  Sensors sensors_;
  SpeedLimits limits_;
  Flaws flaws_;
  std::mt19937_64 random_;
  Truth truth_;
  std::uint64_t ticks_ = 0;
  double drift_rad_per_m_ = 0.0;
  double switch_left_s_ = 0.0;
  const Switch* switching_ = nullptr;
  double cycle_left_s_ = 0.0;
  double cycle_share_ = 0.0;  // of the stroke that this cycle keeps
  std::uint64_t cycles_ = 0;
  bool has_fallen_ = false;
  bool is_lost_ = false;
  bool is_stalled_ = false;
  Senses senses_;
};

}  // namespace underway::sim
