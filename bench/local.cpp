#include "bench/local.hpp"

#include <algorithm>
#include <array>

#include "bench/local_parts.hpp"
#include "geometry/map.hpp"

namespace underway::bench {
namespace {

struct Part {
  std::string_view name;
  Expected<void> (*add)(const LocalBench&, Report&);
  bool is_on_maps = false;
};
constexpr std::array kParts{Part{"heading", addHeading},   Part{"pure", addPure},
                            Part{"plans", addPlans, true}, Part{"unmapped", addUnmapped, true},
                            Part{"tight", addTight},       Part{"blocked", addBlocked, true}};

}  // namespace

void Collisions::count(bool has_collided, bool is_disputed) {
  ++runs;
  collided += has_collided ? 1 : 0;
  disputed += is_disputed ? 1 : 0;
}

void Collisions::addRows(const std::string& what, Report& report) const {
  const auto add = [&](const std::string& does, unsigned long count) {
    report.rows.push_back(
        {what + ": " + does, static_cast<double>(count), "runs", "0", count == 0, 1, runs, {}, {}});
  };
  add("collide, by either judge", collided);
  add("the judges disagree", disputed);
}

std::vector<std::filesystem::path> LocalBench::maps(std::span<const char* const> names) const {
  if (!options.map.empty()) return {options.map};
  std::vector<std::filesystem::path> files;
  files.reserve(names.size());
  for (const char* name : names) files.push_back(options.data / "maps" / (std::string(name) + ".yaml"));
  return files;
}

bool isOnMaps(std::string_view part) {
  return std::ranges::any_of(kParts, [&](const Part& it) { return it.name == part && it.is_on_maps; });
}

std::vector<std::string> localParts() {
  std::vector<std::string> names;
  names.reserve(kParts.size());
  for (const Part& part : kParts) names.emplace_back(part.name);
  return names;
}

Expected<Report> local(const LocalOptions& options, const std::function<void(double)>& progress,
                       const std::function<void(const std::string&)>& tell) {
  auto robot = readRobot(options.data / "robots" / "nao.yaml");
  if (!robot) return tl::unexpected(robot.error());
  const LocalBench bench{options, std::make_shared<const Robot>(std::move(*robot)), progress, tell};
  Report report{"local", {}};
  bool is_known = options.only.empty();
  for (const Part& part : kParts) {
    if (!options.only.empty() && options.only != part.name) continue;
    is_known = true;
    if (const auto added = part.add(bench, report); !added) return tl::unexpected(added.error());
  }
  if (!is_known)
    return fail(ErrorCode::kInvalidRequest, "the local layer's benchmark has no part '" + options.only + "'");
  for (Row& row : report.rows) row.seed = options.seed;
  return report;
}

}  // namespace underway::bench
