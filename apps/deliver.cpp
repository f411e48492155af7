#include "apps/deliver.hpp"

#include "apps/plan_table.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"

namespace underway {
namespace {

Expected<void> write(const PlanDocument& document, const OutputArguments& output,
                     const std::function<std::string()>& draw) {
  const bool json_only = output.json == "-";
  Expected<void> written = writeOutput(json_only ? toJson(document) : describe(document, wantsColour()));
  if (written && !json_only && !output.json.empty()) written = writeText(output.json, toJson(document));
  if (written && draw && !output.svg.empty()) written = writeText(output.svg, draw());
  return written;
}

}  // namespace

PlanDocument documentOf(const QueryArguments& query) {
  PlanDocument document;
  // The two modes as they were asked for, until a robot says which ones there are.
  document.mode_names = {query.start_mode, query.goal_mode};
  document.request.goal_mode = 1;
  if (!query.goals.empty()) {
    std::vector<Goal> goals = query.goals;
    for (Goal& goal : goals) goal.mode = 1;
    document.request = withGoals(std::move(document.request), goals);
  }
  document.request.policy = query.policy;
  document.request.max_detour = query.max_detour;
  document.request.start = query.start.value_or(Pose{});
  return document;
}

void describeSite(const Site& site, std::uint64_t seed, PlanDocument& document) {
  document.robot_name = site.robot->name;
  document.robot_hash = hashOf(*site.robot);
  document.map_name = site.world->name();
  document.revision = site.world->revision();
  document.world_hash = site.world->hash();
  document.seed = seed;
}

void setRequest(const Request& request, const Robot& robot, PlanDocument& document) {
  document.request = request;
  document.mode_names.clear();
  for (const Mode& mode : robot.modes) document.mode_names.push_back(mode.name);
}

ExitCode deliver(const PlanDocument& document, const OutputArguments& output,
                 const std::function<std::string()>& draw) {
  const Expected<void> written = write(document, output, draw);
  const bool is_stale = !document.answer && document.answer.error().code == ErrorCode::kStaleRevision;
  if (!document.answer && !(is_stale && output.json != "-")) complain(document.answer.error().message);
  if (!written) {
    complain(written.error().message);
    return ExitCode::kOther;
  }
  return document.answer ? ExitCode::kDone : exitCodeOf(document.answer.error().code);
}

ExitCode deliverFigures(const std::string& table, const std::string& json, const std::string& json_file) {
  const bool only_json = json_file == "-";
  Expected<void> written = writeOutput(only_json ? json : table);
  if (written && !only_json && !json_file.empty()) written = writeText(json_file, json);
  if (written) return ExitCode::kDone;
  complain(written.error().message);
  return ExitCode::kOther;
}

}  // namespace underway
