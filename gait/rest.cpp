#include "gait/rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace underway::gait {
namespace {

using Eigen::Vector3d;

constexpr double kTouches_m = 2e-4;
constexpr double kStep_rad = 0.01;

struct LinkBall {
  std::size_t link;
  Ball in_root;
};

std::vector<LinkBall> ballsByLink(const Skeleton& skeleton, const Placements& placements) {
  std::vector<LinkBall> balls;
  for (std::size_t i = 0; i < placements.size(); ++i)
    for (const Ball& ball : skeleton.links[i].shape)
      balls.push_back({i, {placements[i] * ball.center, ball.radius_m}});
  if (balls.empty()) throw std::invalid_argument("a robot without a shape cannot lie on a floor");
  return balls;
}

/// The floor's axes in the frame of a root that is pitched.
Vector3d upIn(double pitch_rad) { return {-std::sin(pitch_rad), 0.0, std::cos(pitch_rad)}; }
Vector3d aheadIn(double pitch_rad) { return {std::cos(pitch_rad), 0.0, std::sin(pitch_rad)}; }

double bottom(const Ball& ball, const Vector3d& up) { return up.dot(ball.center) - ball.radius_m; }

double lowest(const std::vector<LinkBall>& balls, const Vector3d& up) {
  double height_m = std::numeric_limits<double>::infinity();
  for (const LinkBall& ball : balls) height_m = std::min(height_m, bottom(ball.in_root, up));
  return height_m;
}

/// How far the centre of mass is ahead of the lowest ball [m]: positive tips the robot forward.
double overhang(const std::vector<LinkBall>& balls, const Vector3d& center, double pitch_rad) {
  const Vector3d up = upIn(pitch_rad);
  const auto lowest_ball =
      std::ranges::min_element(balls, {}, [&](const LinkBall& ball) { return bottom(ball.in_root, up); });
  return aheadIn(pitch_rad).dot(center - lowest_ball->in_root.center);
}

/// The pitch at which the overhang changes from forward to backward, downhill from a first pitch.
double restingPitch(const std::vector<LinkBall>& balls, const Vector3d& center, double pitch_rad) {
  const double step_rad = overhang(balls, center, pitch_rad) > 0.0 ? kStep_rad : -kStep_rad;
  double far_rad = pitch_rad;
  double near_rad = pitch_rad;
  for (int i = 0; i < 700 && overhang(balls, center, far_rad) * step_rad > 0.0; ++i) {
    near_rad = far_rad;
    far_rad += step_rad;
  }
  for (int i = 0; i < 60; ++i) {
    const double middle_rad = 0.5 * (near_rad + far_rad);
    (overhang(balls, center, middle_rad) * step_rad > 0.0 ? near_rad : far_rad) = middle_rad;
  }
  return far_rad;
}

/// Corners of the hull of points on the floor, counter-clockwise.
std::vector<Vector3d> hullOf(std::vector<Vector3d> points) {
  std::ranges::sort(points, [](const Vector3d& a, const Vector3d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  const auto turn = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return (b - a).cross(c - a).z();
  };
  std::vector<Vector3d> hull;
  const auto half = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto point = begin; point != end; ++point) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), *point) <= 0.0)
        hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();
  };
  half(points.begin(), points.end());
  half(points.rbegin(), points.rend());
  return hull;
}

double marginOf(const std::vector<Contact>& contacts, const Vector3d& center) {
  std::vector<Vector3d> points;
  for (const Contact& contact : contacts)
    points.emplace_back(contact.on_floor.x(), contact.on_floor.y(), 0.0);
  const std::vector<Vector3d> hull = hullOf(std::move(points));
  if (hull.size() < 3) return 0.0;
  double margin_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector3d side = hull[(i + 1) % hull.size()] - hull[i];
    const Vector3d to = {center.x() - hull[i].x(), center.y() - hull[i].y(), 0.0};
    margin_m = std::min(margin_m, side.cross(to).z() / side.norm());
  }
  return margin_m;
}

