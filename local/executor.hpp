#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/checker.hpp"
#include "local/belief.hpp"
#include "local/crawl.hpp"
#include "local/follow.hpp"
#include "local/senses.hpp"
#include "local/state.hpp"
#include "local/surroundings.hpp"
#include "planner/plan.hpp"

namespace underway {

struct ExecutorSettings {
  BeliefSettings belief;
  FollowSettings follow;
  CrawlSettings crawl;
  SurroundingsSettings surroundings;
  double tick_s = 0.1;
  int settled_fixes = Surroundings::kSettling;  ///< fixes of localisation in a row that it moves after
  double lost_after_s = 1.0;                    ///< standing without localisation
  double stuck_after_s = 15.0;  ///< no progress along the plan while walking is a blocked segment
};

/// What a tick gives.
struct Tick {
  Command command;
  State state = State::kIdle;
};

/// Carries out a plan, tick by tick: from senses to commands. It knows the plan, the map the plan was made in
/// and its own senses; what it believes is never the simulation's truth.
///
/// A tick takes bounded time, no locks, and while it walks no memory. Taking a plan does allocate. One object
/// for one robot and one thread.
class Executor {
 public:
  Executor(std::shared_ptr<const Robot> robot, const ExecutorSettings& settings = {});

  /// Takes a plan, made in a world: a map and what was seen that it does not have, as of the last
  /// `tellSurprises`. The robot is in the mode that the plan begins in. Replaces the plan before.
  void follow(Plan plan, std::shared_ptr<const World> world, const World& map);
  /// Lets go of the plan: the robot stands still.
  void stop();

  [[nodiscard]] Tick tick(const Senses& senses);

  [[nodiscard]] State state() const { return state_; }
  /// Where it believes it is: where a new plan has to start.
  [[nodiscard]] const Pose& pose() const { return belief_.pose(); }
  [[nodiscard]] ModeId mode() const { return mode_; }
  /// Whether it has had enough fixes to know where it is; lying it goes by its strokes.
  [[nodiscard]] bool isSettled() const;
  [[nodiscard]] std::size_t segment() const { return segment_; }
  [[nodiscard]] const Plan& plan() const { return plan_; }
  /// Stalled: why, in words. Empty otherwise.
  [[nodiscard]] std::string_view whyStalled() const { return state_ == State::kStalled ? stalled_by_ : ""; }
  /// Where it saw something the map does not have, near the robot: a point for each cell of the window.
  [[nodiscard]] std::vector<Point> surprises() const;
  /// Whoever makes the next plan has been told of these: they do not block it, but the guard keeps off them.
  void surprisesAreKnown() { surroundings_.markKnown(); }
  /// Blocked without progress, though nothing unmapped stands in the plan's way: held by the guard.
  [[nodiscard]] bool isHeld() const { return state_ == State::kBlocked && is_held_; }
  /// Floor near the robot that was not seen: the middles of SeenFloor's cells.
  [[nodiscard]] std::vector<Point> unseenFloor() const;

 private:
  void believe(const Senses& senses);
  void believeStrokes(std::uint64_t cycles);
  void watchLocalisation(const Senses& senses);
  void finishSegments(const Senses& senses);
  [[nodiscard]] Situation situation(const Senses& senses);
  [[nodiscard]] Command commandFor(const Senses& senses);
  [[nodiscard]] Velocity walkOn(const Senses& senses);
  [[nodiscard]] double turnToLook();
  [[nodiscard]] Velocity crawlOn();
  [[nodiscard]] double lookRad(double now_s) const;
  [[nodiscard]] bool isBlocked();
  [[nodiscard]] bool isPassageBlocked() const;
  [[nodiscard]] Pose entry() const;
  [[nodiscard]] bool isTriggered() const;
  [[nodiscard]] bool isAligned();
  [[nodiscard]] bool hasRoomUpHere() const;
  [[nodiscard]] std::string_view stalledBy() const;
  [[nodiscard]] std::string_view crawlStalledBy() const;
  [[nodiscard]] double strideOn() const;
  [[nodiscard]] double nextStride() const;
  [[nodiscard]] bool isDone(const Segment& segment, const Senses& senses) const;
  void beginSegment();
  [[nodiscard]] Next next() const;
  [[nodiscard]] const Segment* current() const;
  void watchProgress();

  std::shared_ptr<const Robot> robot_;
  ExecutorSettings settings_;
  SpeedLimits limits_;
  Belief belief_;
  Follow follow_;
  Surroundings surroundings_;
  Plan plan_;
  std::shared_ptr<const Checker> checker_;
  std::size_t segment_ = 0;
  Passage passage_;  // of the low segments that come next or are under way
  State state_ = State::kIdle;
  ModeId mode_ = 0;
  bool is_told_ = false;  // anything by the robot
  bool has_pose_ = false;
  Command last_;
  double shift_m_ = 0.0;  // of the lane, round something in the way
  int aligned_ticks_ = 0;
  double silent_s_ = 0.0;       // standing, without localisation
  bool is_looking_ = false;     // or turns back from it
  double look_sense_ = 0.0;     // 1: it turns to the left to look, -1: to the right
  double looked_s_ = 0.0;       // before going backwards in this segment
  double idle_s_ = 0.0;         // since the last progress
  double best_progress_ = 0.0;  // in this segment
  bool is_held_ = false;        // made none for too long
  // Of the crawl.
  std::uint64_t cycles_ = 0;  // as the robot counts them
  int crawled_ = 0;           // since it lies
  double strokes_ = 0.0;      // the same in whole ones, as sigmaAfter counts them
  bool is_stroke_ = false;    // a cycle is under way
  double stride_ = 1.0;       // the share of a whole stroke that it makes
  double stroke_s_ = 0.0;     // for so long
  std::string_view stalled_by_;
};

}  // namespace underway
