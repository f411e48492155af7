#pragma once

#include <string>

#include "idl/underway.h"
#include "server/question.hpp"
#include "server/served.hpp"

/// A part of convert.hpp: the plan that a robot follows.
namespace underway {

/// Returns what is wrong, naming the field; empty if nothing is.
[[nodiscard]] std::string write(const Followed& from, underway_Following& to);
/// Durations are the robot's; of clearances nothing is known. Errors: kInvalidRequest, naming the field.
[[nodiscard]] Expected<void> readFollowing(const underway_Following& wire, const Robot& robot, Asked& asked);

}  // namespace underway
