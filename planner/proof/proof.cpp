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

/// Halves the undecided cells on a way; whether there was any.
bool splitUndecided(Relaxation& relaxation, const std::vector<Step>& way, Interrupt& interrupt) {
  bool has_split = false;
  for (const Step& step : way) {
    if (relaxation.extentOf(step.place) < kFinest_m) continue;
    const Outlook& body = relaxation.ofBody(step.place);
    const Outlook* undecided = body.state == Outlook::State::kUndecided ? &body : nullptr;
    if (step.exit) {
      const Outlook& change = relaxation.ofExit(step.place, *step.exit);
      if (change.state == Outlook::State::kUndecided) undecided = &change;
    }
    if (undecided == nullptr || !relaxation.canSplit(step.place, undecided->axis)) continue;
    relaxation.split(step.place, undecided->axis, interrupt);
    has_split = true;
  }
  return has_split;
}

/// Halves the cells in which the way switches, so that it is told more exactly where to.
bool splitSwitching(Relaxation& relaxation, const std::vector<Step>& way, Interrupt& interrupt) {
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

bool closes(Relaxation& relaxation, Interrupt& interrupt) {
  while (!interrupt.isDueNow()) {
    const auto way = findWay(relaxation, interrupt);
    if (!way) return !interrupt.isDueNow();
    if (!splitUndecided(relaxation, *way, interrupt) && !splitSwitching(relaxation, *way, interrupt))
      return false;
  }
  return false;
}

std::optional<Proof> proveNoPath(const Checker& checker, const Request& request, Interrupt& interrupt) {
  Relaxation relaxation(checker, request, leastMargin(checker, request), interrupt);
  if (!closes(relaxation, interrupt)) return std::nullopt;
  return Proof{std::move(relaxation)};
}

}  // namespace underway
