#pragma once

#include <memory>
#include <optional>

#include "planner/interrupt.hpp"
#include "planner/plan.hpp"
#include "planner/roadmap.hpp"
#include "planner/stances.hpp"

namespace underway {

/// The request with those of its goals that the robot can stand at, each once; or what is wrong before any
/// planning: numbers that are not finite, modes the robot does not have, too many goals, start or all goals
/// out of bounds or in collision (and with what).
[[nodiscard]] Expected<Request> admitted(const Checker& checker, const Request& request);

/// What answers need of the robot in a world, made once.
struct Planning {
  std::shared_ptr<const Checker> checker;
  Stances fastest;
  Stances by_priority;

  explicit Planning(std::shared_ptr<const Checker> c)
      : checker(std::move(c)),
        fastest(*checker, Policy::kFastest),
        by_priority(*checker, Policy::kPriority) {}
};

/// What came of a try on one roadmap.
struct Answer {
  std::optional<Plan> plan;     ///< certified; empty when the roadmap holds none or it was interrupted
  std::optional<Error> fault;   ///< kInternal: a plan failed its certificate and is not given out
  std::optional<Pose> nearest;  ///< without a plan: the pose nearest the goal that was reached
};
[[nodiscard]] Answer answer(const Planning& planning, const Roadmap& roadmap, const Request& request,
                            Interrupt& interrupt);

}  // namespace underway
