#include "planner/attach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "planner/draft.hpp"
#include "planner/rails.hpp"
#include "planner/sites.hpp"

namespace underway {
namespace {

using PlaceId = Draft::PlaceId;

constexpr std::size_t kNeighbours = 16;
constexpr std::size_t kAllNeighbours = 64;       // with all effort: the nearest may all be behind a wall
constexpr std::size_t kNeighboursOfHelpers = 8;  // of places added to get out of a tight spot or off a line
constexpr std::array kGrid_m{-1.2, -0.8, -0.5, -0.3, -0.15, -0.06, 0.0, 0.06, 0.15, 0.3, 0.5, 0.8, 1.2};
constexpr double kSamePlace_m = 1e-6;
constexpr double kGoalTolerance_m = 0.009;  // formats: 0.01 m, 0.02 rad; less a little
constexpr double kGoalTolerance_rad = 0.019;
constexpr int kOpenHeadings = 24;

/// One end of the request, and which way in time it is attached.
struct End {
  enum class Side { kStart, kGoal };
  Side side;
  ModeId mode;
  Pose pose;
  bool has_heading;
  std::vector<PlaceId> places;  // in `mode` first, then in its companions
};

class Attachment {
 public:
  Attachment(const Checker& checker, std::shared_ptr<const Roadmap> roadmap)
      : checker_(checker),
        robot_(checker.robot()),
        base_(roadmap),
        draft_(robot_, std::move(roadmap)),
        sites_(checker, draft_, Draft::Check::kWhenUsed),
        rails_(checker, draft_, sites_) {}

  std::optional<Attached> attach(const Request& request, Effort effort, Interrupt& interrupt) {
    End start = startOf(request);
    End goal = goalOf(request, start);
    for (End* end : {&start, &goal}) {
      connectToRoadmap(end->places, effort == Effort::kNearest ? kNeighbours : kAllNeighbours);
      leaveTightPlace(*end);
      followLine(*end);
      changeMode(*end);
      if (effort == Effort::kLocalRoadmap) addLocalRoadmap(*end);
      if (interrupt.isDue()) return std::nullopt;
    }
    join(start, goal);
    auto roadmap = draft_.freeze(checker_, Draft::Check::kWhenUsed, interrupt);
    if (!roadmap) return std::nullopt;
    Attached result{std::move(*roadmap), 0, goal.places[0], std::nullopt};
    result.start = *findNode(result.roadmap, start.places[0], start.pose.yaw);
    if (goal.has_heading) result.goal_node = *findNode(result.roadmap, goal.places[0], goal.pose.yaw);
    return result;
  }

 private:
  End startOf(const Request& request) {
    End start{End::Side::kStart, request.start_mode, request.start, true, {}};
    addPlaces(start);
    return start;
  }

  End goalOf(const Request& request, const End& start) {
    End goal{End::Side::kGoal,
             request.goal_mode,
             {request.goal.x, request.goal.y, request.goal_yaw.value_or(0.0)},
             request.goal_yaw.has_value(),
             {}};
    if (const auto ahead = goalOnLineOf(start, goal)) goal.pose = *ahead, goal.has_heading = true;
    if (distance(start.pose.position(), goal.pose.position()) < kSamePlace_m) {
      const auto here = std::find_if(start.places.begin(), start.places.end(),
                                     [&](PlaceId place) { return draft_.modeOf(place) == goal.mode; });
      if (here != start.places.end()) {
        goal.places = {*here};
        draft_.keepLess(*here, keepOf(goal));
        if (goal.has_heading) draft_.addHeading(*here, goal.pose.yaw);
        return goal;
      }
    }
    addPlaces(goal);
    return goal;
  }

