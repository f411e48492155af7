#pragma once

#include <string>
#include <string_view>

#include "gait/error.hpp"
#include "gait/joint_table.hpp"

namespace underway::gait {

/// A joint table as text. Numbers print so that they read back bit for bit; times in seconds, angles in
/// radians.

/// One row a line: "time_s,LShoulderPitch,...", then numbers.
[[nodiscard]] std::string toCsv(const JointTable& table);
/// Errors: a sentence that names `where` and the line.
[[nodiscard]] GaitExpected<JointTable> tableFromCsv(std::string_view text, const std::string& where);

/// The arguments of NAOqi's ALMotion.angleInterpolation(names, angleLists, timeLists, isAbsolute): a list of
/// angles and one of times for each joint. Times begin at the first row and are above 0: what is due at once
/// is due after `first_s`.
[[nodiscard]] std::string toNaoqiJson(const JointTable& table, double first_s = 0.5);

}  // namespace underway::gait
