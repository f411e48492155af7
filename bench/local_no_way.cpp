#include "bench/local_no_way.hpp"

#include "bench/oracle.hpp"
#include "planner/planner.hpp"

namespace underway::bench {
namespace {

constexpr std::chrono::seconds kSearch{60};

/// Whether the oracle, which shares nothing with the planner but the checker, finds a way on its lattice.
bool isWayOnLattice(const std::shared_ptr<const World>& world, const std::shared_ptr<const Robot>& robot,
                    const Request& request) {
  OracleSettings settings = roomOracle();
  settings.refine.rounds = 0;  // any way will do
  const Checker checker(world, robot);
  return !Oracle(checker, settings).route(request).empty();
}

}  // namespace

NoWay noWay(const std::shared_ptr<const World>& world, const std::shared_ptr<const Robot>& robot,
            Request request) {
  request.policy = Policy::kFastest;
  const auto plan = Planner(world, robot).plan(request, Planner::Clock::now() + kSearch);
  if (plan) return NoWay::kFalse;
  if (plan.error().code == ErrorCode::kNoPathExists) return NoWay::kProven;
  return isWayOnLattice(world, robot, request) ? NoWay::kFalse : NoWay::kNotFound;
}

}  // namespace underway::bench