  /// A goal that a mode that cannot turn reaches straight on, but for the tolerance with which goals are
  /// reached: the pose on the start's line nearest to it.
  [[nodiscard]] std::optional<Pose> goalOnLineOf(const End& start, const End& goal) const {
    const Mode& mode = robot_.modes[start.mode];
    if (goal.mode != start.mode || mode.canTurn()) return std::nullopt;
    if (goal.has_heading && std::abs(normalizedAngle(goal.pose.yaw - start.pose.yaw)) > kGoalTolerance_rad)
      return std::nullopt;
    for (const Sense sense : kSenses) {
      const double direction = start.pose.yaw + angleOf(sense);
      const double way = std::cos(direction) * (goal.pose.x - start.pose.x) +
                         std::sin(direction) * (goal.pose.y - start.pose.y);
      if (!mode.canMove(sense) || way < 0.0) continue;
      const Pose ahead = translate(start.mode, sense, start.pose, way).to;
      if (distance(ahead.position(), goal.pose.position()) <= kGoalTolerance_m) return ahead;
    }
    return std::nullopt;
  }

  /// Headings to reach an end at, where it matters: its own, or, of a goal that leaves it open, some all
  /// round.
  [[nodiscard]] static std::vector<Pose> posesOf(const End& end) {
    if (end.has_heading) return {end.pose};
    std::vector<Pose> poses;
    for (int i = 0; i < kOpenHeadings; ++i)
      poses.push_back({end.pose.x, end.pose.y, normalizedAngle(2.0 * std::numbers::pi * i / kOpenHeadings)});
    return poses;
  }

  /// The clearance to keep at an end: of the roomiest heading if it is open.
  [[nodiscard]] double keepOf(const End& end) const {
    double keep = 0.0;
    for (const Pose& pose : posesOf(end)) keep = std::max(keep, clearanceToKeep(checker_, end.mode, pose));
    return keep;
  }

  void addPlaces(End& end) {
    end.places = sites_.add(end.mode, end.pose.position(), keepOf(end));
    if (end.has_heading) draft_.addHeading(end.places[0], end.pose.yaw);
  }

  void connectToRoadmap(const std::vector<PlaceId>& places, std::size_t most) {
    for (const PlaceId place : places) {
      const ModeId mode = draft_.modeOf(place);
      if (!robot_.modes[mode].canTurn()) continue;
      std::vector<PlaceId> neighbours = base_->main_index.nearest(mode, draft_.positionOf(place), most);
      for (const PlaceId other : base_->index.nearest(mode, draft_.positionOf(place), most))
        if (std::find(neighbours.begin(), neighbours.end(), other) == neighbours.end())
          neighbours.push_back(other);
      for (const PlaceId neighbour : neighbours) sites_.connect(place, neighbour);
    }
  }

  /// A grid in the end's own frame, joined along its rows and columns at the end's heading, as one parks a
  /// car, and connected to the roadmap all over.
  void addLocalRoadmap(const End& end) {
    if (!robot_.modes[end.mode].canTurn()) return;
    constexpr std::size_t kCount = kGrid_m.size();
    std::vector<std::vector<PlaceId>> grid;
    for (const double y : kGrid_m) {
      for (const double x : kGrid_m) {
        const bool is_end = x == 0.0 && y == 0.0;
        grid.push_back(is_end ? end.places
                              : sites_.add(end.mode, transform(end.pose, {x, y}), robot_.margin_m));
        if (!is_end) connectToRoadmap(grid.back(), kNeighboursOfHelpers);
      }
    }
    for (std::size_t i = 0; i < grid.size(); ++i) {
      if (i % kCount + 1 < kCount) joinAlong(grid[i], grid[i + 1], end.pose.yaw, Sense::kForward);
      if (i + kCount < grid.size()) joinAlong(grid[i], grid[i + kCount], end.pose.yaw, Sense::kLeft);
    }
  }

  void joinAlong(const std::vector<PlaceId>& from, const std::vector<PlaceId>& to, double yaw, Sense sense) {
    for (const PlaceId a : from)
      for (const PlaceId b : to)
        if (draft_.modeOf(a) == draft_.modeOf(b)) draft_.addTranslation(a, b, yaw, sense);
  }

  /// Where the body cannot turn, connections at other headings fail: go straight first.
  void leaveTightPlace(const End& end) {
    if (!end.has_heading) return;
    for (const PlaceId place : end.places) {
      const ModeId mode = draft_.modeOf(place);
      const Mode& moving = robot_.modes[mode];
      if (!moving.canTurn() || checker_.isFreeAllRound(mode, end.pose.position(), robot_.margin_m)) continue;
      for (const Sense sense : kSenses) {
        if (!moving.canMove(sense) && !moving.canMove(opposite(sense))) continue;
        connectToRoadmap(rails_.addWayOut(place, sense, end.pose), kNeighboursOfHelpers);
      }
    }
  }

