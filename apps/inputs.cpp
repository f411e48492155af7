#include "apps/inputs.hpp"

#include <algorithm>
#include <system_error>

#include "apps/text_file.hpp"

namespace underway {
namespace {

namespace fs = std::filesystem;

/// Where robots/ may lie.
std::vector<fs::path> dataFolders() {
  std::vector<fs::path> folders{UNDERWAY_DATA_DIR};
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    folders.push_back(program.parent_path() / "../share/underway");
    folders.push_back(program.parent_path());
  }
  return folders;
}

}  // namespace

Expected<fs::path> findRobotFile(const std::string& robot) {
  std::error_code ignored;  // a path that cannot be looked at is no file to us
  if (fs::is_regular_file(robot, ignored)) return fs::path(robot);
  const bool is_path = robot.find('/') != std::string::npos || fs::path(robot).has_extension();
  if (is_path) return fail(ErrorCode::kInvalidRobot, "robot file \"" + robot + "\" does not exist");
  std::string places;
  for (const fs::path& folder : dataFolders()) {
    const fs::path file = folder / "robots" / (robot + ".yaml");
    if (fs::is_regular_file(file, ignored)) return file;
    places += (places.empty() ? "" : ", ") + file.lexically_normal().string();
  }
  return fail(ErrorCode::kInvalidRobot,
              "robot \"" + robot + "\" is neither a file nor one that comes along; looked at " + places);
}

Expected<fs::path> findDataFolder() {
  std::error_code ignored;
  for (const fs::path& folder : dataFolders())
    if (fs::is_directory(folder / "maps", ignored) && fs::is_directory(folder / "robots", ignored))
      return folder;
  return fail(ErrorCode::kInternal,
              "the maps/ and robots/ that come along are neither in the source tree nor installed");
}

Expected<Site> readSite(const MapArguments& map, const std::string& robot) {
  if (map.file.empty()) return fail(ErrorCode::kInvalidRequest, "--map is missing; name a map file");
  Expected<Map> read = readMap(map.file, map.options);
  if (!read) return tl::unexpected(read.error());
  const Expected<fs::path> file = findRobotFile(robot);
  if (!file) return tl::unexpected(file.error());
  Expected<Robot> body = readRobot(*file);
  if (!body) return tl::unexpected(body.error());
  return Site{std::make_shared<const World>(std::move(read->world)),
              std::make_shared<const Robot>(std::move(*body)), std::move(read->queries)};
}

Expected<QueryArguments> queryNamed(const std::string& name, const std::vector<Query>& queries,
                                    QueryArguments arguments) {
  const auto query =
      std::find_if(queries.begin(), queries.end(), [&](const Query& q) { return q.name == name; });
  if (query == queries.end()) {
    std::string known;
    for (const Query& one : queries) known += (known.empty() ? "" : ", ") + one.name;
    return fail(ErrorCode::kInvalidRequest,
                "--query: the map has no query \"" + name + "\"; it has " + (known.empty() ? "none" : known));
  }
  arguments.start = query->start;
  arguments.start_mode = query->start_mode;
  arguments.goals = {Goal{query->goal, query->goal_yaw}};
  arguments.goal_mode = query->goal_mode;
  return arguments;
}

Expected<FollowedPlan> readFollowed(const FollowArguments& arguments, const Robot& robot) {
  const Expected<std::string> text = readText(arguments.file());
  if (!text) return tl::unexpected(text.error());
  Expected<PlanDocument> document = planFromJson(*text, robot);
  if (!document)
    return fail(document.error().code, "\"" + arguments.file() + "\": " + document.error().message);
  if (!document->answer)
    return fail(ErrorCode::kInvalidRequest, "\"" + arguments.file() + "\" holds no plan but a failure (" +
                                                std::string(name(document->answer.error().code)) +
                                                "); nobody can follow it");
  const std::size_t segments = document->answer->segments.size();
  if (arguments.segment > std::max<std::size_t>(segments, 1))
    return fail(ErrorCode::kInvalidRequest, "--segment: the plan has " + std::to_string(segments) +
                                                " segments; " + std::to_string(arguments.segment) +
                                                " is not one of them");
  Executing executing{*document->answer, segments == 0 ? 0 : arguments.segment - 1, arguments.done};
  return FollowedPlan{std::move(*document), std::move(executing)};
}

Request requestOf(const FollowedPlan& followed, const QueryArguments& query, const Robot& robot) {
  Request request = followed.document.request;
  const Onward from = onward(followed.executing, robot);
  request.start = query.start.value_or(from.start);
  request.start_mode = from.mode;
  if (query.goals.empty()) return request;
  std::vector<Goal> goals = query.goals;
  for (Goal& goal : goals) goal.mode = request.goal_mode;
  return withGoals(std::move(request), goals);
}

}  // namespace underway
