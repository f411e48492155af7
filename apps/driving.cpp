#include "apps/driving.hpp"

#include "apps/table.hpp"
#include "geometry/checker.hpp"

namespace underway {

void addTruth(CLI::App& command, TruthArguments& arguments) {
  command
      .add_option("--truth", arguments.map,
                  "A scenario with the world as it is, with things that the map does not have (the map)")
      ->type_name("FILE");
  addObstacles(command, "--unmapped", arguments.unmapped,
               "A thing that is there and not in the map: middle and full size of a box [m, rad]");
  addNumber(command, "--noise", arguments.noise, 0.01, 10.0, "F",
            "Times the honest noise of sensors and gaits, 0.01 to 10 (1)");
  addWhole(command, "--seed", arguments.seed, "Of the simulated robot's noise (1)");
}

CLI::Option* addRate(CLI::App& command, double& rate, const std::string& help) {
  return addNumber(command, "--rate", rate, 0.01, 1000.0, "F", help);
}

void addQueryName(CLI::App& command, std::string& name) {
  command.add_option("--query", name, "Take start and goal from this query of the scenario")
      ->type_name("NAME")
      ->excludes("--start", "--start-mode", "--goal", "--goal-mode");
}

Expected<std::shared_ptr<const World>> truthOf(const TruthArguments& arguments, const Site& site) {
  World world = *site.world;
  if (!arguments.map.empty()) {
    Expected<Map> read = readMap(arguments.map);
    if (!read) return tl::unexpected(read.error());
    world = std::move(read->world);
  }
  for (const Obstacle& obstacle : arguments.unmapped) {
    Expected<World> with = world.added(obstacle);
    if (!with) return fail(ErrorCode::kInvalidMap, "--unmapped: " + with.error().message);
    world = std::move(*with);
  }
  return std::make_shared<const World>(std::move(world));
}

Expected<void> checkStart(const std::shared_ptr<const World>& truth,
                          const std::shared_ptr<const Robot>& robot, ModeId mode, const Pose& at) {
  const Checker checker(truth, robot);
  const Motion standing = stay(mode, at);
  const std::string where = "the robot at (" + fixed(at.x, 3) + " m, " + fixed(at.y, 3) + " m, " +
                            fixed(at.yaw, 3) + " rad) in mode " + robot->modes[mode].name;
  if (!checker.isInBounds(standing))
    return fail(ErrorCode::kStartOutOfBounds,
                where + " is not wholly inside the world's bounds; move it inside");
  if (checker.isFree(standing, 0.0)) return {};
  return fail(ErrorCode::kStartInCollision, where + " touches " + checker.blockers(standing, 0.0, 1).front() +
                                                "; move it, or choose another mode");
}

}  // namespace underway
