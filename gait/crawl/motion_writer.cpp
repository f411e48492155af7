#include "gait/crawl/motion_writer.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace underway::gait {
namespace {

constexpr double kTolerance_rad = 1e-9;
constexpr double kTolerance = 1e-6;  ///< of speeds, a share

}  // namespace

MotionWriter::MotionWriter(const Crawler& crawler)
    : crawler_(crawler), table_(crawler.joints()), row_rad_(table_.joints().size()) {
  const std::size_t first = row_rad_.size() - crawler.held.size();
  for (std::size_t i = 0; i < crawler.held.size(); ++i) row_rad_[first + i] = crawler.held[i].angle_rad;
}

void MotionWriter::write(double time_s, const Posture& posture) {
  std::size_t column = 0;
  Feasible<SideAngles> angles;
  for (std::size_t side = 0; side < 2; ++side) {
    if (side == 0 || posture.sides[1] != posture.sides[0]) angles = anglesOf(crawler_, posture.sides[side]);
    if (!angles) return refuse(time_s, angles.error());
    for (std::size_t joint = 0; joint < kCrawlJoints; ++joint, ++column)
      put(column, time_s, crawler_.sides[side][joint], (*angles)[joint]);
  }
  // The head does what it can: nothing hangs on it.
  if (crawler_.head) {
    const MappedJoint& head = *crawler_.head;
    put(column, time_s, head, std::clamp(posture.head_rad, head.lower(), head.upper()));
  }
  if (!failed()) table_.append(time_s, row_rad_);
}

void MotionWriter::refuse(double time_s, const Infeasible& why) {
  if (!failed())
    error_ =
        GaitError{fmt::format("at {:.2f} s the pose cannot be taken: {}; change the toes' distance from "
                              "the elbows, the spread or the push's angles",
                              time_s, why.sentence())};
}

void MotionWriter::put(std::size_t column, double time_s, const MappedJoint& joint, double crawl_rad) {
  if (failed()) return;
  const double angle_rad = joint.toRobot(crawl_rad);
  const JointLimits& limits = joint.limits;
  row_rad_[column] = std::clamp(angle_rad, limits.lower_rad, limits.upper_rad);
  if (std::abs(row_rad_[column] - angle_rad) > kTolerance_rad) {
    error_ = GaitError{fmt::format(
        "at {:.2f} s {} would be at {:.2f} degrees, and can go from {:.2f} to {:.2f}; "
        "change the toes' distance from the elbows or the push's angles",
        time_s, joint.name, degrees(angle_rad), degrees(limits.lower_rad), degrees(limits.upper_rad))};
    return;
  }
  checkSpeed(time_s, column, joint);
}

void MotionWriter::checkSpeed(double time_s, std::size_t column, const MappedJoint& joint) {
  if (table_.empty()) return;
  const std::size_t last = table_.rows() - 1;
  const double speed_radps =
      std::abs(row_rad_[column] - table_.angles(last)[column]) / (time_s - table_.time(last));
  if (speed_radps > joint.limits.speed_radps * (1.0 + kTolerance))
    error_ =
        GaitError{fmt::format("at {:.2f} s {} would turn at {:.2f} rad/s, and can at {:.2f}; give the motion "
                              "more time",
                              time_s, joint.name, speed_radps, joint.limits.speed_radps)};
}

GaitExpected<JointTable> MotionWriter::finish() && {
  if (error_) return tl::unexpected(*error_);
  return std::move(table_);
}

}  // namespace underway::gait
