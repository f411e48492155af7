#include "planner/shorten.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "planner/corridor.hpp"
#include "planner/movable.hpp"

namespace underway {
namespace {

/// By how much stops and crossings are moved, round by round, and how often a round is repeated while it
/// helps.
constexpr std::array kSteps_m{0.3, 0.1, 0.03, 0.01};
constexpr int kRepeats = 3;
constexpr std::size_t kReach = 6;  // stations ahead that legs lead to, when stops are to be left out
constexpr std::size_t kStopsRound = 8;
constexpr double kCoarse_m = 0.05;   // smaller steps only move what is there, and move it by the ways it has
constexpr double kNearCorner = 1.6;  // steps from a stop to where its corner may be cut

/// A route divided into stops and crossings, and improved as a whole.
class Shortening {
 public:
  Shortening(const Checker& checker, const Stances& stances, Passage passage, const Keeping& keeping)
      : checker_(checker),
        robot_(checker.robot()),
        stances_(stances),
        keeping_(keeping),
        passage_(std::move(passage)) {}

  Passage best(Interrupt& interrupt) {
    // Only so many stations are left out at a time, so again until none is.
    while (improve(withStopsLeftOut(), interrupt)) continue;
    for (const double step_m : kSteps_m) {
      for (int i = 0; i < kRepeats && improve(withMoves(step_m, i > 0), interrupt); ++i) continue;
      improve(withStopsLeftOut(), interrupt);
    }
    return std::move(passage_);
  }

 private:
  bool improve(const Corridor& corridor, Interrupt& interrupt) {
    auto better = cheapestThrough(corridor, passage_.cost, interrupt);
    if (!better) return false;
    passage_ = std::move(*better);
    return true;
  }

  [[nodiscard]] Option optionOf(const Movable& crossing) const {
    return {crossing.entry(),
            crossing.exit(),
            crossing.motions().front().mode,
            crossing.motions().back().to_mode,
            false,
            false,
            robot_.margin_m,
            crossing.motions(),
            crossing.cost()};
  }

  // --- corridors round the passage ------------------------------------------------------------------------

  /// The passage itself, of which stops may be left out.
  [[nodiscard]] Corridor withStopsLeftOut() const {
    Corridor corridor;
    for (const Passage::Step& step : passage_.steps) {
      Station station;
      station.options = {step.option};
      station.may_be_skipped = step.option.is_stop;
      station.reach = kReach;
      station.legs_on = &stances_.ofMode(step.leaving.mode);
      corridor.push_back(std::move(station));
    }
    return corridor;
  }

  /// Stops and crossings moved by a step; if that is coarse, also stops added. `is_repeat`: legs keep their
  /// modes and senses, and only what moved last time, or has a neighbour that did, is moved again.
  [[nodiscard]] Corridor withMoves(double step_m, bool is_repeat) const {
    const bool is_coarse = step_m >= kCoarse_m;
    Corridor corridor;
    for (std::size_t i = 0; i < passage_.steps.size(); ++i) {
      const Passage::Step& step = passage_.steps[i];
      const bool is_settled = is_repeat && !isNewNear(i);
      const bool keeps_way = step.way && (is_repeat || !is_coarse);
      const std::uint32_t ways_to = keeps_way ? 1U << *step.way : ~0U;
      const bool is_leg_settled = is_settled && !isNewNear(i - 1);
      if (step.way && is_coarse && !is_leg_settled) addBetween(i, step_m, ways_to, corridor);
      Station station;
      station.options = {step.option};
      station.reach = is_coarse ? 2 : 1;
      station.legs_on = &stances_.ofMode(step.leaving.mode);
      station.ways_to = ways_to;
      const bool is_end = i == 0 || i + 1 == passage_.steps.size();
      if (!is_settled && step.option.is_stop) addStopsRound(step.option, step_m, station);
      if (!is_settled && !is_end && !step.option.is_stop) addCrossingsBeside(i, step_m, station);
      corridor.push_back(std::move(station));
    }
    return corridor;
  }

