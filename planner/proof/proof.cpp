#include "planner/proof/proof.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/sweep.hpp"
#include "planner/proof/way.hpp"

namespace underway {
namespace {

constexpr double kGoal_m = 0.01;  // how near the goal a plan may end (formats: 'Plan')
constexpr double kGoal_rad = 0.02;
constexpr double kFinest_m = 1e-4;  // what is still undecided in smaller cells stays so
constexpr double kSwitch_m = 5e-3;  // where a switch leads to is not told more exactly than this
constexpr double kRounding_m = 1e-6;
constexpr std::size_t kMostCells = 100'000;
constexpr int kRounds = 3;  // of halving between two looks for a way

/// What is undecided where a way passes a cell: the switch it makes there, or the body; null if nothing is.
const Outlook* undecidedAt(const Relaxation& relaxation, const Step& step) {
  const auto is_undecided = [](const Outlook& o) { return o.state == Outlook::State::kUndecided; };
  if (step.exit && is_undecided(relaxation.ofExit(step.place, *step.exit)))
    return &relaxation.ofExit(step.place, *step.exit);
  return is_undecided(relaxation.ofBody(step.place)) ? &relaxation.ofBody(step.place) : nullptr;
}

/// Halves a cell some times over, as far as it is undecided; whether it was.
bool splitUndecided(Relaxation& relaxation, const Step& step, int rounds, Interrupt& interrupt) {
  const Outlook* undecided = undecidedAt(relaxation, step);
  if (undecided == nullptr || rounds == 0 || relaxation.extentOf(step.place) < kFinest_m) return false;
  if (!relaxation.canSplit(step.place, undecided->axis) || interrupt.isDue()) return false;
  const CellId upper = relaxation.split(step.place, undecided->axis, interrupt);
  splitUndecided(relaxation, step, rounds - 1, interrupt);
  splitUndecided(relaxation, {{step.place.stance, upper}, step.exit}, rounds - 1, interrupt);
  return true;
}

/// The same for all cells on a way.
bool splitUndecided(Relaxation& relaxation, const Way& way, Interrupt& interrupt) {
  bool has_split = false;
  for (const Step& step : way) has_split |= splitUndecided(relaxation, step, kRounds, interrupt);
  return has_split;
}

/// Halves the cells in which the way switches, so that it is told more exactly where to.
bool splitSwitching(Relaxation& relaxation, const Way& way, Interrupt& interrupt) {
  bool has_split = false;
  for (const Step& step : way) {
    const std::size_t axis = relaxation.longestAxis(step.place);
    if (!step.exit || relaxation.extentOf(step.place) < kSwitch_m || !relaxation.canSplit(step.place, axis))
      continue;
    relaxation.split(step.place, axis, interrupt);
    has_split = true;
  }
  return has_split;
}

/// What all poses within the tolerance of the goal have at least.
double leastClearanceAtGoal(const Checker& checker, const Request& request) {
  const double reach = reachOf(checker.robot().modes[request.goal_mode].body_m);
  const double cap = checker.robot().margin_m + kGoal_m + 0.1 * reach;
  const auto clearance = [&](double yaw, double within_rad) {
    const Pose pose{request.goal.x, request.goal.y, yaw};
    return checker.closeness(stay(request.goal_mode, pose), cap).clearance_m - kGoal_m - within_rad * reach;
  };
  if (request.goal_yaw) return clearance(*request.goal_yaw, kGoal_rad);
  constexpr int kHeadings = 72;
  constexpr double kStep_rad = 2.0 * std::numbers::pi / kHeadings;
  double least = cap;
  for (int i = 0; i < kHeadings; ++i) least = std::min(least, clearance(kStep_rad * i, 0.5 * kStep_rad));
  return least;
}

}  // namespace

double leastMargin(const Checker& checker, const Request& request) {
  const double margin = checker.robot().margin_m;
  const double at_start = checker.closeness(stay(request.start_mode, request.start), margin).clearance_m;
  const double least = std::min(at_start, leastClearanceAtGoal(checker, request)) - kRounding_m;
  return std::clamp(least, 0.0, margin);
}

bool closes(Relaxation& relaxation, std::size_t most_cells, Interrupt& interrupt) {
  WaySearch search;
  while (!interrupt.isDueNow() && relaxation.size() < most_cells) {
    const auto way = search.throughOpenCells(relaxation, interrupt);
    if (!way) return !interrupt.isDueNow();
    if (!splitUndecided(relaxation, *way, interrupt) && !splitSwitching(relaxation, *way, interrupt))
      return false;
  }
  return false;
}

std::optional<Proof> proveNoPath(const Checker& checker, const Request& request, Interrupt& interrupt) {
  Relaxation relaxation(checker, request, leastMargin(checker, request), interrupt);
  if (!closes(relaxation, kMostCells, interrupt)) return std::nullopt;
  return Proof{std::move(relaxation)};
}

}  // namespace underway
