#include "local/godzila/beam_pull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "local/godzila/heading.hpp"

// Nothing here, nor in what it includes, is of Eigen, FCL or OMPL: their alignment must not depend on the
// processor that a function is made for.
//
// Made for a plain processor and for one that takes four numbers at once; which, is told when the program is
// loaded. The thread sanitizer cannot be asked so early.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_THREAD__)
#define UNDERWAY_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define UNDERWAY_WIDE
#endif

namespace underway {
namespace {

constexpr std::size_t kBlock = 128;  // beams whose weights are kept on the stack
constexpr std::size_t kAbreast = 8;  // sums that grow side by side: no addition waits for the one before

/// The square of the angle between two directions in (-pi, pi].
inline double squareBetween(double a_rad, double b_rad) {
  const double way = std::abs(a_rad - b_rad);
  const double shorter = std::min(way, 2.0 * std::numbers::pi - way);
  return shorter * shorter;
}

/// exp(-r), off by less than 1e-13 for r up to 10: the first terms of exp(-r / 64), squared six times.
inline double expOfMinus(double r) {
  const double x = r * (-1.0 / 64.0);
  double power = 1.0 / 5040.0;
  power = power * x + 1.0 / 720.0;
  power = power * x + 1.0 / 120.0;
  power = power * x + 1.0 / 24.0;
  power = power * x + 1.0 / 6.0;
  power = power * x + 1.0 / 2.0;
  power = power * x + 1.0;
  power = power * x + 1.0;
  power *= power, power *= power, power *= power;
  power *= power, power *= power, power *= power;
  return power;
}

/// How much a beam pulls the heading to its own bearing.
inline double weightOf(double range_m, double bearing_rad, double goal_rad, double facing_rad,
                       const GodzilaSettings& s) {
  const double range = std::min(range_m, s.farthest_m);
  const double r = std::max(range - s.clearance_threshold_m * expOfMinus(range), kLeastShortened_m);
  const double width = s.bearing_width_rad * s.bearing_width_rad;
  const double to_goal = squareBetween(bearing_rad, goal_rad) + width;  // 1 / L
  const double ahead = squareBetween(bearing_rad, facing_rad) + width;
  // Both ways, and one division for their quotients: a branch would cost more.
  const double repelled =
      -s.obstacle_repulsion * ((1.0 - s.bearing_ratio) * ahead + s.bearing_ratio * to_goal);
  const double steep = r * r * ahead;
  const double attracted = s.obstacle_attraction * r * r;
  const bool is_near = range < s.obstacle_threshold_m;
  return (is_near ? repelled : attracted) / ((is_near ? steep : 1.0) * to_goal);
}

struct Block {
  const float* ranges_m;
  const double* bearings_rad;
  const double* x;
  const double* y;
  std::size_t count;
};

UNDERWAY_WIDE void addBlock(const Block& block, double goal_rad, double facing_rad,
                            const GodzilaSettings& settings, double* __restrict sum_x,
                            double* __restrict sum_y) {
  const GodzilaSettings s = settings;
  std::array<double, kBlock> weights;
  for (std::size_t i = 0; i < block.count; ++i)
    weights[i] = weightOf(block.ranges_m[i], block.bearings_rad[i], goal_rad, facing_rad, s);
  for (std::size_t i = block.count; i % kAbreast != 0; ++i) weights[i] = 0.0;
  for (std::size_t i = 0; i < block.count; i += kAbreast)
    for (std::size_t k = 0; k < kAbreast; ++k) {
      sum_x[k] += weights[i + k] * block.x[i + k];
      sum_y[k] += weights[i + k] * block.y[i + k];
    }
}

}  // namespace

BeamPull::BeamPull(const GodzilaSettings& settings, const Beams& beams) : settings_(settings) {
  const std::size_t whole = (beams.count + kAbreast - 1) / kAbreast * kAbreast;
  x_.assign(whole, 0.0);
  y_.assign(whole, 0.0);
  for (std::size_t i = 0; i < beams.count; ++i) {
    const double bearing = normalizedAngle(beams.bearing(i));
    bearings_rad_.push_back(bearing);
    x_[i] = std::cos(bearing);
    y_[i] = std::sin(bearing);
  }
}

Point BeamPull::of(std::span<const float> ranges_m, double goal_rad, double facing_rad) const {
  std::array<double, kAbreast> x{};
  std::array<double, kAbreast> y{};
  for (std::size_t i = 0; i < bearings_rad_.size(); i += kBlock)
    addBlock({&ranges_m[i], &bearings_rad_[i], &x_[i], &y_[i], std::min(kBlock, bearings_rad_.size() - i)},
             goal_rad, facing_rad, settings_, x.data(), y.data());
  Point sum;
  for (std::size_t k = 0; k < kAbreast; ++k) sum.x += x[k], sum.y += y[k];
  return sum;
}

}  // namespace underway