  [[nodiscard]] bool isNewNear(std::size_t i) const {
    const auto is_new = [&](std::size_t k) { return k < passage_.steps.size() && passage_.steps[k].is_new; };
    return is_new(i) || is_new(i + 1) || (i > 0 && is_new(i - 1));
  }

  void addStopsRound(const Option& stop, double step_m, Station& station) const {
    for (std::size_t i = 0; i < kStopsRound; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kStopsRound;
      station.options.push_back(Option::stop(
          {stop.in.x + step_m * std::cos(angle), stop.in.y + step_m * std::sin(angle)}, robot_.margin_m));
    }
  }

  void addCrossingsBeside(std::size_t i, double step_m, Station& station) const {
    const bool is_start =
        i == 1 && passage_.steps[0].option.out == station.options[0].in && !passage_.steps[1].way;
    const bool is_goal = i + 2 == passage_.steps.size() &&
                         passage_.steps.back().option.in == station.options[0].out &&
                         !passage_.steps.back().way;
    const Option& here = station.options[0];
    Movable::Rules rules{
        &checker_, stances_.policy(), stances_.atLeast(), keeping_.start_m, keeping_.goal_m, false, false};
    rules.is_start = is_start && !robot_.modes[here.in_mode].canTurn();
    rules.is_goal = is_goal && !robot_.modes[here.out_mode].canTurn();
    const Movable crossing(rules, here.motions);
    for (const Movable::Move move : Movable::kMoves) {
      const auto moved = crossing.moved(move, step_m);
      if (moved && moved->isFree()) station.options.push_back(optionOf(*moved));
    }
  }

  /// Stops between two: near either, to cut its corner, and where a leg needs no turn at its other end.
  void addBetween(std::size_t i, double step_m, std::uint32_t ways_to, Corridor& corridor) const {
    const Passage::Step& a = passage_.steps[i - 1];
    const Passage::Step& b = passage_.steps[i];
    const Point from = a.option.out.position();
    const Point to = b.option.in.position();
    const double way_m = distance(from, to);
    Station station;
    station.may_be_skipped = true;
    station.reach = 2;
    station.legs_on = &stances_.ofMode(a.leaving.mode);
    station.ways_to = ways_to;
    station.is_new = true;
    const auto add = [&](Point at) {
      if (distance(from, at) > 1e-6 && distance(at, to) > 1e-6)
        station.options.push_back(Option::stop(at, robot_.margin_m));
    };
    const double away = kNearCorner * step_m / way_m;
    if (away < 0.4) {
      add({from.x + away * (to.x - from.x), from.y + away * (to.y - from.y)});
      add({to.x + away * (from.x - to.x), to.y + away * (from.y - to.y)});
    }
    const double before = i >= 2 && passage_.steps[i - 1].way ? a.arriving.yaw : a.leaving.yaw;
    const double after = i + 1 < passage_.steps.size() && passage_.steps[i + 1].way
                             ? passage_.steps[i + 1].arriving.yaw
                             : b.option.in.yaw;
    for (const double quarter : {0.0, 0.5 * std::numbers::pi}) {
      add(ahead(from, before + quarter, to));
      if (!b.option.any_heading || b.option.is_stop) add(ahead(to, after + quarter, from));
    }
    if (!station.options.empty()) corridor.push_back(std::move(station));
  }

  /// Where the line through a point along a heading comes closest to another.
  [[nodiscard]] static Point ahead(Point from, double heading_rad, Point to) {
    const Point axis{std::cos(heading_rad), std::sin(heading_rad)};
    const double way = (to.x - from.x) * axis.x + (to.y - from.y) * axis.y;
    return {from.x + way * axis.x, from.y + way * axis.y};
  }

  const Checker& checker_;
  const Robot& robot_;
  const Stances& stances_;
  Keeping keeping_;
  Passage passage_;
};

}  // namespace

Passage shortened(const Checker& checker, const Stances& stances, Passage passage, const Keeping& keeping,
                  Interrupt& interrupt) {
  return Shortening(checker, stances, std::move(passage), keeping).best(interrupt);
}

}  // namespace underway
