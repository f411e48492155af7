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
    keeping_.any_heading = !attached.goal_node.has_value();
  }

  /// Each policy takes the best, by its own measure, of what all policies that matter to it have found. So
  /// priority never crawls further than fastest, and safest never comes closer than fastest, whatever the
  /// shortcuts do.
  ///
  /// Nothing when interrupted before all searches were through: time must not decide which plan is given.
  /// Shortening is bounded work and is not interrupted by the deadline, for the same reason.
  std::optional<Plan> best() {
    const auto fastest = planBy(Policy::kFastest);
    if (!fastest) return std::nullopt;
    const auto by_priority = planBy(Policy::kPriority);
    if (!by_priority) return std::nullopt;
    Plan plan = isBetter(*by_priority, *fastest) ? *by_priority : *fastest;
    if (request_.policy == Policy::kSafest) {
      const double clearance = largestClearance();
      const auto safest =
          clearance > checker_.robot().margin_m ? planBy(Policy::kFastest, clearance) : std::nullopt;
      if (safest && isBetter(*safest, plan)) plan = *safest;
      if (interrupt_.isDueNow()) return std::nullopt;
    }
    const bool is_detour = request_.policy == Policy::kPriority &&
                           plan.total_time_s >= request_.max_detour * fastest->total_time_s &&
                           plan.total_time_s > fastest->total_time_s;
    return is_detour ? *fastest : plan;
  }

 private:
  [[nodiscard]] bool isBetter(const Plan& a, const Plan& b) const {
    if (request_.policy == Policy::kPriority)
      return priorityOf(checker_.robot(), a) < priorityOf(checker_.robot(), b);
    if (request_.policy == Policy::kSafest && leastClearance(a) != leastClearance(b))
      return leastClearance(a) > leastClearance(b);
    return a.total_time_s < b.total_time_s;
  }

  std::optional<Route> routeBy(Policy policy, double at_least_m) {
    const Target target{attached_.start, attached_.goal_place, attached_.goal_node, policy, at_least_m};
    return search(attached_.roadmap, checker_.robot(), checks_, target, interrupt_);
  }

  std::optional<Plan> planBy(Policy policy, double at_least_m = 0.0) {
    auto route = routeBy(policy, at_least_m);
    if (!route) return std::nullopt;
    Keeping keeping = keeping_;
    keeping.at_least_m = at_least_m;
    Interrupt stopped(Interrupt::Clock::time_point::max(), interrupt_.stop());
    return planOf(checker_, shortened(checker_, policy, std::move(*route), keeping, stopped), request_.start);
  }

  /// The largest clearance that any route keeps, up to the enough, to kClearanceStep_m.
  double largestClearance() {
    double has = checker_.robot().margin_m;
    double lacks = kEnoughClearance_m;
    if (has >= lacks || routeBy(Policy::kFastest, lacks)) return lacks;
    while (lacks - has > kClearanceStep_m && !interrupt_.isDueNow()) {
      const double middle = 0.5 * (has + lacks);
      (routeBy(Policy::kFastest, middle) ? has : lacks) = middle;
    }
    return has;
  }

  const Checker& checker_;
  const Request& request_;
  const Attached& attached_;
  Interrupt& interrupt_;
  EdgeChecks checks_;
  Keeping keeping_;
};

/// What a certificate says of a plan that must not be given out.
Error faultOf(const Flaw& flaw) {
  return {ErrorCode::kInternal,
          "a plan was found but failed its certificate and is not given out: segment " +
              std::to_string(flaw.segment) + " " + flaw.sentence,
          {}};
}

double microsecondsSince(Interrupt::Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Interrupt::Clock::now() - start).count();
}

}  // namespace

Expected<std::optional<Plan>> answer(const Checker& checker, std::shared_ptr<const Roadmap> roadmap,
                                     const Request& request, Interrupt& interrupt) {
  std::optional<Error> fault;
  for (const Effort effort : {Effort::kNearest, Effort::kLocalRoadmap}) {
    const auto started = Interrupt::Clock::now();
    const auto attached = attach(checker, roadmap, request, effort, interrupt);
    auto plan = attached ? Answerer(checker, request, *attached, interrupt).best() : std::nullopt;
    if (!plan) continue;
    plan->stats = {
        roadmap->nodes.size(), roadmap->edges.size(), roadmap->batches, 0.0, microsecondsSince(started), 0.0};
    const auto planned = Interrupt::Clock::now();
    const std::vector<Flaw> flaws = certify(*plan, request, checker);
    plan->stats.certify_us = microsecondsSince(planned);
    if (flaws.empty()) return plan;
    fault = faultOf(flaws.front());
  }
  if (fault) return tl::unexpected(*fault);
  return std::nullopt;
}

}  // namespace underway
