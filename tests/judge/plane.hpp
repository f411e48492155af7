#pragma once

#include <vector>

/// The judge of plan files: shares no code with what it judges, and prefers the obvious to the fast.
namespace judge {

/// A point or a vector in the plane [m].
struct Vec2 {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const Vec2&) const = default;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
double norm(Vec2 a);
/// Turned counter-clockwise about the origin [rad].
Vec2 rotated(Vec2 a, double angle_rad);

/// Position [m] and heading [rad].
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
  bool operator==(const Pose&) const = default;
  [[nodiscard]] Vec2 position() const { return {x, y}; }
};

/// A point given in the frame of `pose`, in the frame `pose` is given in.
Vec2 placed(const Pose& pose, Vec2 local);
/// The same angle in [-pi, pi] [rad].
double wrapped(double angle_rad);

/// A convex polygon, counter-clockwise. May be a line (two corners) or a point (one): such obstacles block as
/// well.
using Polygon = std::vector<Vec2>;

/// The smallest convex polygon that holds the points.
Polygon convexHull(std::vector<Vec2> points);

/// How far a point is from a convex polygon, 0 inside or on the edge [m].
double distance(Vec2 point, const Polygon& polygon);
/// How far two convex polygons are apart, 0 if they overlap or touch [m].
double distance(const Polygon& a, const Polygon& b);

/// A circle that holds a polygon, to tell cheaply what is far away.
struct Circle {
  Vec2 center;
  double radius = 0.0;
};
Circle circleRound(const Polygon& polygon);

/// A rectangle along the axes of a body frame: [x_min, x_max] by [y_min, y_max] [m].
struct Rect {
  double x_min = 0.0;
  double x_max = 0.0;
  double y_min = 0.0;
  double y_max = 0.0;
  [[nodiscard]] Rect grown(double by_x, double by_y) const {
    return {x_min - by_x, x_max + by_x, y_min - by_y, y_max + by_y};
  }
};
/// The rectangle's corners where the pose puts them, counter-clockwise.
Polygon placed(const Pose& pose, const Rect& rect);

}  // namespace judge
