#include "sim/physics/shapes.hpp"

#include <mujoco/mujoco.h>

#include <cmath>
#include <limits>

namespace underway::physics {
namespace {

/// How far a shape reaches from its middle along a direction of length 1.
double reach(const mjModel& model, const mjData& data, int geom, const double direction[3]) {
  const double* size = model.geom_size + 3 * geom;
  double local[3];
  mju_rotVecMatT(local, direction, data.geom_xmat + 9 * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return size[0];
    case mjGEOM_CAPSULE:
      return size[0] + size[1] * std::abs(local[2]);
    default:  // a box
      return size[0] * std::abs(local[0]) + size[1] * std::abs(local[1]) + size[2] * std::abs(local[2]);
  }
}

Range extent(const mjModel& model, const mjData& data, const double direction[3]) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_bodyid[geom] == 0) continue;  // the world's own
    const double middle = mju_dot3(data.geom_xpos + 3 * geom, direction);
    const double half = reach(model, data, geom, direction);
    range = hull(range, {middle - half, middle + half});
  }
  return range;
}

Range shifted(Range range, double by) { return {range.min - by, range.max - by}; }

}  // namespace

BodyBox enclose(const mjModel_& model, const mjData_& data, const Pose& frame) {
  const double c = std::cos(frame.yaw);
  const double s = std::sin(frame.yaw);
  const double forward[3] = {c, s, 0.0};
  const double left[3] = {-s, c, 0.0};
  const double up[3] = {0.0, 0.0, 1.0};
  return {shifted(extent(model, data, forward), c * frame.x + s * frame.y),
          shifted(extent(model, data, left), -s * frame.x + c * frame.y), extent(model, data, up)};
}

}  // namespace underway::physics
