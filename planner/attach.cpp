#include "planner/attach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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
  PlaceId place = 0;
};

class Attachment {
 public:
  Attachment(const Checker& checker, const Stances& stances, const Roadmap& roadmap)
      : checker_(checker),
        robot_(checker.robot()),
        stances_(stances),
        base_(roadmap),
        draft_(&roadmap),
        sites_(stances, draft_, Sites::Check::kWhenUsed),
        rails_(checker, draft_, sites_) {}

  std::optional<Attached> attach(const Request& request, Effort effort, Interrupt& interrupt) {
    End start{End::Side::kStart, request.start_mode, request.start, true};
    start.place = sites_.add(start.mode, start.pose.position(), keepOf(start));
    std::vector<End> goals;
    for (const Goal& goal : goalsOf(request)) goals.push_back(endAt(goal, start));
    if (!connect(start, effort, interrupt)) return std::nullopt;
    for (const End& goal : goals)
      if (!connect(goal, effort, interrupt)) return std::nullopt;
    Target target{start.place, {start.pose.yaw, start.mode}, {}};
    for (const End& goal : goals) {
      join(start, goal);
      const auto index = static_cast<std::uint32_t>(target.goals.size());
      target.goals.push_back({goal.place, {goal.pose.yaw, goal.mode}, !goal.has_heading, index});
    }
    return Attached{std::move(draft_), std::move(target)};
  }

 private:
  /// False if interrupted.
  [[nodiscard]] bool connect(const End& end, Effort effort, Interrupt& interrupt) {
    connectToRoadmap(end.place, effort == Effort::kNearest ? kNeighbours : kAllNeighbours);
    leaveTightPlace(end);
    followLine(end);
    changeMode(end);
    if (effort == Effort::kLocalRoadmap) addLocalRoadmap(end, interrupt);
    return !interrupt.isDueNow();
  }

