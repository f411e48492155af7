#include "bench/oracle.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "bench/oracle/ends.hpp"

namespace underway::bench {
namespace {

/// A policy's cost on the lattice and of shortcuts: kSafest is fastest with a larger margin.
Policy searchedPolicy(Policy policy) { return policy == Policy::kSafest ? Policy::kFastest : policy; }

/// Metres moved in each mode, and seconds.
struct Spent {
  std::array<double, kMaxModes> moved_m{};
  double time_s = 0.0;
};

Spent spentOn(const Robot& robot, const Route& route) {
  Spent spent;
  for (const Motion& motion : route) {
    spent.moved_m.at(motion.mode) += length(motion);
    spent.time_s += duration(robot, motion);
  }
  return spent;
}

/// The cheapest way over the lattice to a request's goal; empty if there is none.
Route onLattice(const Lattice& lattice, const Flood& flood, const Keep& keep, const Request& request) {
  const auto ways = waysToGoal(lattice, keep, request);
  const Spur* best = flood.best(ways);
  if (best == nullptr) return {};
  Route route = flood.route(best->node);
  route.insert(route.end(), best->route.begin(), best->route.end());
  return route;
}

}  // namespace

OracleSettings roomOracle() { return {}; }

OracleSettings buildingOracle() {
  OracleSettings settings;
  settings.cell_m = 0.05;
  settings.headings = 32;
  settings.has_bridges = false;
  settings.refine.rounds = 24;
  return settings;
}

Oracle::Oracle(const Checker& checker, const OracleSettings& settings)
    : checker_(checker), settings_(settings) {}

Lattice& Oracle::lattice(Policy policy, double margin_m) {
  auto& lattice = lattices_[{policy, std::lround(margin_m * 1e6)}];
  if (!lattice)
    lattice = std::make_unique<Lattice>(checker_, LatticeSettings{settings_.cell_m, settings_.headings,
                                                                  margin_m, policy, settings_.has_bridges});
  return *lattice;
}

std::vector<Route> Oracle::routes(const std::vector<Request>& requests, const Progress& progress,
                                  std::size_t most) {
  std::vector<Route> routes;
  if (requests.empty()) return routes;
  const Policy policy = searchedPolicy(requests.front().policy);
  const double margin_m = checker_.robot().margin_m;
  Lattice& searched = lattice(policy, margin_m);
  const Keep at_start(checker_, requests.front(), margin_m);
  // One goal ends the search when it is reached; many would each have to be watched for.
  const auto goals =
      requests.size() == 1 ? waysToGoal(searched, at_start, requests.front()) : std::vector<Spur>();
  const Flood flood(searched, waysFromStart(searched, at_start, requests.front()), progress, goals);
  for (const Request& request : requests) {
    const Keep keep(checker_, request, margin_m);
    routes.push_back(better(request, onLattice(searched, flood, keep, request), margin_m));
    if (!routes.back().empty() && --most == 0) break;
  }
  return routes;
}

Route Oracle::route(const Request& request, const Progress& progress) {
  if (request.policy != Policy::kSafest) return routes({request}, progress).front();
  const double margin_m = largestMargin(request);
  return margin_m < 0.0 ? Route{} : routeKeeping(request, margin_m);
}

Route Oracle::better(const Request& request, const Route& route, double margin_m) const {
  if (route.empty()) return route;
  const Policy policy = searchedPolicy(request.policy);
  const Gaits gaits = gaitsOf(checker_.robot(), policy);
  const Keep keep(checker_, request, margin_m);
  return refined({checker_, keep, gaits, policy}, request, route, settings_.refine);
}

Route Oracle::routeKeeping(const Request& request, double margin_m) {
  Lattice& searched = lattice(Policy::kFastest, margin_m);
  const Keep keep(checker_, request, margin_m);
  const Flood flood(searched, waysFromStart(searched, keep, request), {},
                    waysToGoal(searched, keep, request));
  return better(request, onLattice(searched, flood, keep, request), margin_m);
}

double Oracle::largestMargin(const Request& request) {
  const double least_m = checker_.robot().margin_m;
  const auto reaches = [&](int step) {
    const double margin_m = std::min(kEnoughClearance_m, least_m + step * settings_.clearance_step_m);
    Lattice& searched = lattice(Policy::kFastest, margin_m);
    const Keep keep(checker_, request, margin_m);
    const auto goals = waysToGoal(searched, keep, request);
    return !goals.empty() &&
           Flood(searched, waysFromStart(searched, keep, request), {}, goals).best(goals) != nullptr;
  };
  int lacks = 1 + static_cast<int>(std::ceil((kEnoughClearance_m - least_m) / settings_.clearance_step_m));
  if (reaches(lacks - 1)) return kEnoughClearance_m;
  int has = -1;
  for (--lacks; lacks - has > 1;) {
    const int middle = (has + lacks) / 2;
    (reaches(middle) ? has : lacks) = middle;
  }
  return has < 0 ? -1.0 : least_m + has * settings_.clearance_step_m;
}

double costRatio(const Robot& robot, Policy policy, const Route& plan, const Route& oracle) {
  constexpr double kSame_m = 0.01;
  const Spent own = spentOn(robot, plan);
  const Spent best = spentOn(robot, oracle);
  if (policy == Policy::kPriority)
    for (std::size_t mode = robot.modes.size(); mode-- > 1;)
      if (std::abs(own.moved_m.at(mode) - best.moved_m.at(mode)) > kSame_m)
        return best.moved_m.at(mode) > 0.0 ? own.moved_m.at(mode) / best.moved_m.at(mode)
                                           : std::numeric_limits<double>::infinity();
  return own.time_s / best.time_s;
}

Route motionsOf(const Plan& plan) {
  Route route;
  for (const Segment& segment : plan.segments) route.push_back(segment.motion);
  return route;
}

}  // namespace underway::bench
