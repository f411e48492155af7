#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "gait/crawl/player.hpp"
#include "geometry/robot.hpp"
#include "local/command.hpp"
#include "local/crawl.hpp"
#include "local/low.hpp"

namespace underway {

/// The robot's own side of commands, where the gait is ours: lying down, crawling and getting up as joint
/// angles, tick by tick. What the executor calls a cycle, a stroke or a switch is what this plays; what
/// Senses tell of them is what this says. Walking is not: the robot's own engine takes the velocity.
///
/// One object for one robot and one thread. A tick allocates.
class GaitRunner {
 public:
  /// The robot is in `mode`, and at rest.
  GaitRunner(std::shared_ptr<const Robot> robot, gait::CrawlPlayer player, ModeId mode);

  /// What the joints do in this tick, from their last instant to `tick_s` later; empty while they keep as
  /// they are or walk. `heading_rad` is inertial, of any frame that does not turn. A motion that has begun
  /// is finished, whatever comes to be commanded.
  [[nodiscard]] std::optional<gait::JointTable> tick(const Command& command, double heading_rad,
                                                     double tick_s);

  [[nodiscard]] ModeId mode() const { return mode_; }
  [[nodiscard]] bool isSwitching() const { return motion_ && mode_ != to_; }
  /// It walks, if it is told to.
  [[nodiscard]] bool isWalking() const { return !motion_ && !isLow(*robot_, mode_); }
  /// Completed so far.
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }

 private:
  void begin(const Command& command, double heading_rad);
  void changeTo(ModeId to, double heading_rad);
  void finish();

  std::shared_ptr<const Robot> robot_;
  gait::CrawlPlayer player_;
  ModeId mode_;
  ModeId to_;                               // where the motion leads
  std::optional<gait::JointTable> motion_;  // that is under way
  double at_s_ = 0.0;                       // in the motion
  std::uint64_t cycles_ = 0;
};

/// The executor's settings for the crawl that a player plays: its stroke, none of which is lost that physics
/// did not lose, and its heading kept.
[[nodiscard]] CrawlSettings crawlSettingsOf(const gait::CrawlPlayer& player);

}  // namespace underway
