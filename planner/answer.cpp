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

/// Plans one request on one roadmap: search, shorten, time.
class Answerer {
 public:
  Answerer(const Planning& planning, const Request& request, const Attached& attached, Interrupt& interrupt)
      : planning_(planning),
        checker_(*planning.checker),
        request_(request),
        attached_(attached),
        interrupt_(interrupt),
        checks_(attached.graph, checker_),
        keeping_{attached.graph.place(attached.target.start).keep_m,
                 attached.graph.place(attached.target.goal).keep_m} {}

  /// A policy takes the best, by its own measure, of what the policies that matter to it have found. So
  /// priority never crawls further than fastest, and safest never comes closer than fastest, whatever
  /// shortening does.
  ///
  /// Nothing when interrupted: time must not decide which plan is given.
  std::optional<Plan> best() {
    if (request_.policy == Policy::kPriority) return bestByPriority();
    std::optional<Plan> plan = planBy(planning_.fastest);
    if (!plan) return std::nullopt;
    if (checker_.robot().modes.size() > 1) takeIfBetter(plan, planBy(planning_.by_priority));
    if (request_.policy == Policy::kSafest) {
      const double clearance = largestClearance();
      if (clearance > checker_.robot().margin_m)
        takeIfBetter(plan, planBy(Stances(checker_, Policy::kFastest, clearance)));
    }
    if (interrupt_.isDueNow()) return std::nullopt;
    return plan;
  }

  /// Where a search that found nothing came nearest to the goal.
  [[nodiscard]] const std::optional<Pose>& nearest() const { return nearest_; }

 private:
  std::optional<Plan> bestByPriority() {
    std::optional<Plan> plan = planBy(planning_.by_priority);
    if (!plan || !mayBeBettered(*plan)) return plan;
    const auto fastest = planBy(planning_.fastest);
    if (!fastest) return std::nullopt;
    if (isBetter(*fastest, *plan)) plan = *fastest;
    const bool is_detour = plan->total_time_s >= request_.max_detour * fastest->total_time_s &&
                           plan->total_time_s > fastest->total_time_s;
    return is_detour ? fastest : plan;
  }

  /// Whether the fastest plan can matter to priority: only against one that leaves the first mode and its
  /// companions, or that takes far longer than the straight way would.
  [[nodiscard]] bool mayBeBettered(const Plan& plan) const {
    const Stances& stances = planning_.by_priority;
    for (const Segment& segment : plan.segments)
      if (stances.groupOf(segment.motion.mode) != stances.groupOf(0)) return true;
    const double way_m = distance(request_.start.position(), request_.goal);
    const double least_s = way_m / planning_.fastest.highestSpeed();
    return plan.total_time_s > 0.0 && plan.total_time_s >= request_.max_detour * least_s;
  }

  [[nodiscard]] bool isBetter(const Plan& a, const Plan& b) const {
    if (request_.policy == Policy::kPriority)
      return priorityOf(checker_.robot(), a) < priorityOf(checker_.robot(), b);
    if (request_.policy == Policy::kSafest && leastClearance(a) != leastClearance(b))
      return leastClearance(a) > leastClearance(b);
    return a.total_time_s < b.total_time_s;
  }

  void takeIfBetter(std::optional<Plan>& plan, const std::optional<Plan>& other) const {
    if (other && isBetter(*other, *plan)) plan = other;
  }

  std::optional<Passage> passageBy(const Stances& stances) {
    Pose reached;
    auto passage =
        search(attached_.graph, stances, checker_.robot(), checks_, attached_.target, interrupt_, &reached);
    if (!passage) nearest_ = reached;
    return passage;
  }

  std::optional<Plan> planBy(const Stances& stances) {
    auto passage = passageBy(stances);
    if (!passage) return std::nullopt;
    const Route shortest = routeOf(shortened(checker_, stances, *passage, keeping_, interrupt_));
    if (interrupt_.isDueNow()) return std::nullopt;
    const Route route = joined(checker_, shortest.empty() ? routeOf(*passage) : shortest);
    return planOf(checker_, route, request_.start);
  }

  /// The largest clearance that any route keeps, up to the enough, to kClearanceStep_m.
  double largestClearance() {
    const auto is_kept = [&](double clearance_m) {
      return passageBy(Stances(checker_, Policy::kFastest, clearance_m)).has_value();
    };
    double has = checker_.robot().margin_m;
    double lacks = kEnoughClearance_m;
    if (has >= lacks || is_kept(lacks)) return lacks;
    while (lacks - has > kClearanceStep_m && !interrupt_.isDueNow()) {
      const double middle = 0.5 * (has + lacks);
      (is_kept(middle) ? has : lacks) = middle;
    }
    return has;
  }

  const Planning& planning_;
  const Checker& checker_;
  const Request& request_;
  const Attached& attached_;
  Interrupt& interrupt_;
  LinkChecks checks_;
  Keeping keeping_;
  std::optional<Pose> nearest_;
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

/// Answers with one effort; nothing when interrupted. The plan is empty when there is none or it has a fault,
/// and `ended` is then the heading it ended at.
std::optional<Answer> answerWith(const Planning& planning, const Roadmap& roadmap, const Request& request,
                                 Effort effort, Interrupt& interrupt, double& ended) {
  const auto started = Interrupt::Clock::now();
  const auto attached = attach(*planning.checker, planning.fastest, roadmap, request, effort, interrupt);
  if (!attached) return std::nullopt;
  Answerer answerer(planning, request, *attached, interrupt);
  std::optional<Plan> plan = answerer.best();
  if (!plan) return Answer{std::nullopt, std::nullopt, answerer.nearest()};
  plan->revision = planning.checker->world().revision();
  plan->stats = {
      roadmap.node_count, roadmap.edge_count, roadmap.batches, 0.0, microsecondsSince(started), 0.0};
  const auto planned = Interrupt::Clock::now();
  const std::vector<Flaw> flaws = certify(*plan, request, *planning.checker);
  plan->stats.certify_us = microsecondsSince(planned);
  if (flaws.empty()) return Answer{std::move(plan), std::nullopt, std::nullopt};
  ended = plan->goal.yaw;
  return Answer{std::nullopt, faultOf(flaws.front()), answerer.nearest()};
}

}  // namespace

Answer answer(const Planning& planning, const Roadmap& roadmap, const Request& request,
              Interrupt& interrupt) {
  Answer last;
  for (const Effort effort : {Effort::kNearest, Effort::kLocalRoadmap}) {
    double ended = 0.0;
    auto result = answerWith(planning, roadmap, request, effort, interrupt, ended);
    if (result && result->fault && !request.goal_yaw) {
      // How close motions may come to a tight goal depends on the heading there, which was open: now it is
      // known.
      Request at_heading = request;
      at_heading.goal_yaw = ended;
      result = answerWith(planning, roadmap, at_heading, effort, interrupt, ended);
    }
    if (!result) break;
    if (result->plan) return *std::move(result);
    if (result->nearest) last.nearest = result->nearest;
    if (result->fault) last.fault = result->fault;
  }
  return last;
}

}  // namespace underway
