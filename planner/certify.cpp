#include "planner/certify.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/judge.hpp"

namespace underway {
namespace {

constexpr double kExact = 1e-9;   // of positions [m] and headings [rad]
constexpr double kGoal_m = 0.01;  // how near the goal a plan may end
constexpr double kGoal_rad = 0.02;
constexpr double kTold_m = 1e-3;           // how much less than the truth a clearance may be told
constexpr double kPlannedWithin_m = 1e-7;  // to which planning keeps what start and goal have
constexpr double kSum = 1e-6;              // of totals, relative

double apart(double a_rad, double b_rad) { return std::abs(normalizedAngle(a_rad - b_rad)); }
bool isNear(double a, double b) { return std::abs(a - b) <= kSum * std::max(1.0, std::abs(b)); }

class Certificate {
 public:
  Certificate(const Plan& plan, const Request& request, const Checker& checker)
      : plan_(plan),
        request_(request),
        goals_(goalsOf(request)),
        checker_(checker),
        robot_(checker.robot()) {}

  std::optional<std::vector<Flaw>> flaws(Interrupt& interrupt) {
    checkEnds();
    for (at_ = 0; at_ < plan_.segments.size(); ++at_) {
      if (interrupt.isDueNow()) return std::nullopt;
      checkChain();
      if (!checkMotion()) continue;  // what cannot be done cannot be swept
      checkDuration();
      checkClearance();
    }
    at_ = plan_.segments.size();
    checkTotals();
    return std::move(flaws_);
  }

 private:
  template <class... Args>
  void flaw(fmt::format_string<Args...> sentence, Args&&... args) {
    flaws_.push_back({at_, fmt::format(sentence, std::forward<Args>(args)...)});
  }

  [[nodiscard]] const Segment& segment() const { return plan_.segments[at_]; }
  [[nodiscard]] const Motion& motion() const { return segment().motion; }

  void checkEnds() {
    at_ = plan_.segments.size();
    const Pose end = plan_.segments.empty() ? request_.start : plan_.segments.back().motion.to;
    const ModeId mode = plan_.segments.empty() ? request_.start_mode : plan_.segments.back().motion.to_mode;
    if (plan_.goal_index >= goals_.size()) return flaw("the plan leads to a goal that was not asked for");
    const Goal& goal = goals_[plan_.goal_index];
    if (const double off = distance(end.position(), goal.at); !(off <= kGoal_m))
      flaw("the plan ends {:.4f} m from the goal", off);
    if (goal.yaw && !(apart(end.yaw, *goal.yaw) <= kGoal_rad))
      flaw("the plan ends {:.4f} rad off the goal's heading", apart(end.yaw, *goal.yaw));
    if (!(plan_.goal == end)) flaw("the goal it says it reaches is not where its last segment ends");
    if (mode != goal.mode) flaw("the plan does not end in the goal's mode");
  }

  void checkChain() {
    const Pose& before = at_ == 0 ? request_.start : plan_.segments[at_ - 1].motion.to;
    const ModeId mode = at_ == 0 ? request_.start_mode : plan_.segments[at_ - 1].motion.to_mode;
    if (!(motion().from == before)) flaw("does not begin where the last segment ended, bit for bit");
    if (motion().mode != mode) flaw("does not begin in the mode the last segment ended in");
  }

  bool checkMotion() {
    if (motion().mode >= robot_.modes.size() || motion().to_mode >= robot_.modes.size()) {
      flaw("is in a mode the robot does not have");
      return false;
    }
    const std::size_t flaws = flaws_.size();
    switch (motion().kind) {
      case MotionKind::kTranslate:
        checkTranslation();
        break;
      case MotionKind::kTurn:
        checkTurn();
        break;
      case MotionKind::kSwitch:
        checkSwitch();
        break;
    }
    return flaws_.size() == flaws;
  }

  void checkTranslation() {
    const Mode& mode = robot_.modes[motion().mode];
    if (!mode.canMove(motion().sense)) flaw("mode {} does not move {}", mode.name, name(motion().sense));
    if (motion().to.yaw != motion().from.yaw) flaw("the heading changes during a translation");
    const Motion straight = translate(motion().mode, motion().sense, motion().from, length(motion()));
    if (const double off = distance(straight.to.position(), motion().to.position()); !(off <= kExact))
      flaw("leaves the axis of its sense by {:.3g} m", off);
    if (motion().mode != motion().to_mode) flaw("changes the mode without a switch");
  }

