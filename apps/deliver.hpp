#pragma once

#include <functional>
#include <string>

#include "apps/arguments.hpp"
#include "apps/exit_code.hpp"
#include "apps/inputs.hpp"
#include "planner/plan_document.hpp"

namespace underway {

/// What is asked for, before map and robot are known: a failure to read them is told in the same form as any
/// other.
[[nodiscard]] PlanDocument documentOf(const QueryArguments& query);
/// Adds what map and robot say.
void describeSite(const Site& site, std::uint64_t seed, PlanDocument& document);
/// Adds the request, whose modes are the robot's.
void setRequest(const Request& request, const Robot& robot, PlanDocument& document);

/// Writes the answer where it was asked for: JSON, picture, and the table on standard output unless the JSON
/// went there. A failure's sentence goes to standard error. `draw` is called only if a picture was asked for,
/// and may be empty when there is no map to draw.
[[nodiscard]] ExitCode deliver(const PlanDocument& document, const OutputArguments& output,
                               const std::function<std::string()>& draw);

/// Writes what a command found out: the JSON to a file, if one is named, and the table to standard output;
/// only the JSON there if the file is "-".
[[nodiscard]] ExitCode deliverFigures(const std::string& table, const std::string& json,
                                      const std::string& json_file);

}  // namespace underway
