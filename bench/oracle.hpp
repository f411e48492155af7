#pragma once

#include <map>
#include <memory>
#include <vector>

#include "bench/oracle/flood.hpp"
#include "bench/oracle/refine.hpp"
#include "planner/plan.hpp"

namespace underway::bench {

struct OracleSettings {
  double cell_m = 0.025;            ///< of the lattice
  int headings = 64;                ///< of the lattice, up to 64
  bool has_bridges = true;          ///< whether it may change gaits: no use among walls of full height
  RefineSettings refine;            ///< of the shortcuts
  double clearance_step_m = 0.005;  ///< to which kSafest finds the largest clearance
};

/// For rooms: 2.5 cm, 64 headings.
[[nodiscard]] OracleSettings roomOracle();
/// For buildings: 5 cm, 32 headings, no change of gaits.
[[nodiscard]] OracleSettings buildingOracle();

/// What a plan costs at best, or nearly: a dense lattice searched by Dijkstra, all moves checked exactly, and
/// then shortcuts, exhaustively. Far too slow to plan with; what plans are held against. Its answers are
/// plans: chained, free and certified like any other. It knows nothing of how the planner works.
///
/// Robots of any modes. What it leaves out: two changes between modes that do not turn without one that turns
/// in between. For one thread.
class Oracle {
 public:
  /// The checker must outlive it.
  Oracle(const Checker& checker, const OracleSettings& settings);

  /// The best routes from one start to many goals. `requests` have the same start, start mode and policy;
  /// kSafest one request only. A route that is empty says that none was found; after `most` that are not it
  /// stops. Detours are not limited.
  [[nodiscard]] std::vector<Route> routes(const std::vector<Request>& requests, const Progress& progress = {},
                                          std::size_t most = ~std::size_t{0});
  /// The best route, found from the lattice alone: empty if none is.
  [[nodiscard]] Route route(const Request& request, const Progress& progress = {});
  /// The same, shortened from a route somebody else found, if that makes a better one. `route` may be empty.
  [[nodiscard]] Route better(const Request& request, const Route& route, double margin_m) const;

  /// The largest margin for which there is a route, in steps from the robot's own up to kEnoughClearance_m;
  /// negative if there is none. What start or goal lack themselves does not count.
  [[nodiscard]] double largestMargin(const Request& request);
  /// The fastest route that keeps a margin [m].
  [[nodiscard]] Route routeKeeping(const Request& request, double margin_m);

 private:
  Lattice& lattice(Policy policy, double margin_m);

  const Checker& checker_;
  OracleSettings settings_;
  std::map<std::pair<Policy, long>, std::unique_ptr<Lattice>> lattices_;  // by margin in um
};

/// How many times a plan's cost is the oracle's, under a policy: for kPriority the ratio of the first number
/// (distance in the last mode, ..., time) in which the two differ by more than a centimetre, or of the times.
/// Infinite if the oracle pays nothing there.
[[nodiscard]] double costRatio(const Robot& robot, Policy policy, const Route& plan, const Route& oracle);

/// The motions of a plan.
[[nodiscard]] Route motionsOf(const Plan& plan);

}  // namespace underway::bench
