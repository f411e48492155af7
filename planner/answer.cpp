#include "planner/answer.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>

#include "planner/attach.hpp"
#include "planner/certify.hpp"
#include "planner/search.hpp"
#include "planner/shorten.hpp"

namespace underway {
namespace {

constexpr double kClearanceStep_m = 1e-3;  // to which kSafest finds the largest clearance
constexpr double kFarQuicker = 0.95;       // of a plan's time: worth looking at by priority's measure

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

bool isBetter(const Robot& robot, Policy policy, const Plan& a, const Plan& b) {
  if (policy == Policy::kPriority) return priorityOf(robot, a) < priorityOf(robot, b);
  if (policy == Policy::kSafest && leastClearance(a) != leastClearance(b))
    return leastClearance(a) > leastClearance(b);
  return a.total_time_s < b.total_time_s;
}

/// Plans one request on one roadmap: search, shorten, time.
class Answerer {
 public:
  Answerer(const Planning& planning, const Request& request, const Draft& graph, const Target& target,
           Interrupt& interrupt)
      : planning_(planning),
        checker_(*planning.checker),
        request_(request),
        graph_(graph),
        target_(target),
        interrupt_(interrupt),
        checks_(graph, checker_) {}

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
    const auto fastest = by_priority ? fastestBeside(*by_priority) : find(planning_.fastest);
    if (!fastest) return std::nullopt;
    Plan plan = fastest->plan;
    if (by_priority) takeIfBetter(plan, by_priority->plan);
    if (is_priority && isFarQuicker(fastest->plan, plan)) takeByPriority(plan, *fastest);
    if (request_.policy == Policy::kSafest) takeSafer(plan, *fastest);
    if (interrupt_.isDueNow()) return std::nullopt;
    return is_priority && isDetour(plan, fastest->plan) ? fastest->plan : plan;
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
  /// companions, or that takes longer than the straight way would.
  [[nodiscard]] bool mayBeBettered(const Plan& plan) const {
    const Stances& stances = planning_.by_priority;
    for (const Segment& segment : plan.segments)
      if (stances.groupOf(segment.motion.mode) != stances.groupOf(0)) return true;
    const double least_s = leastDistance() / planning_.fastest.highestSpeed();
    const double quicker = std::max(kFarQuicker, 1.0 / request_.max_detour);
    return plan.total_time_s > 0.0 && quicker * plan.total_time_s >= least_s;
  }

  [[nodiscard]] static bool isFarQuicker(const Plan& fastest, const Plan& plan) {
    return fastest.total_time_s < kFarQuicker * plan.total_time_s;
  }

  /// The quickest way, made by priority's measure: over the roadmap it takes a few steps sideways, say, where
  /// its places lie badly, and priority goes a long way round; beside the places it may need none.
  void takeByPriority(Plan& plan, const Found& fastest) {
    if (const auto found = shortenedOn(fastest.on_roadmap, planning_.by_priority))
      takeIfBetter(plan, found->plan);
  }

  /// From the start to the nearest goal, as the crow flies.
  [[nodiscard]] double leastDistance() const {
    double least_m = std::numeric_limits<double>::infinity();
    for (const Target::Goal& goal : target_.goals)
      least_m = std::min(least_m, distance(graph_.place(target_.start).at, graph_.place(goal.place).at));
    return least_m;
  }

  void takeIfBetter(Plan& plan, const Plan& other) const {
    if (isBetter(checker_.robot(), request_.policy, other, plan)) plan = other;
  }

  /// The roadmap says which ways have room; how much, beside its own places, widening finds out. So the
  /// quickest way may serve as well as one that the roadmap knows to be wide.
  void takeSafer(Plan& plan, const Found& fastest) {
    const double most_m = mostClearance();
    if (leastClearance(plan) >= most_m) return;
    if (const double clearance = largestClearance(most_m); clearance > checker_.robot().margin_m)
      if (const auto widest = find(fastestKeeping(clearance))) {
        takeIfBetter(plan, widest->plan);
        takeWidened(plan, *widest, most_m);
      }
    takeWidened(plan, fastest, most_m);
  }

  /// Passages that it has measured point to it.
  const Stances& fastestKeeping(double clearance_m) {
    return by_clearance_.try_emplace(clearance_m, checker_, Policy::kFastest, clearance_m).first->second;
  }

  /// What is found beside a way, with more clearance than the plan has, or as much, for it may be quicker.
  void takeWidened(Plan& plan, const Found& beside, double most_m) {
    double has_m = leastClearance(plan);
    Passage passage = beside.shortest;
    const auto widen = [&](double to_m) {
      auto wider = widened(checker_, fastestKeeping(to_m), passage, keepingTo(passage), interrupt_);
      if (wider) passage = *std::move(wider), has_m = to_m;
      return wider.has_value();
    };
    bool is_wider = false;
    for (double more_m = most_m - has_m; more_m >= kClearanceStep_m && !interrupt_.isDueNow();
         more_m = std::min(more_m, most_m - has_m))
      if (widen(has_m + more_m))
        is_wider = true;
      else
        more_m *= 0.5;
    if (!is_wider && !widen(has_m)) return;
    if (const auto found = shortenedOn(std::move(passage), fastestKeeping(has_m)))
      takeIfBetter(plan, found->plan);
  }

