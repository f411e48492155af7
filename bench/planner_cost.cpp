#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "bench/oracle.hpp"
#include "bench/oracle/chain.hpp"
#include "bench/planner_parts.hpp"
#include "bench/random_requests.hpp"

namespace underway::bench {
namespace {

constexpr std::array kRooms{"scenario2a", "scenario3", "office",         "scenario1",
                            "scenario2b", "arena_gap", "arena_corridor", "flat"};
constexpr std::size_t kQuickRooms = 2;
constexpr unsigned long kSeed = 1;
constexpr std::chrono::seconds kDeadline{10};
constexpr double kDenser = 8.0;  // roadmap with which the planner helps the oracle

struct Share {
  std::size_t starts;
  std::size_t goals;
};

/// What the plans of one policy cost, times the oracle's.
struct Costs {
  std::vector<double> ratios;
  std::size_t asked = 0;
  std::size_t unanswered = 0;  // though the oracle knows a way
  std::size_t better = 0;      // than the oracle by more than rounding: how far it is to be trusted
  double most_better = 1.0;
};

/// The planner, and another of its kind that has much longer.
class Contest {
 public:
  Contest(const std::shared_ptr<const World>& world, const std::shared_ptr<const Robot>& robot, double own_s)
      : planner_(preparedPlanner(world, robot)), oracle_(*planner_->checker(), roomOracle()) {
    if (own_s <= 0.0) return;
    const GrowthSettings denser{kSeed + 1, kDenser * GrowthSettings{}.sites_per_m2};
    patient_ = std::make_unique<Planner>(world, robot, denser);
    patient_->prepare(Planner::Clock::now() + std::chrono::microseconds(std::llround(own_s * 1e6)));
  }

  void add(const std::vector<Request>& requests, Costs& costs) {
    const bool is_safest = requests.front().policy == Policy::kSafest;
    const std::vector<Route> best =
        is_safest ? std::vector<Route>(requests.size()) : oracle_.routes(requests);
    for (std::size_t i = 0; i < requests.size(); ++i)
      is_safest ? addSafest(requests[i], costs) : addOne(requests[i], best[i], costs);
  }

 private:
  [[nodiscard]] const Robot& robot() const { return planner_->checker()->robot(); }

  /// The oracle's route, or what the patient planner and shortcuts on its plan make of it.
  Route best(const Request& request, Route route) {
    if (!patient_ || route.empty()) return route;
    const auto plan = patient_->plan(request, Planner::Clock::now() + kDeadline);
    if (!plan) return route;
    Route other = oracle_.better(request, motionsOf(*plan), robot().margin_m);
    const bool is_better =
        totalCost(robot(), request.policy, other) < totalCost(robot(), request.policy, route);
    return is_better ? other : route;
  }

  void addOne(const Request& request, const Route& found, Costs& costs) {
    if (found.empty()) return;
    const auto plan = planner_->plan(request, Planner::Clock::now() + kDeadline);
    ++costs.asked;
    if (!plan) {
      ++costs.unanswered;
      return;
    }
    if (request.policy == Policy::kPriority && isDetour(request, found))
      return addDetour(request, *plan, costs);
    note(costRatio(robot(), request.policy, motionsOf(*plan), best(request, found)), costs);
  }

  /// Whether the oracle's way takes so long that priority would take the fastest in its place: it may shuffle
  /// to and fro in a hundred turns rather than sidestep.
  [[nodiscard]] bool isDetour(const Request& request, const Route& found) {
    Request quick = request;
    quick.policy = Policy::kFastest;
    const auto fastest = planner_->plan(quick, Planner::Clock::now() + kDeadline);
    const double takes_s = 1e-6 * static_cast<double>(totalCost(robot(), Policy::kFastest, found).us());
    return fastest && takes_s >= request.max_detour * fastest->total_time_s;
  }

  /// Then the plan is held against the oracle's fastest way, by what priority compares.
  void addDetour(const Request& request, const Plan& plan, Costs& costs) {
    Request quick = request;
    quick.policy = Policy::kFastest;
    const Route fastest = oracle_.route(quick);
    if (!fastest.empty()) note(costRatio(robot(), request.policy, motionsOf(plan), fastest), costs);
  }

