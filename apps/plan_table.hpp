#pragma once

#include <string>

#include "planner/plan_document.hpp"

namespace underway {

/// The answer as a person reads it: of a plan one line a segment and the totals, of a failure its code and
/// what is in the way (its sentence is not repeated here: it goes to standard error). That a plan is stale is
/// an answer too, and its sentence is here.
[[nodiscard]] std::string describe(const PlanDocument& document, bool with_colours);

/// "x,y,yaw" as --start takes it, rounded to 1 mm and 1 mrad.
[[nodiscard]] std::string shortText(const Pose& pose);

/// The name of a mode of the document, "?" if it has none.
[[nodiscard]] std::string modeName(const PlanDocument& document, ModeId mode);

}  // namespace underway
