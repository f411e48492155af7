#include "planner/answer.hpp"

#include <algorithm>
#include <chrono>

#include "planner/attach.hpp"
#include "planner/certify.hpp"
#include "planner/search.hpp"
#include "planner/shorten.hpp"

namespace underway {
namespace {

constexpr double kClearanceStep_m = 1e-3;  // to which kSafest finds the largest clearance

/// One way to answer, timed and with its clearances.
Plan planOf(const Checker& checker, const Route& route, const Pose& start) {
  std::vector<Segment> segments;
  for (const Motion& motion : route)
    segments.push_back(
        {motion, duration(checker.robot(), motion), checker.closeness(motion, kClearanceCap_m)});
  return timedPlan(std::move(segments), start);
}

double leastClearance(const Plan& plan) {
  double least = kEnoughClearance_m;
  for (const Segment& segment : plan.segments) least = std::min(least, segment.closeness.clearance_m);
  return least;
}

Cost priorityOf(const Robot& robot, const Plan& plan) {
  Cost sum;
  for (const Segment& segment : plan.segments) sum = sum + costOf(robot, Policy::kPriority, segment.motion);
  return sum;
}

/// Plans one request on one roadmap: attach, search, shorten, time.
class Answerer {
 public:
  Answerer(const Checker& checker, const Request& request, const Attached& attached, Interrupt& interrupt)
      : checker_(checker),
        request_(request),
        attached_(attached),
        interrupt_(interrupt),
        checks_(attached.roadmap, checker) {
    const Roadmap& roadmap = attached.roadmap;
    keeping_.start_m = roadmap.place(roadmap.node(attached.start).place).keep_m;
    keeping_.goal_m = roadmap.place(attached.goal_place).keep_m;
  }

  /// Each policy takes the best, by its own measure, of what all policies that matter to it have found. So
  /// priority never crawls further than fastest, and safest never comes closer than fastest, whatever the
  /// shortcuts do.
  std::optional<Plan> best() {
    auto plan = route(Policy::kFastest, 0.0);
    if (!plan) return std::nullopt;
    const Plan fastest = *plan;
    const auto by_priority = route(Policy::kPriority, 0.0);
    if (by_priority && isBetter(*by_priority, *plan)) plan = by_priority;
    if (request_.policy == Policy::kSafest)
      if (const auto safest = safestRoute(); safest && isBetter(*safest, *plan)) plan = safest;
    const bool is_detour = request_.policy == Policy::kPriority &&
                           plan->total_time_s >= request_.max_detour * fastest.total_time_s &&
                           plan->total_time_s > fastest.total_time_s;
    return is_detour ? fastest : *plan;
  }

 private:
  [[nodiscard]] bool isBetter(const Plan& a, const Plan& b) const {
    if (request_.policy == Policy::kPriority)
      return priorityOf(checker_.robot(), a) < priorityOf(checker_.robot(), b);
    if (request_.policy == Policy::kSafest && leastClearance(a) != leastClearance(b))
      return leastClearance(a) > leastClearance(b);
    return a.total_time_s < b.total_time_s;
  }

  std::optional<Plan> route(Policy policy, double at_least_m) {
    const Target target{attached_.start, attached_.goal_place, attached_.goal_node, policy, at_least_m};
    auto found = search(attached_.roadmap, checker_.robot(), checks_, target, interrupt_);
    if (!found) return std::nullopt;
    Keeping keeping = keeping_;
    keeping.at_least_m = at_least_m;
    return planOf(checker_, shortened(checker_, policy, std::move(*found), keeping, interrupt_),
                  request_.start);
  }

  /// The fastest route that keeps the largest clearance any route keeps, up to the enough.
  std::optional<Plan> safestRoute() {
    double has = checker_.robot().margin_m;
    double lacks = kEnoughClearance_m;
    if (has >= lacks) return std::nullopt;
    auto best = route(Policy::kFastest, lacks);
    if (best) return best;
    while (lacks - has > kClearanceStep_m && !interrupt_.isDue()) {
      const double middle = 0.5 * (has + lacks);
      if (auto found = route(Policy::kFastest, middle)) {
        best = std::move(found);
        has = middle;
      } else {
        lacks = middle;
      }
    }
    return best;
  }

  const Checker& checker_;
  const Request& request_;
  const Attached& attached_;
  Interrupt& interrupt_;
  EdgeChecks checks_;
  Keeping keeping_;
};

double microsecondsSince(Interrupt::Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Interrupt::Clock::now() - start).count();
}

}  // namespace

Expected<std::optional<Plan>> answer(const Checker& checker, std::shared_ptr<const Roadmap> roadmap,
                                     const Request& request, Interrupt& interrupt) {
  const auto started = Interrupt::Clock::now();
  const Roadmap& base = *roadmap;
  std::optional<Plan> plan;
  for (const Effort effort : {Effort::kNearest, Effort::kLocalRoadmap}) {
    const auto attached = plan ? std::nullopt : attach(checker, roadmap, request, effort, interrupt);
    if (attached) plan = Answerer(checker, request, *attached, interrupt).best();
  }
  if (!plan) return std::nullopt;
  plan->stats = {base.nodes.size(), base.edges.size(), base.batches, 0.0, microsecondsSince(started), 0.0};
  const auto planned = Interrupt::Clock::now();
  const std::vector<Flaw> flaws = certify(*plan, request, checker);
  plan->stats.certify_us = microsecondsSince(planned);
  if (!flaws.empty())
    return fail(ErrorCode::kInternal,
                "a plan was found but failed its certificate and is not given out: segment " +
                    std::to_string(flaws[0].segment) + " " + flaws[0].sentence);
  return plan;
}

}  // namespace underway
