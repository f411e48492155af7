#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/plan.hpp"

namespace underway {

/// What is wrong with a plan, segment by segment; empty when it is sound.
struct Flaw {
  std::size_t segment = 0;  ///< index; one past the last for the plan as a whole
  std::string sentence;     ///< what is wrong, with numbers and units
};

/// Judges a plan by the certificate alone, trusting none of its claims: chained bit for bit from the start to
/// the goal, motions the robot's modes and switches have, the step along its sense to 1e-9 m, durations and
/// totals, inside the bounds, free on the source shapes, clearances neither above the truth nor more than 1
/// mm below.
[[nodiscard]] std::vector<Flaw> certify(const Plan& plan, const Request& request, const Checker& checker);
/// The same; empty when it was interrupted before all was judged.
[[nodiscard]] std::optional<std::vector<Flaw>> certify(const Plan& plan, const Request& request,
                                                       const Checker& checker, Interrupt& interrupt);

}  // namespace underway
