#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/error.hpp"

// MuJoCo's own types, known by name only: its headers stay in sim/physics/*.cpp.
struct mjModel_;
struct mjData_;

namespace underway::physics {

/// The ground a robot is on, in the frame of the ground: z is its normal. A slope is gravity that leans.
struct Ground {
  double uphill_rad = 0.0;    ///< how much the ground rises towards +x [rad]
  double leftward_rad = 0.0;  ///< and towards +y [rad]
};

/// What the robot is among: ground, and obstacles that do not move.
struct Scene {
  Ground ground;
  std::vector<OrientedBox> obstacles;  ///< in the frame of the ground [m]
};

struct ModelDeleter {
  void operator()(mjModel_* model) const;
};
struct DataDeleter {
  void operator()(mjData_* data) const;
};
using Model = std::unique_ptr<mjModel_, ModelDeleter>;
using Data = std::unique_ptr<mjData_, DataDeleter>;

/// Robot and scene as one model. `robot` is an MJCF file such as robots/nao.xml. Errors: kInvalidRobot when
/// it cannot be read or MuJoCo refuses it. `friction`: Coulomb's coefficient, of every contact with ground
/// and obstacles.
[[nodiscard]] Expected<Model> makeModel(const std::filesystem::path& robot, const Scene& scene,
                                        double friction);

}  // namespace underway::physics
