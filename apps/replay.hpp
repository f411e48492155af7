#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/checker.hpp"
#include "local/mission.hpp"
#include "server/robot/heard.hpp"
#include "sim/robot.hpp"

namespace underway {

/// What truly happened, tick by tick: the judge's side of a run.
class TrueTrack {
 public:
  struct Tick {
    std::uint64_t tick = 0;
    Pose pose;
    ModeId mode = 0;
    double clearance_m = 0.0;  ///< planar, of the standing or lying body where it is; 1 at most
    double speed_mps = 0.0;
  };
  TrueTrack(std::shared_ptr<const World> truth, std::shared_ptr<const Robot> robot)
      : checker_(std::make_shared<const Checker>(std::move(truth), std::move(robot))) {}

  /// After a tick.
  void add(std::uint64_t tick, const sim::SimulatedRobot& body);
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }
  [[nodiscard]] double leastClearance() const;

 private:
  std::shared_ptr<const Checker> checker_;
  std::vector<Tick> ticks_;
};

/// What the robot believed and did, tick by tick.
class OwnTrack {
 public:
  struct Tick {
    std::uint64_t tick = 0;
    Pose believed;
    State state = State::kIdle;
    std::size_t segment = 0;
    std::size_t plans = 0;
  };
  struct NewPlan {
    std::uint64_t tick = 0;
    Plan plan;
  };
  struct Seen {
    std::uint64_t tick = 0;
    std::vector<Point> cells;
  };
  struct Look {
    std::uint64_t tick = 0;
    std::string ranges;  ///< packedRanges()
  };

  void add(const Mission& mission, State state, const HeardSenses& heard);
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }
  [[nodiscard]] const std::vector<NewPlan>& plans() const { return plans_; }
  [[nodiscard]] const std::vector<Seen>& surprises() const { return surprises_; }
  [[nodiscard]] const std::vector<Look>& looks() const { return looks_; }

 private:
  std::vector<Tick> ticks_;
  std::vector<NewPlan> plans_;
  std::vector<Seen> surprises_;
  std::vector<Look> looks_;
};

/// Every so many beams become one, the nearest of them.
inline constexpr std::size_t kReplayBeams = 4;
/// Two characters a range: centimetres in base 64, 4095 for nothing.
[[nodiscard]] std::string packedRanges(const Scan& scan);

/// A run to be looked at again.
struct Replay {
  std::string title;
  std::string outcome;  ///< how it ended, in a sentence
  const World& map;
  const World& truth;
  const Robot& robot;
  const Request& request;
  const TrueTrack& true_track;
  const OwnTrack& own_track;
};

/// What the page shows, as JSON: numbers rounded to millimetres, columns of differences from tick to tick.
[[nodiscard]] std::string replayData(const Replay& replay);
/// A page that opens without a network: the data, and what plays it.
[[nodiscard]] std::string replayPage(const Replay& replay);

}  // namespace underway