  void checkTurn() {
    const Mode& mode = robot_.modes[motion().mode];
    if (!mode.canTurn()) flaw("mode {} cannot turn", mode.name);
    if (motion().from.position() != motion().to.position()) flaw("the position changes during a turn");
    if (!(apart(motion().from.yaw + motion().angle_rad, motion().to.yaw) <= kExact))
      flaw("the angle does not lead from its first heading to its last");
    if (motion().mode != motion().to_mode) flaw("changes the mode without a switch");
  }

  void checkSwitch() {
    const Switch* change = robot_.findSwitch(motion().mode, motion().to_mode);
    if (change == nullptr) {
      flaw("the robot has no switch from {} to {}", robot_.modes[motion().mode].name,
           robot_.modes[motion().to_mode].name);
      return;
    }
    const Pose to = compose(motion().from, change->displacement);
    if (!(distance(to.position(), motion().to.position()) <= kExact &&
          apart(to.yaw, motion().to.yaw) <= kExact))
      flaw("does not end where the switch's displacement leads");
  }

  void checkDuration() {
    if (!isNear(segment().duration_s, duration(robot_, motion())))
      flaw("says {:.3f} s; at the mode's speed it takes {:.3f} s", segment().duration_s,
           duration(robot_, motion()));
  }

  void checkClearance() {
    if (!checker_.isInBounds(motion())) flaw("leaves the bounds");
    const double told = segment().closeness.clearance_m;
    if (!(told > 0.0)) {
      flaw("tells no clearance above 0 m");
      return;
    }
    const bool is_clear = checker_.judge().isClear(motion(), std::min(told, kClearanceCap_m));
    if (!is_clear) flaw("tells {:.4f} m of clearance and has less", told);
    const Closeness closeness = checker_.closeness(motion(), kClearanceCap_m);
    const double truth = closeness.clearance_m;
    checkHeadroom(closeness.headroom_m);
    if (told < truth - kTold_m) flaw("tells {:.4f} m of clearance and has {:.4f} m", told, truth);
    const double least = leastAllowed();  // mostly less than told, and so judged already
    if (!(is_clear && told >= least) && !checker_.judge().isClear(motion(), least))
      flaw("keeps {:.4f} m of clearance; {:.4f} m are asked for", truth, least);
  }

  void checkHeadroom(const std::optional<double>& truth_m) {
    const std::optional<double>& told_m = segment().closeness.headroom_m;
    if (told_m.has_value() != truth_m.has_value() || (told_m && !(std::abs(*told_m - *truth_m) <= kTold_m)))
      flaw("tells {} of headroom and has {}", metres(told_m), metres(truth_m));
  }

  static std::string metres(const std::optional<double>& length_m) {
    return length_m ? fmt::format("{:.4f} m", *length_m) : "none";
  }

  /// The margin; on motions that leave the start's position or come to the goal's no more than that pose has
  /// itself.
  [[nodiscard]] double leastAllowed() const {
    double least = robot_.margin_m;
    if (motion().from.position() == request_.start.position())
      least = std::min(least, standingClearance(request_.start_mode, request_.start));
    const Motion& last = plan_.segments.back().motion;
    if (motion().to.position() == last.to.position())
      least = std::min(least, standingClearance(last.to_mode, last.to));
    return std::max(least - kPlannedWithin_m, 0.0);
  }

  [[nodiscard]] double standingClearance(ModeId mode, const Pose& pose) const {
    return checker_.clearance(stay(mode, pose), robot_.margin_m);
  }

  void checkTotals() {
    const Plan sums = timedPlan(plan_.segments, request_.start);
    if (!isNear(plan_.total_time_s, sums.total_time_s))
      flaw("says {:.3f} s in total; its segments take {:.3f} s", plan_.total_time_s, sums.total_time_s);
    if (!isNear(plan_.length_m, sums.length_m))
      flaw("says {:.3f} m in total; its segments are {:.3f} m", plan_.length_m, sums.length_m);
  }

  const Plan& plan_;
  const Request& request_;
  std::vector<Goal> goals_;
  const Checker& checker_;
  const Robot& robot_;
  std::size_t at_ = 0;
  std::vector<Flaw> flaws_;
};

}  // namespace

std::vector<Flaw> certify(const Plan& plan, const Request& request, const Checker& checker) {
  Interrupt never(Interrupt::Clock::time_point::max(), {});
  return *certify(plan, request, checker, never);
}

std::optional<std::vector<Flaw>> certify(const Plan& plan, const Request& request, const Checker& checker,
                                         Interrupt& interrupt) {
  return Certificate(plan, request, checker).flaws(interrupt);
}

}  // namespace underway
