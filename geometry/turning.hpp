#pragma once

#include <array>

#include "geometry/convex.hpp"
#include "geometry/sweep.hpp"

namespace underway {

/// How far a body can turn from its heading before it meets something, each way; 2 pi at most [rad].
struct TurningRoom {
  double left_rad = 0.0;   ///< counter-clockwise
  double right_rad = 0.0;  ///< clockwise, as a positive number
};

/// A body that turns about its frame's origin, and everything it covers on the way.
///
/// A convex piece that the body does not touch at first is first met by a corner of one on an edge of the
/// other. A corner of the body moves on an arc about the pivot; seen from the body, so does a corner of the
/// piece. So what is met, and how near what is not met comes, is a matter of arcs and line segments, and
/// exact.
///
/// Thread safety: const members may be called from any number of threads.
class Turning {
 public:
  /// From the body's heading by a signed angle, counter-clockwise positive [rad].
  Turning(const Prism& body, double angle_rad);

  [[nodiscard]] Point pivot() const { return body_.frame.position(); }
  /// No point of the body is further from the pivot [m].
  [[nodiscard]] double outerRadius() const { return outer_m_; }
  /// All points this near to the pivot are covered all the time; 0 if the pivot is not inside the body [m].
  [[nodiscard]] double innerRadius() const { return inner_m_; }

  /// Whether a piece comes nearer than kContact_m on the way; nearer than 3 kContact_m it may be said to.
  [[nodiscard]] bool touches(ConvexView piece) const;
  /// The least gap to a piece on the way, and the piece's point it is at. Never above the truth and at most
  /// 3 kContact_m below; 0 exactly when it touches.
  [[nodiscard]] Gap gapTo(ConvexView piece) const;
  /// Of a whole revolution: how far the body can turn before it touches a piece that it does not touch where
  /// it is. Never more than it truly can; less by 1e-7 rad or so.
  [[nodiscard]] TurningRoom roomBeside(ConvexView piece) const;

 private:
  struct Arc;
  [[nodiscard]] Point inBody(Point map) const;
  [[nodiscard]] Arc arcFrom(Point begin) const;
  [[nodiscard]] Arc arcTo(Point end) const;

  Prism body_;        // at the beginning
  double angle_rad_;  // >= 0: a clockwise turn is looked at in a mirror
  bool is_mirrored_;
  double cos_, sin_;            // of the angle
  double yaw_cos_, yaw_sin_;    // of the first heading
  std::array<Point, 4> first_;  // corners in the map frame, at the beginning
  std::array<Point, 4> last_;   // and at the end
  std::array<Point, 4> local_;  // in the body frame, mirrored if the turn is
  double outer_m_;
  double inner_m_;
};

}  // namespace underway