  End endAt(const Goal& asked, const End& start) {
    End goal{End::Side::kGoal,
             asked.mode,
             {asked.at.x, asked.at.y, asked.yaw.value_or(0.0)},
             asked.yaw.has_value()};
    if (const auto ahead = goalOnLineOf(start, goal)) {
      goal.pose = *ahead;
      goal.has_heading = true;
    }
    const bool is_here = distance(start.pose.position(), goal.pose.position()) < kSamePlace_m &&
                         stances_.groupOf(start.mode) == stances_.groupOf(goal.mode);
    if (is_here) {
      goal.place = start.place;
      draft_.keepLess(goal.place, keepOf(goal));
    } else {
      goal.place = sites_.add(goal.mode, goal.pose.position(), keepOf(goal));
    }
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
      const double way = std::max(0.0, std::cos(direction) * (goal.pose.x - start.pose.x) +
                                           std::sin(direction) * (goal.pose.y - start.pose.y));
      if (!mode.canMove(sense)) continue;
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

  void connectToRoadmap(PlaceId place, std::size_t most) {
    const GroupId group = draft_.place(place).group;
    if (stances_.ofGroup(group).ways().empty()) return;
    std::vector<PlaceId> neighbours = base_.main_index.nearest(group, draft_.place(place).at, most);
    if (base_.main_index.size() < base_.index.size())
      for (const PlaceId other : base_.index.nearest(group, draft_.place(place).at, most))
        if (std::find(neighbours.begin(), neighbours.end(), other) == neighbours.end())
          neighbours.push_back(other);
    for (const PlaceId neighbour : neighbours) sites_.connect(place, neighbour);
  }

  void connectToRoadmap(const std::vector<PlaceId>& places, std::size_t most) {
    for (const PlaceId place : places) connectToRoadmap(place, most);
  }

  /// A grid in the end's own frame, joined along its rows and columns at the end's heading, as one parks a
  /// car, and connected to the roadmap all over.
  void addLocalRoadmap(const End& end, Interrupt& interrupt) {
    if (!robot_.modes[end.mode].canTurn()) return;
    constexpr std::size_t kCount = kGrid_m.size();
    std::vector<PlaceId> grid;
    for (const double y : kGrid_m) {
      if (interrupt.isDueNow()) return;
      for (const double x : kGrid_m) {
        const bool is_end = x == 0.0 && y == 0.0;
        grid.push_back(is_end ? end.place
                              : sites_.add(end.mode, transform(end.pose, {x, y}), robot_.margin_m));
        if (!is_end) connectToRoadmap(grid.back(), kNeighboursOfHelpers);
      }
    }
    for (std::size_t i = 0; i < grid.size(); ++i) {
      if (i % kCount + 1 < kCount) sites_.connect(grid[i], grid[i + 1]);
      if (i + kCount < grid.size()) sites_.connect(grid[i], grid[i + kCount]);
    }
  }

  /// Where the body cannot turn, legs at other headings fail: go straight first.
  void leaveTightPlace(const End& end) {
    if (!end.has_heading) return;
    if (stances_.ofMode(end.mode).turnsFreely(end.pose.position(), robot_.margin_m)) return;
    for (const Way& way : stances_.ofMode(end.mode).ways())
      connectToRoadmap(rails_.addWayOut(end.place, way.mode, way.sense, end.pose), kNeighboursOfHelpers);
  }

  /// A mode that cannot turn leaves a start ahead and comes to a goal from behind.
  void followLine(const End& end) {
    if (robot_.modes[end.mode].canTurn()) return;
    for (const Pose& pose : posesOf(end)) followLine(end, end.mode, pose, {});
  }

  /// `beside`: the motions between the end's pose and the line.
  void followLine(const End& end, ModeId mode, const Pose& pose, const Route& beside) {
    for (const Sense sense : kSenses) {
      if (!robot_.modes[mode].canMove(sense)) continue;
      connectToRoadmap(end.side == End::Side::kStart
                           ? rails_.addExits(end.place, mode, sense, pose, beside)
                           : rails_.addEntries(end.place, mode, sense, pose, beside),
                       kNeighboursOfHelpers);
    }
  }

  /// Switches out of the start's mode right there, and into the goal's; those between companions need none of
  /// this. A goal that leaves its heading open needs it only if its mode cannot turn: else it turns to where
  /// a switch is.
  void changeMode(const End& end) {
    if (!end.has_heading && robot_.modes[end.mode].canTurn()) return;
    for (const Switch& change : robot_.switches) {
      const bool is_start = end.side == End::Side::kStart;
      const GroupId group = stances_.groupOf(end.mode);
      if (stances_.groupOf(is_start ? change.from : change.to) != group) continue;
      if (stances_.groupOf(is_start ? change.to : change.from) == group) continue;
      for (const Pose& pose : posesOf(end)) changeMode(end, pose, change);
    }
  }

  void changeMode(const End& end, const Pose& pose, const Switch& change) {
    const bool is_start = end.side == End::Side::kStart;
    const double keep = draft_.place(end.place).keep_m;
    const Pose other = is_start ? compose(pose, change.displacement) : before(pose, change.displacement);
    Motion motion = switchModes(change, is_start ? pose : other);
    if (!is_start) motion.to = pose;
    if (!isFreeKeeping(checker_, motion, keep)) return;
    const ModeId other_mode = is_start ? change.to : change.from;
    if (!robot_.modes[other_mode].canTurn()) {
      followLine(end, other_mode, other, {motion});
      return;
    }
    const bool is_here = other.position() == pose.position();
    const PlaceId place = sites_.add(other_mode, other.position(), is_here ? keep : robot_.margin_m);
    draft_.addCrossing(is_start ? end.place : place, is_start ? place : end.place,
                       Crossing(robot_, {motion}));
    connectToRoadmap(place, kNeighboursOfHelpers);
  }

  /// Straight from start to goal.
  void join(const End& start, const End& goal) {
    if (start.place == goal.place || stances_.groupOf(start.mode) != stances_.groupOf(goal.mode)) return;
    if (robot_.modes[start.mode].canTurn()) {
      sites_.connect(start.place, goal.place);
      return;
    }
    const double way = distance(start.pose.position(), goal.pose.position());
    for (const Sense sense : kSenses) {  // without turning: only if the goal lies on the start's line
      Motion ahead = translate(start.mode, sense, start.pose, way);
      if (!robot_.modes[start.mode].canMove(sense) || !goal.has_heading || goal.pose.yaw != start.pose.yaw ||
          distance(ahead.to.position(), goal.pose.position()) >= 1e-10)
        continue;
      ahead.to = goal.pose;
      const double keep_m = std::min(draft_.place(start.place).keep_m, draft_.place(goal.place).keep_m);
      if (isFreeKeeping(checker_, ahead, keep_m))
        draft_.addCrossing(start.place, goal.place, Crossing(robot_, {ahead}));
    }
  }

  const Checker& checker_;
  const Robot& robot_;
  const Stances& stances_;
  const Roadmap& base_;
  Draft draft_;
  Sites sites_;
  Rails rails_;
};

}  // namespace

std::optional<Attached> attach(const Checker& checker, const Stances& stances, const Roadmap& roadmap,
                               const Request& request, Effort effort, Interrupt& interrupt) {
  return Attachment(checker, stances, roadmap).attach(request, effort, interrupt);
}

}  // namespace underway