  /// The most that a plan can have: what the start and the best goal have, up to the enough.
  [[nodiscard]] double mostClearance() const {
    const auto most_at = [&](const Roadmap::Place& place, const Stance& stance) {
      return checker_.clearance(stay(stance.mode, {place.at.x, place.at.y, stance.yaw}), kEnoughClearance_m);
    };
    double at_goal_m = 0.0;
    for (const Target::Goal& goal : target_.goals)
      at_goal_m = std::max(
          at_goal_m, goal.any_heading ? kEnoughClearance_m : most_at(graph_.place(goal.place), goal.stance));
    return std::min(at_goal_m, most_at(graph_.place(target_.start), target_.start_stance));
  }

  std::optional<Passage> passageBy(const Stances& stances) {
    Pose reached;
    auto passage = search(graph_, stances, checker_.robot(), checks_, target_, interrupt_, &reached);
    if (!passage) nearest_ = reached;
    return passage;
  }

  /// A way over the roadmap that takes less time than another policy's.
  std::optional<Passage> quickerThan(const Passage& other, const Stances& stances) {
    return search(graph_, stances, checker_.robot(), checks_, target_, interrupt_, nullptr,
                  Cost::time(other.cost.us()));
  }

  std::optional<Found> find(const Stances& stances) {
    auto on_roadmap = passageBy(stances);
    if (!on_roadmap) return std::nullopt;
    return shortenedOn(*std::move(on_roadmap), stances);
  }

  std::optional<Found> shortenedOn(Passage on_roadmap, const Stances& stances) {
    Passage shortest = shortened(checker_, stances, on_roadmap, keepingTo(on_roadmap), interrupt_);
    return foundOn(std::move(on_roadmap), std::move(shortest));
  }

  /// The quickest, beside what was found by priority: that is only polished, since it is short already, and a
  /// quicker way over the roadmap need not be quicker once both are as short as they can be.
  std::optional<Found> fastestBeside(const Found& by_priority) {
    const Stances& stances = planning_.fastest;
    const Passage& on_roadmap = by_priority.on_roadmap;
    auto same_way = foundOn(
        on_roadmap, polished(checker_, stances, by_priority.shortest, keepingTo(on_roadmap), interrupt_));
    auto other_on_roadmap = quickerThan(on_roadmap, stances);
    if (!other_on_roadmap) return same_way;
    auto other_way = shortenedOn(*std::move(other_on_roadmap), stances);
    const bool is_quicker =
        other_way && (!same_way || other_way->plan.total_time_s < same_way->plan.total_time_s);
    return is_quicker ? other_way : same_way;
  }

  [[nodiscard]] Keeping keepingTo(const Passage& passage) const {
    const Target::Goal& goal = target_.goals[passage.goal];
    return {graph_.place(target_.start).keep_m, graph_.place(goal.place).keep_m};
  }

  [[nodiscard]] static bool moves(const Passage& passage) {
    return std::any_of(passage.steps.begin(), passage.steps.end(), [](const Passage::Step& step) {
      return step.way.has_value() || !step.option.motions.empty();
    });
  }

  /// Nothing, too, where rounding has spoilt both.
  std::optional<Found> foundOn(Passage on_roadmap, Passage shortest) {
    if (interrupt_.isDueNow()) return std::nullopt;
    Route route = routeOf(shortest);
    if (route.empty()) route = routeOf(on_roadmap);
    if (route.empty() && moves(on_roadmap)) return std::nullopt;
    Plan plan = planOf(checker_, joined(checker_, route), request_.start);
    plan.goal_index = target_.goals[on_roadmap.goal].index;
    return Found{std::move(on_roadmap), std::move(shortest), std::move(plan)};
  }

