#pragma once

#include <optional>
#include <vector>

#include "gait/crawl/posture.hpp"

namespace underway::gait {

/// Turns postures into rows of a joint table, and watches the joints' limits: angles, and speeds from row to
/// row. The first violation stays; rows after it are not written.
class MotionWriter {
 public:
  explicit MotionWriter(const Crawler& crawler);

  /// `time_s` rises from call to call.
  void write(double time_s, const Posture& posture);
  /// Notes an infeasible posture as a violation.
  void refuse(double time_s, const Infeasible& why);

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  /// The motion, or the first violation.
  [[nodiscard]] GaitExpected<JointTable> finish() &&;

 private:
  void put(std::size_t column, double time_s, const MappedJoint& joint, double crawl_rad);
  void checkSpeed(double time_s, std::size_t column, const MappedJoint& joint);

  const Crawler& crawler_;
  JointTable table_;
  std::vector<double> row_rad_;
  std::optional<GaitError> error_;
};

}  // namespace underway::gait
