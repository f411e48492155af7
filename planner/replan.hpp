#pragma once

#include <string>

#include "planner/planner.hpp"

namespace underway {

/// A plan that is being executed, and how far.
struct Executing {
  Plan plan;
  std::size_t segment = 0;  ///< the one the robot is in
  double done = 0.0;        ///< share of it, 0..1
};

/// How much better a new plan must be for the robot to leave the one it follows, so that it does not go to
/// and fro between two ways that are about as good.
struct Reluctance {
  double share = 0.1;          ///< of the time that is left
  double least_s = 2.0;        ///< and this much [s]
  double distance_m = 0.05;    ///< by priority: metres in a mode that count as a difference
  double clearance_m = 0.005;  ///< by safety: a difference in the least clearance that counts
};

/// What to do next.
struct Replanned {
  Plan plan;  ///< the new one, or what is left of the old one
  bool is_new = true;
  std::string why;  ///< in a sentence
};

/// What is left of a plan, timed anew; it begins where the robot is by `done`. A switch cannot be left half
/// way: it is still there as a whole.
///
/// Preconditions: the plan has the segment, or it is the one after its last.
[[nodiscard]] Plan rest(const Executing& executing, const Robot& robot);

/// What is left of a plan that may still be followed in a world, with the clearances it has there: the plan
/// is not stale. It is certified anew, for it may come from anywhere; nothing is planned.
///
/// Errors: kStaleRevision with the first segment that is blocked, and by what; kInvalidRequest for what was
/// no plan of this robot in the first place, or a segment it does not have.
[[nodiscard]] Expected<Plan> remaining(const Executing& executing, const Checker& checker);

/// Where a plan for it may begin: where the robot is by `done`; in a switch, where that will end.
struct Onward {
  Pose start;
  ModeId mode = 0;
};
[[nodiscard]] Onward onward(const Executing& executing, const Robot& robot);

/// Plans anew from where the robot is, and says whether to change over: when the old plan is broken or leads
/// to none of the request's goals, or the new one is better by more than `reluctance`. While the old plan
/// holds, also in the world as it is when planning ends, a new one that is not found is no failure.
///
/// `request.start` is where the robot is; in a switch, where it will end (`onward`). Errors: as
/// Planner::plan, of a plan that cannot be followed only; kInvalidRequest as `remaining`.
[[nodiscard]] Expected<Replanned> replan(Planner& planner, const Executing& executing, const Request& request,
                                         Planner::Clock::time_point deadline,
                                         const Reluctance& reluctance = {}, const std::stop_token& stop = {});

}  // namespace underway
