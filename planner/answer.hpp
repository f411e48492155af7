#pragma once

#include <memory>
#include <optional>

#include "planner/interrupt.hpp"
#include "planner/plan.hpp"
#include "planner/roadmap.hpp"

namespace underway {

/// What is wrong with a request before any planning: numbers that are not finite, modes the robot does not
/// have, start or goal out of bounds or in collision (and with what).
[[nodiscard]] std::optional<Error> refusal(const Checker& checker, const Request& request);

/// A certified plan from one roadmap, or nothing when the roadmap holds none or it was interrupted. kInternal
/// if a plan fails its certificate, which is then not given out.
[[nodiscard]] Expected<std::optional<Plan>> answer(const Checker& checker,
                                                   std::shared_ptr<const Roadmap> roadmap,
                                                   const Request& request, Interrupt& interrupt);

}  // namespace underway
