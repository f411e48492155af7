#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.hpp"
#include "apps/deliver.hpp"
#include "apps/inputs.hpp"
#include "apps/plan_table.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway query --map maps/scenario3.yaml --pose 3.5,2,0\n"
    "  underway query --map maps/scenario3.yaml --robot nao_obb_paper --pose 3.5,2,0 --json -";

struct Arguments {
  MapArguments map;
  std::string robot;
  std::optional<Pose> pose;
  std::string json;
};

/// What one mode may do at the pose.
struct Judgement {
  std::string mode;
  std::string state;  ///< "free", "inside_margin", "touching" or "out_of_bounds"
  Closeness closeness;
  std::vector<std::string> hit;  ///< obstacles that the body, grown by the margin, touches
};

Judgement judge(const Checker& checker, ModeId mode, const Pose& pose) {
  const Motion motion = stay(mode, pose);
  const double margin_m = checker.robot().margin_m;
  Judgement judgement{checker.robot().modes[mode].name, "free", checker.closeness(motion, kClearanceCap_m),
                      checker.blockers(motion, margin_m)};
  if (!checker.isInBounds(motion))
    judgement.state = "out_of_bounds";
  else if (!checker.isFree(motion, 0.0))
    judgement.state = "touching";
  else if (!checker.isFree(motion, margin_m))
    judgement.state = "inside_margin";
  return judgement;
}

std::string joined(const std::vector<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids) text += (text.empty() ? "" : ", ") + id;
  return text.empty() ? "-" : text;
}

std::string tableOf(const std::vector<Judgement>& judgements) {
  constexpr auto kRight = Table::Align::kRight;
  Table table({{"mode"},
               {"state"},
               {"clearance m", kRight},
               {"headroom m", kRight},
               {"nearest"},
               {"at x,y"},
               {"hit"}});
  for (const Judgement& one : judgements) {
    const auto& [clearance_m, nearest, headroom_m] = one.closeness;
    table.add({{one.mode},
               {one.state, one.state == "free" ? "32" : "31"},
               {(nearest ? "" : ">= ") + fixed(clearance_m, 3)},
               {headroom_m ? fixed(*headroom_m, 3) : "-"},
               {nearest ? nearest->id : "-"},
               {nearest ? fixed(nearest->at.x, 3) + "," + fixed(nearest->at.y, 3) : "-"},
               {joined(one.hit)}});
  }
  return table.text(wantsColour());
}

std::string jsonOf(const Checker& checker, const Pose& pose, const std::vector<Judgement>& judgements) {
  using Json = nlohmann::ordered_json;
  Json modes = Json::array();
  for (const Judgement& one : judgements) {
    const auto& [clearance_m, nearest, headroom_m] = one.closeness;
    Json mode{{"mode", one.mode},
              {"free", one.state == "free"},
              {"state", one.state},
              {"clearance_m", clearance_m}};
    mode["headroom_m"] = headroom_m ? Json(*headroom_m) : Json(nullptr);
    mode["nearest"] = nullptr;
    if (nearest) mode["nearest"] = {{"id", nearest->id}, {"x", nearest->at.x}, {"y", nearest->at.y}};
    mode["hit"] = one.hit;
    modes.push_back(mode);
  }
  const Json document{{"robot", checker.robot().name},
                      {"map", checker.world().name()},
                      {"pose", {{"x", pose.x}, {"y", pose.y}, {"yaw", pose.yaw}}},
                      {"margin_m", checker.robot().margin_m},
                      {"modes", modes}};
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

ExitCode run(const Arguments& arguments) {
  const Expected<Site> site = readSite(arguments.map, arguments.robot);
  if (!site) {
    complain(site.error().message);
    return exitCodeOf(site.error().code);
  }
  const Checker checker(site->world, site->robot);
  std::vector<Judgement> judgements;
  for (std::size_t mode = 0; mode < site->robot->modes.size(); ++mode)
    judgements.push_back(judge(checker, static_cast<ModeId>(mode), *arguments.pose));
  return deliverFigures(tableOf(judgements), jsonOf(checker, *arguments.pose, judgements), arguments.json);
}

}  // namespace

Subcommand addQueryCommand(CLI::App& program) {
  CLI::App& command =
      *program.add_subcommand("query", "Judge one pose in every mode: free, how close, what is hit");
  const auto arguments = std::make_shared<Arguments>();
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  addPose(command, "--pose", arguments->pose, "Pose to judge [m, m, rad]")->required();
  addOutputFile(command, "--json", arguments->json, "FILE|-", "Write the judgement; - for standard output");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
