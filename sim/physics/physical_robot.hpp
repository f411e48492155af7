#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <random>
#include <set>
#include <string>

#include "local/gait_runner.hpp"
#include "sim/physics/simulation.hpp"
#include "sim/sensors.hpp"

namespace underway::physics {

/// What only the judge knows.
struct PhysicalTruth {
  Pose pose;  ///< of the body frame of the mode; in a switch, of the mode it comes from
  ModeId mode = 0;
  bool is_upright = true;         ///< or lies as its mode does; false: it fell over
  std::set<std::string> touches;  ///< "LForeArm on obstacle 5": what touched anything but the floor
};

/// A robot whose lying down, crawling and getting up are physics: the executor's commands become joint angles
/// (local/gait_runner.hpp), MuJoCo does the rest, and what touches what is for MuJoCo to say. Steered by its
/// own inertial heading. Walking is no matter of this: a standing robot is carried as it is told to walk,
/// within its limits and with the drift of its heading, its feet on the floor.
///
/// Senses as those of sim::SimulatedRobot; the inertial heading is the simulation's, which runs off slowly.
/// The same seed and commands give the same run, on one machine.
class PhysicalRobot {
 public:
  /// It stands at `start`, in the first mode. Errors: as of Simulation::make. Throws std::invalid_argument
  /// when NAO cannot crawl that gait.
  [[nodiscard]] static Expected<PhysicalRobot> make(const std::filesystem::path& model, const World& truth,
                                                    std::shared_ptr<const Robot> robot, const Pose& start,
                                                    const gait::CrawlGait& gait, const Conditions& conditions,
                                                    const sim::Flaws& flaws = {});

  /// What its senses tell now; the scan is kept in the robot until the next call.
  [[nodiscard]] const Senses& sense();
  /// Does what it is told for one tick.
  void step(const Command& command);

  [[nodiscard]] const PhysicalTruth& truth() const { return truth_; }
  [[nodiscard]] double now_s() const { return static_cast<double>(ticks_) * sim::Sensors::kTick_s; }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }

 private:
  PhysicalRobot(Simulation simulation, GaitRunner runner, const World& truth,
                std::shared_ptr<const Robot> robot, const Pose& start, const Conditions& conditions,
                const sim::Flaws& flaws);
  void walk(const Velocity& velocity);
  void observe();
  [[nodiscard]] double heading() const;

  Simulation simulation_;
  GaitRunner runner_;
  std::shared_ptr<const Robot> robot_;
  sim::Sensors sensors_;
  SpeedLimits limits_;
  double start_rad_;  // the heading that the inertial one was zero at
  double drift_rad_per_m_ = 0.0;
  std::mt19937_64 random_;
  PhysicalTruth truth_;
  std::uint64_t ticks_ = 0;
  Senses senses_;
};

}  // namespace underway::physics
