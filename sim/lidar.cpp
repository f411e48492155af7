#include "sim/lidar.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/flatten.hpp"

namespace underway::sim {

Lidar::Lidar(const World& world, const LidarSettings& settings) : settings_(settings) {
  for (std::size_t i = 0; i < settings.beams.count; ++i)
    directions_.push_back({std::cos(settings.beams.bearing(i)), std::sin(settings.beams.bearing(i))});
  const Range heights = {world.floorZ() + settings.heights_m.min, world.floorZ() + settings.heights_m.max};
  for (const Obstacle& obstacle : world.obstacles())
    if (auto outline = flattened(obstacle.box, heights); outline.size() > 1)
      outlines_.push_back(std::move(outline));
}

void Lidar::look(const Pose& from, Scan& scan) const {
  scan.beams = settings_.beams;
  scan.ranges_m.assign(settings_.beams.count, Scan::kNothing);
  for (const std::vector<Point>& outline : outlines_) cast(outline, from, scan);
  for (float& range : scan.ranges_m)
    if (range < settings_.nearest_m || range > settings_.farthest_m) range = Scan::kNothing;
}

void Lidar::look(const Pose& from, Scan& scan, std::mt19937_64& random) const {
  look(from, scan);
  std::normal_distribution<double> unit;
  for (float& range : scan.ranges_m) {
    if (range == Scan::kNothing) continue;
    const double truth = range;
    const double sigma = truth < 1.0 ? settings_.sigma_m : settings_.sigma_share * truth;
    range = static_cast<float>(std::max(truth + sigma * unit(random), settings_.nearest_m));
  }
}

void Lidar::cast(const std::vector<Point>& outline, const Pose& from, Scan& scan) const {
  const double c = std::cos(from.yaw);
  const double s = std::sin(from.yaw);
  const auto seen = [&](Point p) {
    return Point{c * (p.x - from.x) + s * (p.y - from.y), c * (p.y - from.y) - s * (p.x - from.x)};
  };
  Point a = seen(outline.back());
  for (const Point corner : outline) {
    const Point b = seen(corner);
    castEdge(a, b, scan);
    a = b;
  }
}

/// Shortens the beams that meet an edge, both ends given in the sensor's frame.
void Lidar::castEdge(Point a, Point b, Scan& scan) const {
  const double turned = a.x * b.y - a.y * b.x;  // twice the area towards the sensor
  if (turned >= 0.0) return;                    // counter-clockwise outlines show their outside clockwise
  const Beams& beams = settings_.beams;
  const double last = std::atan2(a.y, a.x);
  const double span = counterClockwise(std::atan2(b.y, b.x), last);
  const double begin = last - span;
  // The edge may cross the back, where bearings wrap.
  for (const double wrap : {0.0, 2.0 * std::numbers::pi}) {
    const double low = (begin + wrap - beams.first_rad) / beams.step_rad;
    const double high = (last + wrap - beams.first_rad) / beams.step_rad;
    const auto from = static_cast<std::size_t>(std::max(0.0, std::ceil(low)));
    for (std::size_t i = from; i < beams.count && static_cast<double>(i) <= high; ++i) {
      const Point d = directions_[i];
      const double range = turned / (d.x * (b.y - a.y) - d.y * (b.x - a.x));
      if (range >= 0.0 && range < scan.ranges_m[i]) scan.ranges_m[i] = static_cast<float>(range);
    }
  }
}

}  // namespace underway::sim
