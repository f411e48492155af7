#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/report.hpp"
#include "gait/crawl/gait_file.hpp"

namespace underway::bench {

/// What the parts of the physics bench share.
struct PhysicsRun {
  std::filesystem::path robot;
  std::vector<gait::GaitFile> library;
  std::vector<std::uint64_t> seeds;
  std::string pictures;
  std::function<void(double)> progress;  ///< of the part, 0 to 1
  Report& report;

  /// A figure with nothing asked of it.
  void tell(const std::string& what, double value, const std::string& unit) const;
  /// A figure that should lie in a range; `goal` says it to people.
  void ask(const std::string& what, double value, const std::string& unit, const std::string& goal,
           bool met) const;
};

/// Advance, height and drift of the gaits; slopes; curves.
void measureGaits(const PhysicsRun& run);
/// 2 m, heading kept from the IMU and not.
void measureLines(const PhysicsRun& run);
/// Down, under a table, up: what robots/nao.yaml holds, and whether anything was touched.
void measureJourneys(const PhysicsRun& run);
/// The executor's own missions through our maps, the gaits played in physics.
void measureMissions(const PhysicsRun& run);
/// Torques in the push at ten durations, of all gaits of the library.
void measureTorques(const PhysicsRun& run);

}  // namespace underway::bench
