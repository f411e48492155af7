#include "planner/proof/proof.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/sweep.hpp"
#include "planner/proof/way.hpp"

namespace underway::proof {
namespace {

constexpr double kGoal_m = 0.01;  // how near the goal a plan may end (formats: 'Plan')
constexpr double kGoal_rad = 0.02;
constexpr double kFinest_m = 1e-4;  // what is still undecided in smaller cells stays so
constexpr double kSwitch_m = 5e-3;  // where a switch leads to is not told more exactly than this
constexpr double kRounding_m = 1e-6;
// Than it was at first may a way become before others are looked for: a cell costs by the square of how small
// it is, so this is five halvings.
constexpr double kCostlier = 1000.0;
constexpr std::size_t kMostCells = 100'000;

/// What is undecided where a way passes a cell: the switch it makes there, or the body; null if nothing is.
const Outlook* undecidedAt(const Relaxation& relaxation, const Step& step) {
  const auto is_undecided = [](const Outlook& o) { return o.state == Outlook::State::kUndecided; };
  if (step.exit && is_undecided(relaxation.ofExit(step.place, *step.exit)))
    return &relaxation.ofExit(step.place, *step.exit);
  return is_undecided(relaxation.ofBody(step.place)) ? &relaxation.ofBody(step.place) : nullptr;
}

/// Refines a relaxation along one way after the other.
class Refinement {
 public:
  Refinement(Relaxation& relaxation, std::size_t most_cells, Interrupt& interrupt)
      : relaxation_(relaxation), most_cells_(most_cells), interrupt_(interrupt) {}

  /// Whether no way is left.
  bool run() {
    while (mayGoOn()) {
      search_.goAnywhere();
      const auto way = search_.throughOpenCells(relaxation_, interrupt_);
      if (!way) return !interrupt_.isDueNow();
      if (!refine(*way)) return false;
    }
    return false;
  }

 private:
  [[nodiscard]] bool mayGoOn() { return !interrupt_.isDueNow() && relaxation_.size() < most_cells_; }

  /// Halves the cells of a way, and of what ways remain in and beside its cells, until there is none or
  /// others may be less costly to look at. False if there is one on which nothing more can be told.
  bool refine(Way way) {
    const double most = kCostlier * way.cost;
    search_.confineTo(relaxation_, way);
    search_.letBeside(relaxation_, way);
    while (mayGoOn()) {
      if (!splitUndecided(way) && !splitSwitching(way)) return false;
      auto remains = search_.throughOpenCells(relaxation_, interrupt_);
      if (!remains || remains->cost > most) return true;
      way = std::move(*remains);
    }
    return true;
  }

  void split(const Relaxation::Place& place, std::size_t axis) {
    search_.noteHalves(place, relaxation_.split(place, axis, interrupt_));
  }

  /// Halves the undecided cells on a way; whether there was any.
  bool splitUndecided(const Way& way) {
    bool has_split = false;
    for (const Step& step : way.steps) {
      const Outlook* undecided = undecidedAt(relaxation_, step);
      if (undecided == nullptr || relaxation_.extentOf(step.place) < kFinest_m ||
          !relaxation_.canSplit(step.place, undecided->axis) || interrupt_.isDue())
        continue;
      split(step.place, undecided->axis);
      has_split = true;
    }
    return has_split;
  }

  /// Halves the cells in which the way switches, so that it is told more exactly where to.
  bool splitSwitching(const Way& way) {
    bool has_split = false;
    for (const Step& step : way.steps) {
      const std::size_t axis = relaxation_.longestAxis(step.place);
      if (!step.exit || relaxation_.extentOf(step.place) < kSwitch_m ||
          !relaxation_.canSplit(step.place, axis))
        continue;
      split(step.place, axis);
      has_split = true;
    }
    return has_split;
  }

  Relaxation& relaxation_;
  std::size_t most_cells_;
  Interrupt& interrupt_;
  WaySearch search_;
};

/// What all poses within the tolerance of a goal have at least.
double leastClearanceAt(const Goal& goal, const Checker& checker, Interrupt& interrupt) {
  const double reach = reachOf(checker.robot().modes[goal.mode].body_m);
  const double cap = checker.robot().margin_m + kGoal_m + 0.1 * reach;
  const auto clearance = [&](double yaw, double within_rad) {
    const Pose pose{goal.at.x, goal.at.y, yaw};
    return checker.clearance(stay(goal.mode, pose), cap) - kGoal_m - within_rad * reach;
  };
  if (goal.yaw) return clearance(*goal.yaw, kGoal_rad);
  constexpr int kHeadings = 72;
  constexpr double kStep_rad = 2.0 * std::numbers::pi / kHeadings;
  double least = cap;
  for (int i = 0; i < kHeadings && !interrupt.isDueNow(); ++i)
    least = std::min(least, clearance(kStep_rad * i, 0.5 * kStep_rad));
  return least;
}

}  // namespace

double leastMargin(const Checker& checker, const Request& request, Interrupt& interrupt) {
  const double margin = checker.robot().margin_m;
  double least = checker.clearance(stay(request.start_mode, request.start), margin);
  for (const Goal& goal : goalsOf(request))
    least = std::min(least, leastClearanceAt(goal, checker, interrupt));
  return std::clamp(least - kRounding_m, 0.0, margin);
}

bool closes(Relaxation& relaxation, std::size_t most_cells, Interrupt& interrupt) {
  return Refinement(relaxation, most_cells, interrupt).run();
}

std::optional<Proof> proveNoPath(const Checker& checker, const Request& request, Interrupt& interrupt) {
  Relaxation relaxation(checker, request, leastMargin(checker, request, interrupt), interrupt);
  if (!closes(relaxation, kMostCells, interrupt)) return std::nullopt;
  return Proof{std::move(relaxation)};
}

}  // namespace underway::proof