  /// A mode that cannot turn leaves a start ahead and comes to a goal from behind.
  void followLine(const End& end) {
    if (robot_.modes[end.mode].canTurn()) return;
    for (const Pose& pose : posesOf(end)) followLine(end.side, end.places[0], pose);
  }

  void followLine(End::Side side, PlaceId place, const Pose& pose) {
    for (const Sense sense : kSenses) {
      if (!robot_.modes[draft_.modeOf(place)].canMove(sense)) continue;
      connectToRoadmap(side == End::Side::kStart ? rails_.addExits(place, sense, pose)
                                                 : rails_.addEntries(place, sense, pose),
                       kNeighboursOfHelpers);
    }
  }

  /// Switches out of the start's mode right there, and into the goal's; those between companions are theirs
  /// already. A goal that leaves its heading open needs this only if its mode cannot turn: else it turns to
  /// where a switch is.
  void changeMode(const End& end) {
    if (!end.has_heading && robot_.modes[end.mode].canTurn()) return;
    const std::vector<ModeId> companions = companionsOf(robot_)[end.mode];
    for (const Switch& change : robot_.switches) {
      const bool is_start = end.side == End::Side::kStart;
      if ((is_start ? change.from : change.to) != end.mode) continue;
      const ModeId other_mode = is_start ? change.to : change.from;
      if (std::find(companions.begin(), companions.end(), other_mode) != companions.end()) continue;
      for (const Pose& pose : posesOf(end)) changeMode(end, pose, change);
    }
  }

  void changeMode(const End& end, const Pose& pose, const Switch& change) {
    const bool is_start = end.side == End::Side::kStart;
    const double keep = draft_.keepOf(end.places[0]);
    const Pose other = is_start ? compose(pose, change.displacement) : before(pose, change.displacement);
    if (!isFreeKeeping(checker_, switchModes(change, is_start ? pose : other), keep)) return;
    const bool is_here = other.position() == pose.position();
    const auto places =
        sites_.add(is_start ? change.to : change.from, other.position(), is_here ? keep : robot_.margin_m);
    if (is_start)
      draft_.addSwitch(end.places[0], pose.yaw, places[0], other.yaw);
    else
      draft_.addSwitch(places[0], other.yaw, end.places[0], pose.yaw);
    connectToRoadmap(places, kNeighboursOfHelpers);
    followLine(end.side, places[0], other);
  }

  /// Straight from start to goal, in every mode both have.
  void join(const End& start, const End& goal) {
    for (const PlaceId a : start.places)
      for (const PlaceId b : goal.places)
        if (a != b && draft_.modeOf(a) == draft_.modeOf(b)) joinPlaces(start, goal, a, b);
  }

  void joinPlaces(const End& start, const End& goal, PlaceId a, PlaceId b) {
    const Mode& mode = robot_.modes[draft_.modeOf(a)];
    if (mode.canTurn()) {
      sites_.connect(a, b);
      return;
    }
    for (const Sense sense : kSenses) {  // without turning: only if the goal lies on the start's line
      const double way = distance(start.pose.position(), goal.pose.position());
      const Motion ahead = translate(start.mode, sense, start.pose, way);
      if (mode.canMove(sense) && goal.has_heading && goal.pose.yaw == start.pose.yaw &&
          distance(ahead.to.position(), goal.pose.position()) < 1e-10)
        draft_.addTranslation(a, b, start.pose.yaw, sense);
    }
  }

  const Checker& checker_;
  const Robot& robot_;
  std::shared_ptr<const Roadmap> base_;
  Draft draft_;
  Sites sites_;
  Rails rails_;
};

}  // namespace

std::optional<Attached> attach(const Checker& checker, std::shared_ptr<const Roadmap> roadmap,
                               const Request& request, Effort effort, Interrupt& interrupt) {
  return Attachment(checker, std::move(roadmap)).attach(request, effort, interrupt);
}

}  // namespace underway