  /// A plan that comes closer than it need is infinitely dear; else its time against the oracle's fastest
  /// that keeps as much.
  void addSafest(const Request& request, Costs& costs) {
    const double margin_m = oracle_.largestMargin(request);
    if (margin_m < 0.0) return;
    const auto plan = planner_->plan(request, Planner::Clock::now() + kDeadline);
    ++costs.asked;
    if (!plan) {
      ++costs.unanswered;
      return;
    }
    double least_m = kEnoughClearance_m;
    for (const Segment& segment : plan->segments) least_m = std::min(least_m, segment.closeness.clearance_m);
    const double step_m = roomOracle().clearance_step_m;
    if (least_m < margin_m - step_m) return note(std::numeric_limits<double>::infinity(), costs);
    const Route safe = oracle_.routeKeeping(
        request, std::min(margin_m, robot().margin_m +
                                        step_m * std::floor((least_m - robot().margin_m) / step_m + 1e-6)));
    if (!safe.empty()) note(costRatio(robot(), request.policy, motionsOf(*plan), safe), costs);
  }

  static void note(double ratio, Costs& costs) {
    costs.ratios.push_back(ratio);
    if (ratio < 1.0 - 1e-4) ++costs.better;
    costs.most_better = std::min(costs.most_better, ratio);
  }

  std::unique_ptr<Planner> planner_;
  std::unique_ptr<Planner> patient_;
  Oracle oracle_;
};

void addRows(Policy policy, const Costs& costs, Report& report) {
  const auto add = [&](const std::string& what, double value, const char* unit, const char* goal = "",
                       std::optional<bool> met = std::nullopt) {
    report.rows.push_back({"rooms, " + std::string(name(policy)) + ": " + what,
                           value,
                           unit,
                           goal,
                           met,
                           kSeed,
                           costs.asked,
                           {},
                           {}});
  };
  add("queries without a plan in 10 s", static_cast<double>(costs.unanswered), "", "0",
      costs.unanswered == 0);
  if (costs.ratios.empty()) return;
  const double p50 = quantile(costs.ratios, 0.5);
  const double p95 = quantile(costs.ratios, 0.95);
  add("cost over the oracle's, p50", p50, "", "<= 1.05", p50 <= 1.05);
  add("cost over the oracle's, p95", p95, "", "<= 1.12", p95 <= 1.12);
  add("cost over the oracle's, most", quantile(costs.ratios, 1.0), "");
  add("plans better than the oracle's", static_cast<double>(costs.better), "");
  add("cost over the oracle's, least", costs.most_better, "");
}

}  // namespace

Expected<void> addCost(const PlannerOptions& options, Report& report, const Progress& progress) {
  const auto robot = naoOf(options);
  if (!robot) return tl::unexpected(robot.error());
  constexpr std::array kPolicies{Policy::kFastest, Policy::kPriority, Policy::kSafest};
  std::array<Costs, kPolicies.size()> costs;
  double done = 0.0;
  const std::size_t rooms = options.quick ? kQuickRooms : kRooms.size();
  for (const char* room : std::span(kRooms).first(rooms)) {
    const auto world = worldOf(options.data / "maps" / (std::string(room) + ".yaml"));
    if (!world) return tl::unexpected(world.error());
    Contest contest(*world, *robot, options.own_s);
    for (std::size_t p = 0; p < kPolicies.size(); ++p) {
      const bool is_safest = kPolicies.at(p) == Policy::kSafest;
      const Share share = options.quick ? is_safest ? Share{1, 1} : Share{1, 8}
                          : is_safest ? Share{1, 8}
                                        : Share{4, 15};
      const Checker checker(*world, *robot);
      for (const auto& requests :
           randomRequests(checker, kPolicies.at(p), share.starts, share.goals, kSeed)) {
        contest.add(requests, costs.at(p));
        done += 1.0 / static_cast<double>(kPolicies.size() * rooms * share.starts);
        progress(done);
      }
    }
  }
  for (std::size_t p = 0; p < kPolicies.size(); ++p) addRows(kPolicies.at(p), costs.at(p), report);
  return {};
}

}  // namespace underway::bench
