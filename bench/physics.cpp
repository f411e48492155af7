#include "bench/physics.hpp"

#include <array>
#include <system_error>

#include "bench/physics_parts.hpp"
#include "sim/physics/scene.hpp"

namespace underway::bench {

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
  Report report{"physics", {}};
  PhysicsRun run{robot, {}, options.pictures, {}, report};
  for (std::uint64_t seed = 0; seed < kSeeds; seed += options.quick ? 6 : 1) run.seeds.push_back(seed);
  // How long each part takes, about, of the whole.
  const std::array<std::pair<void (*)(const PhysicsRun&), double>, 4> parts{
      {{measureGaits, 0.15}, {measureLines, 0.40}, {measureJourneys, 0.35}, {measureTorques, 0.10}}};
  double done = 0.0;
  for (const auto& [measure, share] : parts) {
    run.progress = [&, share = share](double of_part) { progress(done + share * of_part); };
    measure(run);
    done += share;
  }
  return report;
}

}  // namespace underway::bench
