#include "bench/physics.hpp"

#include <array>
#include <system_error>

#include "bench/physics_parts.hpp"
#include "gait/crawl/library.hpp"
#include "sim/physics/scene.hpp"

namespace underway::bench {

namespace {

struct Part {
  const char* name;
  void (*measure)(const PhysicsRun&);
  double share;  ///< of the time all parts take, about
};

constexpr std::array kParts{Part{"gaits", measureGaits, 0.10}, Part{"lines", measureLines, 0.30},
                            Part{"journeys", measureJourneys, 0.20}, Part{"missions", measureMissions, 0.20},
                            Part{"torques", measureTorques, 0.20}};

bool isAsked(const Part& part, const PhysicsOptions& options) {
  return options.only.empty() || options.only == part.name;
}

Expected<std::vector<gait::GaitFile>> readLibrary(const std::filesystem::path& folder) {
  std::vector<gait::GaitFile> library;
  for (const std::string& name : gait::gaitNames(folder)) {
    auto file = gait::readGait(folder, name);
    if (!file) return fail(ErrorCode::kInvalidRobot, file.error().message);
    library.push_back(std::move(*file));
  }
  return library;
}

}  // namespace

std::vector<std::string> physicsParts() {
  std::vector<std::string> names;
  for (const Part& part : kParts) names.emplace_back(part.name);
  return names;
}

void PhysicsRun::tell(const std::string& what, double value, const std::string& unit) const {
  report.rows.push_back({what, value, unit, "", std::nullopt, seeds.front(), seeds.size(), {}, {}});
}

void PhysicsRun::ask(const std::string& what, double value, const std::string& unit, const std::string& goal,
                     bool met) const {
  report.rows.push_back({what, value, unit, goal, met, seeds.front(), seeds.size(), {}, {}});
}

Expected<Report> physics(const PhysicsOptions& options, const std::function<void(double)>& progress) {
  constexpr std::uint64_t kSeeds = 20;
  const auto robot = options.data / "robots" / "nao.xml";
  if (const auto model = underway::physics::makeModel(robot, {}, 1.0); !model)
    return tl::unexpected(model.error());
  if (!options.pictures.empty()) {
    std::error_code failed;
    std::filesystem::create_directories(options.pictures, failed);
    if (failed)
      return fail(ErrorCode::kInvalidRequest,
                  options.pictures + ": cannot be made a folder for pictures (" + failed.message() + ")");
  }
  auto library = readLibrary(options.data / "gaits");
  if (!library) return tl::unexpected(library.error());
  Report report{"physics", {}};
  PhysicsRun run{robot, std::move(*library), {}, options.pictures, {}, report};
  for (std::uint64_t seed = 0; seed < kSeeds; seed += options.quick ? 6 : 1) run.seeds.push_back(seed);
  double whole = 0.0;
  for (const Part& part : kParts) whole += isAsked(part, options) ? part.share : 0.0;
  double done = 0.0;
  for (const Part& part : kParts) {
    if (!isAsked(part, options)) continue;
    run.progress = [&](double of_part) { progress((done + part.share * of_part) / whole); };
    part.measure(run);
    done += part.share;
  }
  return report;
}

}  // namespace underway::bench
