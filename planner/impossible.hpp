#pragma once

#include <memory>
#include <optional>

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/plan.hpp"
#include "planner/settings.hpp"

namespace underway {

/// kNoPathExists with the obstacles to blame and what is missing at each, if it is proven that no plan
/// answers a request; nothing if it is not, or the interrupt comes due first. Due while it looks for the
/// obstacles, the proof stands without them.
[[nodiscard]] std::optional<Error> provenImpossible(const Checker& checker, const Request& request,
                                                    const GrowthSettings& settings, Interrupt& interrupt);

}  // namespace underway