void enclose(const std::vector<LinkBall>& balls, const Eigen::Isometry3d& placement, Rest& rest) {
  rest.low.setConstant(std::numeric_limits<double>::infinity());
  rest.high = -rest.low;
  for (const LinkBall& ball : balls) {
    const Vector3d center = placement * ball.in_root.center;
    rest.low = rest.low.cwiseMin((center.array() - ball.in_root.radius_m).matrix());
    rest.high = rest.high.cwiseMax((center.array() + ball.in_root.radius_m).matrix());
  }
}

Rest settle(const Skeleton& skeleton, const Placements& placements, double pitch_rad) {
  const std::vector<LinkBall> balls = ballsByLink(skeleton, placements);
  const Vector3d center = massCenterOf(skeleton, placements);
  Rest rest;
  rest.pitch_rad = restingPitch(balls, center, pitch_rad);
  const Vector3d up = upIn(rest.pitch_rad);
  const double lowest_m = lowest(balls, up);
  rest.root = {0.0, 0.0, -lowest_m};
  const Eigen::Isometry3d placement = rest.placement();
  rest.mass_center = placement * center;
  for (const LinkBall& ball : balls) {
    if (bottom(ball.in_root, up) - lowest_m > kTouches_m) continue;
    const Vector3d touching = ball.in_root.center - ball.in_root.radius_m * up;
    rest.contacts.push_back({ball.link, placements[ball.link].inverse() * touching, placement * touching});
  }
  rest.margin_m = marginOf(rest.contacts, rest.mass_center);
  enclose(balls, placement, rest);
  return rest;
}

/// The contact farthest to the end that bears more of the weight: by the lever's law, the nearer one.
const Contact& anchorOf(const Rest& rest) {
  const auto [behind, ahead] = std::ranges::minmax_element(
      rest.contacts, {}, [](const Contact& contact) { return contact.on_floor.x(); });
  const double x = rest.mass_center.x();
  return ahead->on_floor.x() - x < x - behind->on_floor.x() ? *ahead : *behind;
}

void shift(Rest& rest, double by_m) {
  for (Vector3d* point : {&rest.root, &rest.mass_center, &rest.low, &rest.high}) point->x() += by_m;
  for (Contact& contact : rest.contacts) contact.on_floor.x() += by_m;
}

std::vector<std::size_t> columnsOf(const Skeleton& skeleton, const JointTable& table) {
  std::vector<std::size_t> columns;
  for (const std::string& joint : skeleton.joints()) {
    const auto column = table.find(joint);
    if (!column) throw std::invalid_argument("a motion does not say where " + joint + " is");
    columns.push_back(*column);
  }
  return columns;
}

}  // namespace

Eigen::Isometry3d Rest::placement() const {
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  placement.translate(root);
  placement.rotate(Eigen::AngleAxisd(pitch_rad, Vector3d::UnitY()));
  return placement;
}

Rest settle(const Skeleton& skeleton, const std::vector<double>& angles_rad, double pitch_rad) {
  return settle(skeleton, placementsOf(skeleton, angles_rad), pitch_rad);
}

std::vector<Rest> settleAll(const Skeleton& skeleton, const JointTable& table, double pitch_rad) {
  const std::vector<std::size_t> columns = columnsOf(skeleton, table);
  std::vector<double> angles_rad(columns.size());
  std::vector<Rest> rests;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::ranges::transform(columns, angles_rad.begin(), [&](std::size_t c) { return table.angles(row)[c]; });
    const Placements placements = placementsOf(skeleton, angles_rad);
    Rest rest = settle(skeleton, placements, pitch_rad);
    if (!rests.empty()) {
      const Contact& anchor = anchorOf(rests.back());
      const Vector3d now = rest.placement() * (placements[anchor.link] * anchor.on_link);
      shift(rest, anchor.on_floor.x() - now.x());
    }
    pitch_rad = rest.pitch_rad;
    rests.push_back(std::move(rest));
  }
  return rests;
}

}  // namespace underway::gait
