#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/arguments.hpp"
#include "apps/inputs.hpp"
#include "sim/robot.hpp"

namespace underway {

/// The world as it is, and how the robot falls short: what only a simulation knows.
struct TruthArguments {
  std::string map;                 ///< the true world's file; empty: the map
  std::vector<Obstacle> unmapped;  ///< that stand there besides
  double noise = 1.0;              ///< times what is honest
  std::uint64_t seed = 1;          ///< of the noise

  [[nodiscard]] sim::Flaws flaws() const { return sim::Flaws{}.times(noise); }
};
/// --truth, --unmapped, --noise and --seed.
void addTruth(CLI::App& command, TruthArguments& arguments);
/// --rate.
CLI::Option* addRate(CLI::App& command, double& rate, const std::string& help);
/// --query, instead of --start and --goal. After addQuery.
void addQueryName(CLI::App& command, std::string& name);

/// Errors: kInvalidMap, one sentence; kStartInCollision or kStartOutOfBounds if the robot cannot stand there.
[[nodiscard]] Expected<std::shared_ptr<const World>> truthOf(const TruthArguments& arguments,
                                                             const Site& site);
[[nodiscard]] Expected<void> checkStart(const std::shared_ptr<const World>& truth,
                                        const std::shared_ptr<const Robot>& robot, ModeId mode,
                                        const Pose& at);

}  // namespace underway
