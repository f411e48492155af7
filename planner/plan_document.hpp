#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "planner/plan.hpp"

namespace underway {

/// How a plan was chosen when another one was being followed (replan.hpp).
struct Choice {
  bool is_new = true;  ///< or what is left of the one followed
  std::string why;     ///< in a sentence
};

/// All that a plan file (formats: 'Plan') says: the plan or the failure, and what it was asked of.
struct PlanDocument {
  Request request;
  std::string robot_name;
  std::vector<std::string> mode_names;  ///< by ModeId
  std::string map_name;
  std::uint64_t revision = 0;
  std::string world_hash;
  std::string robot_hash;
  std::uint64_t seed = 0;
  Expected<Plan> answer;
  std::optional<Choice> choice = {};  ///< of a plan that was asked for with one being followed
};

/// The file's text: JSON, numbers round-trip exact.
[[nodiscard]] std::string toJson(const PlanDocument& document);

/// Reads a plan file. Its modes are looked up in the robot. Errors: kInvalidRequest, one sentence saying what
/// and where. A file that holds a failure is read as one.
[[nodiscard]] Expected<PlanDocument> planFromJson(std::string_view text, const Robot& robot);

}  // namespace underway
