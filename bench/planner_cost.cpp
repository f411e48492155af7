#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>

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

constexpr std::array kPolicies{Policy::kFastest, Policy::kPriority, Policy::kSafest};
using CostsByPolicy = std::array<Costs, kPolicies.size()>;

/// Rows of one policy; `of`: a room, or all of them.
class Rows {
 public:
  Rows(const std::string& of, Policy policy, std::size_t asked, Report& report)
      : about_(of + ", " + std::string(name(policy)) + ": "), asked_(asked), report_(report) {}

  void add(const std::string& what, double value) { put(what, value, "", std::nullopt); }
  void add(const std::string& what, double value, double most) {
    put(what, value, "<= " + fmt::format("{}", most), value <= most);
  }

 private:
  void put(const std::string& what, double value, const std::string& goal, std::optional<bool> met) {
    report_.rows.push_back({about_ + what, value, "", goal, met, kSeed, asked_, {}, {}});
  }
  std::string about_;
  std::size_t asked_;
  Report& report_;
};

/// What is asked of a room, or of all.
void addRatios(const std::string& of, Policy policy, const Costs& costs, Report& report) {
  Rows rows(of, policy, costs.asked, report);
  rows.add("queries without a plan in 10 s", static_cast<double>(costs.unanswered), 0.0);
  if (costs.ratios.empty()) return;
  rows.add("cost over the oracle's, p50", quantile(costs.ratios, 0.5), 1.05);
  rows.add("cost over the oracle's, p95", quantile(costs.ratios, 0.95), 1.12);
  rows.add("cost over the oracle's, most", quantile(costs.ratios, 1.0));
}

/// How far the oracle is to be trusted.
void addTrust(Policy policy, const Costs& costs, Report& report) {
  Rows rows("all rooms", policy, costs.asked, report);
  rows.add("plans better than the oracle's", static_cast<double>(costs.better));
  rows.add("cost over the oracle's, least", costs.most_better);
}

void merge(const Costs& from, Costs& into) {
  into.ratios.insert(into.ratios.end(), from.ratios.begin(), from.ratios.end());
  into.asked += from.asked;
  into.unanswered += from.unanswered;
  into.better += from.better;
  into.most_better = std::min(into.most_better, from.most_better);
}

/// How many starts, and goals for each.
Share shareOf(Policy policy, bool quick) {
  if (policy == Policy::kSafest) return quick ? Share{1, 1} : Share{1, 8};
  return quick ? Share{1, 8} : Share{4, 15};
}

Expected<CostsByPolicy> costsIn(const std::string& room, const PlannerOptions& options,
                                const std::shared_ptr<const Robot>& robot, const Progress& progress) {
  const auto world = worldOf(options.data / "maps" / (room + ".yaml"));
  if (!world) return tl::unexpected(world.error());
  const Checker checker(*world, robot);
  Contest contest(*world, robot, options.own_s);
  CostsByPolicy costs;
  for (std::size_t p = 0; p < kPolicies.size(); ++p) {
    const Share share = shareOf(kPolicies.at(p), options.quick);
    double done = 0.0;
    for (const auto& of_start : randomRequests(checker, kPolicies.at(p), share.starts, share.goals, kSeed)) {
      contest.add(of_start, costs.at(p));
      done += 1.0 / static_cast<double>(share.starts);
      progress((static_cast<double>(p) + done) / kPolicies.size());
    }
  }
  return costs;
}

}  // namespace

Expected<void> addCost(const PlannerOptions& options, Report& report, const Progress& progress) {
  const auto robot = naoOf(options);
  if (!robot) return tl::unexpected(robot.error());
  CostsByPolicy all;
  const std::size_t rooms = options.quick ? kQuickRooms : kRooms.size();
  for (std::size_t i = 0; i < rooms; ++i) {
    const auto costs = costsIn(kRooms.at(i), options, *robot, [&](double share) {
      progress((static_cast<double>(i) + share) / static_cast<double>(rooms));
    });
    if (!costs) return tl::unexpected(costs.error());
    for (std::size_t p = 0; p < kPolicies.size(); ++p) {
      addRatios(kRooms.at(i), kPolicies.at(p), costs->at(p), report);
      merge(costs->at(p), all.at(p));
    }
  }
  for (std::size_t p = 0; p < kPolicies.size(); ++p) {
    addRatios("all rooms", kPolicies.at(p), all.at(p), report);
    addTrust(kPolicies.at(p), all.at(p), report);
  }
  return {};
}

}  // namespace underway::bench
