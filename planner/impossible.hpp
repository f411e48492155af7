#pragma once

#include <memory>
#include <optional>

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/plan.hpp"
#include "planner/settings.hpp"

namespace underway {

/// kNoPathExists with the obstacles to blame and what is missing at each, if it is proven that no plan
/// answers a request; nothing if it is not, or `proving` comes due first. `blaming` bounds the search for the
/// obstacles: when it is due, the proof stands without them.
[[nodiscard]] std::optional<Error> provenImpossible(const Checker& checker, const Request& request,
                                                    const GrowthSettings& settings, Interrupt& proving,
                                                    Interrupt& blaming);

}  // namespace underway
