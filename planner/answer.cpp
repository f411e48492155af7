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
    const bool is_priority = request_.policy == Policy::kPriority;
    std::optional<Found> by_priority;
    if (is_priority || checker_.robot().modes.size() > 1) {  // of one mode, both policies want the same
      by_priority = find(planning_.by_priority);
      if (!by_priority) return std::nullopt;
      if (is_priority && !mayBeBettered(by_priority->plan)) return std::move(by_priority->plan);
    }
    auto fastest = find(planning_.fastest, by_priority ? &*by_priority : nullptr);
    if (!fastest) return std::nullopt;
    Plan plan = fastest->plan;
    if (by_priority) takeIfBetter(plan, by_priority->plan);
    if (is_priority) return isDetour(plan, fastest->plan) ? fastest->plan : plan;
    if (request_.policy == Policy::kSafest) takeSafer(plan);
    if (interrupt_.isDueNow()) return std::nullopt;
    return plan;
  }

  /// Where a search that found nothing came nearest to the goal.
  [[nodiscard]] const std::optional<Pose>& nearest() const { return nearest_; }

 private:
  /// What came of a search.
  struct Found {
    Passage on_roadmap;
    Passage shortest;
    Plan plan;
  };

  [[nodiscard]] bool isDetour(const Plan& plan, const Plan& fastest) const {
    return plan.total_time_s >= request_.max_detour * fastest.total_time_s &&
           plan.total_time_s > fastest.total_time_s;
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

  void takeIfBetter(Plan& plan, const Plan& other) const {
    if (isBetter(other, plan)) plan = other;
  }

  void takeSafer(Plan& plan) {
    const double clearance = largestClearance();
    if (clearance <= checker_.robot().margin_m) return;
    if (const auto safest = find(Stances(checker_, Policy::kFastest, clearance)))
      takeIfBetter(plan, safest->plan);
  }

  std::optional<Passage> passageBy(const Stances& stances) {
    Pose reached;
    auto passage =
        search(attached_.graph, stances, checker_.robot(), checks_, attached_.target, interrupt_, &reached);
    if (!passage) nearest_ = reached;
    return passage;
  }

  /// `similar`: found by another policy. Where both take the same way over the roadmap, shortening goes on
  /// from there.
  std::optional<Found> find(const Stances& stances, const Found* similar = nullptr) {
    auto on_roadmap = passageBy(stances);
    if (!on_roadmap) return std::nullopt;
    const bool is_same = similar && areSameWay(*on_roadmap, similar->on_roadmap);
    Passage begin = is_same ? similar->shortest : *on_roadmap;
    if (is_same) begin.cost = Cost::most();  // by this policy it is not known
    Passage shortest = shortened(checker_, stances, std::move(begin), keeping_, interrupt_);
    if (interrupt_.isDueNow()) return std::nullopt;
    const Route route = routeOf(shortest);
    Plan plan =
        planOf(checker_, joined(checker_, route.empty() ? routeOf(*on_roadmap) : route), request_.start);
    return Found{std::move(*on_roadmap), std::move(shortest), std::move(plan)};
  }

  static bool areSameWay(const Passage& a, const Passage& b) {
    return std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(),
                      [](const Passage::Step& x, const Passage::Step& y) {
                        return x.option.in == y.option.in && x.option.out == y.option.out && x.way == y.way;
                      });
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
  const auto flaws = certify(*plan, request, *planning.checker, interrupt);
  if (!flaws) return std::nullopt;
  plan->stats.certify_us = microsecondsSince(planned);
  if (flaws->empty()) return Answer{std::move(plan), std::nullopt, std::nullopt};
  ended = plan->goal.yaw;
  return Answer{std::nullopt, faultOf(flaws->front()), answerer.nearest()};
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