  /// The largest clearance that any way over the roadmap keeps, up to the most, to kClearanceStep_m.
  double largestClearance(double most_m) {
    const auto is_kept = [&](double clearance_m) {
      return passageBy(fastestKeeping(clearance_m)).has_value();
    };
    double has = checker_.robot().margin_m;
    double lacks = most_m;
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
  const Draft& graph_;
  const Target& target_;
  Interrupt& interrupt_;
  LinkChecks checks_;
  std::map<double, Stances> by_clearance_;
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

/// A goal of several, and how good a plan to it can be at best.
struct Prospect {
  Target target;
  double most_m;   // of clearance, up to the enough
  double least_s;  // that it takes
};

/// Each goal by itself, those first that may have the most clearance, and then those that are near.
std::vector<Prospect> prospectsOf(const Planning& planning, const Request& request, const Target& target) {
  constexpr double kTolerance_m = 0.01;  // a plan may end this far from the goal
  const Checker& checker = *planning.checker;
  const auto most_at = [&](ModeId mode, const Pose& pose) {
    return checker.clearance(stay(mode, pose), kEnoughClearance_m);
  };
  const double at_start_m = most_at(request.start_mode, request.start);
  const std::vector<Goal> goals = goalsOf(request);
  std::vector<Prospect> prospects;
  for (const Target::Goal& one : target.goals) {
    const auto& [at, yaw, mode] = goals[one.index];
    const double at_goal_m = yaw ? most_at(mode, {at.x, at.y, *yaw}) + kTolerance_m : kEnoughClearance_m;
    const double way_m = std::max(0.0, distance(request.start.position(), at) - kTolerance_m);
    prospects.push_back({{target.start, target.start_stance, {one}},
                         std::min({at_start_m, at_goal_m, kEnoughClearance_m}),
                         way_m > 0.0 ? way_m / planning.fastest.highestSpeed() : 0.0});
  }
  std::stable_sort(prospects.begin(), prospects.end(), [](const Prospect& a, const Prospect& b) {
    return a.most_m > b.most_m || (a.most_m == b.most_m && a.least_s < b.least_s);
  });
  return prospects;
}

/// The safest plan to any of several goals. One search cannot tell which it is: a plan's clearance is more
/// than what its search made sure of, by a little that differs from goal to goal. So each goal that may be
/// better than the best so far is planned for by itself.
Answer safestOfSeveral(const Planning& planning, const Request& request, const Attached& attached,
                       Interrupt& interrupt) {
  Answer best;
  for (const Prospect& prospect : prospectsOf(planning, request, attached.target)) {
    if (best.plan &&
        (prospect.most_m < leastClearance(*best.plan) ||
         (prospect.most_m == leastClearance(*best.plan) && prospect.least_s >= best.plan->total_time_s)))
      continue;
    Answerer answerer(planning, request, attached.graph, prospect.target, interrupt);
    auto plan = answerer.best();
    if (interrupt.isDueNow()) return {};
    if (!best.nearest) best.nearest = answerer.nearest();
    if (plan && (!best.plan || isBetter(planning.checker->robot(), request.policy, *plan, *best.plan)))
      best.plan = std::move(plan);
  }
  return best;
}

/// The best plan, not certified yet, or the pose nearest to a goal that was reached.
Answer best(const Planning& planning, const Request& request, const Attached& attached,
            Interrupt& interrupt) {
  if (request.policy == Policy::kSafest && attached.target.goals.size() > 1)
    return safestOfSeveral(planning, request, attached, interrupt);
  Answerer answerer(planning, request, attached.graph, attached.target, interrupt);
  auto plan = answerer.best();
  return {std::move(plan), std::nullopt, answerer.nearest()};
}

/// Answers with one effort; nothing when interrupted. The plan is empty when there is none or it has a fault,
/// and is then put into `flawed`.
std::optional<Answer> answerWith(const Planning& planning, const Roadmap& roadmap, const Request& request,
                                 Effort effort, Interrupt& interrupt, Plan& flawed) {
  const auto started = Interrupt::Clock::now();
  const auto attached = attach(*planning.checker, planning.fastest, roadmap, request, effort, interrupt);
  if (!attached) return std::nullopt;
  Answer found = best(planning, request, *attached, interrupt);
  std::optional<Plan>& plan = found.plan;
  if (!plan) return found;
  plan->revision = planning.checker->world().revision();
  plan->world_hash = planning.checker->world().hash();
  plan->stats = {
      roadmap.node_count, roadmap.edge_count, roadmap.batches, 0.0, microsecondsSince(started), 0.0};
  const auto planned = Interrupt::Clock::now();
  const auto flaws = certify(*plan, request, *planning.checker, interrupt);
  if (!flaws) return std::nullopt;
  plan->stats.certify_us = microsecondsSince(planned);
  if (flaws->empty()) return Answer{std::move(plan), std::nullopt, std::nullopt};
  flawed = *std::move(plan);
  return Answer{std::nullopt, faultOf(flaws->front()), found.nearest};
}

}  // namespace

Answer answer(const Planning& planning, const Roadmap& roadmap, const Request& request,
              Interrupt& interrupt) {
  Answer last;
  for (const Effort effort : {Effort::kNearest, Effort::kLocalRoadmap}) {
    Plan flawed;
    auto result = answerWith(planning, roadmap, request, effort, interrupt, flawed);
    if (result && result->fault && (!request.goal_yaw || !request.other_goals.empty())) {
      // How close motions may come to a tight goal depends on which it is and on the heading there, which
      // were open: now they are known.
      const std::uint32_t index = flawed.goal_index;
      Goal goal = goalsOf(request)[index];
      goal.yaw = flawed.goal.yaw;
      result = answerWith(planning, roadmap, withGoals(request, {goal}), effort, interrupt, flawed);
      if (result && result->plan) result->plan->goal_index = index;
    }
    if (!result) break;
    if (result->plan) return *std::move(result);
    if (result->nearest) last.nearest = result->nearest;
    if (result->fault) last.fault = result->fault;
  }
  return last;
}

}  // namespace underway
