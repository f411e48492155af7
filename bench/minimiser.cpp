#include "bench/minimiser.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace underway::bench {
namespace {

using Real = long double;

/// A unit vector that pulls or pushes with a gain: the cost of a heading u is gain |u - at|^2 / 2 if it
/// pulls, gain (4 - |u - at|^2) / 2 if it pushes.
struct Term {
  Real x;
  Real y;
  Real gain;
  bool pushes;
};

Real unitCost(const Term& term, Real x, Real y) {
  const Real dx = x - term.x;
  const Real dy = y - term.y;
  const Real apart = dx * dx + dy * dy;
  return 0.5L * term.gain * (term.pushes ? 4.0L - apart : apart);
}

Real between(double a_rad, double b_rad) {
  return std::abs(std::remainder(static_cast<Real>(a_rad) - b_rad, 2.0L * std::numbers::pi_v<Real>));
}

std::vector<Term> termsOf(const Scan& scan, const Bearing& goal, double facing_rad,
                          const GodzilaSettings& s) {
  const auto towards = [](double angle, Real gain, bool pushes) {
    return Term{std::cos(static_cast<Real>(angle)), std::sin(static_cast<Real>(angle)), gain, pushes};
  };
  const auto closeness = [&](Real angle) {
    return 1.0L / (angle * angle + static_cast<Real>(s.bearing_width_rad) * s.bearing_width_rad);
  };
  std::vector<Term> terms{
      towards(goal.bearing_rad, s.goal_attraction / (static_cast<Real>(goal.range_m) * goal.range_m), false),
      towards(facing_rad, s.inertia, false)};
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double range = std::min(static_cast<double>(scan.ranges_m[i]), s.farthest_m);
    const double bearing = scan.beams.bearing(i);
    const Real r =
        std::max(range - s.clearance_threshold_m * std::exp(static_cast<Real>(-range)), Real{0.02L});
    const Real to_goal = closeness(between(goal.bearing_rad, bearing));
    if (range < s.obstacle_threshold_m) {
      const Real gain =
          s.obstacle_repulsion / (r * r) *
          ((1.0L - s.bearing_ratio) * to_goal + s.bearing_ratio * closeness(between(bearing, facing_rad)));
      terms.push_back(towards(bearing, gain, true));
    } else {
      // (3.10) is subtracted: what it rewards is being near, so far is what costs.
      Term reward = towards(bearing, -s.obstacle_attraction * r * r * to_goal, true);
      terms.push_back(reward);
    }
  }
  return terms;
}

Real sumOf(const std::vector<Term>& terms, Real heading) {
  const Real x = std::cos(heading);
  const Real y = std::sin(heading);
  Real sum = 0.0L;
  for (const Term& term : terms) sum += unitCost(term, x, y);
  return sum;
}

}  // namespace

long double costOf(long double heading_rad, const Scan& scan, const Bearing& goal, double facing_rad,
                   const GodzilaSettings& settings) {
  return sumOf(termsOf(scan, goal, facing_rad, settings), heading_rad);
}

double leastCostHeading(const Scan& scan, const Bearing& goal, double facing_rad,
                        const GodzilaSettings& settings) {
  const std::vector<Term> terms = termsOf(scan, goal, facing_rad, settings);
  constexpr int kSamples = 16;
  const Real step = 2.0L * std::numbers::pi_v<Real> / kSamples;
  Real best = 0.0L;
  Real least = sumOf(terms, best);
  for (int k = 1; k < kSamples; ++k)
    if (const Real cost = sumOf(terms, k * step); cost < least) least = cost, best = k * step;
  const Real golden = (std::sqrt(Real{5.0L}) - 1.0L) / 2.0L;
  Real low = best - step;
  Real high = best + step;
  Real a = high - golden * (high - low);
  Real b = low + golden * (high - low);
  Real cost_a = sumOf(terms, a);
  Real cost_b = sumOf(terms, b);
  while (high - low > 1e-8L) {
    if (cost_a < cost_b) {
      high = b, b = a, cost_b = cost_a;
      a = high - golden * (high - low), cost_a = sumOf(terms, a);
    } else {
      low = a, a = b, cost_a = cost_b;
      b = low + golden * (high - low), cost_b = sumOf(terms, b);
    }
  }
  return normalizedAngle(static_cast<double>(0.5L * (low + high)));
}

HeadingCase randomHeadingCase(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  HeadingCase any;
  any.settings = std::array{table7(), tuned()}[seed % 2];
  any.settings.obstacle_attraction = between(0.0, 10.0);
  any.settings.bearing_ratio = between(0.0, 1.0);
  any.goal = {between(0.05, 12.0), between(-std::numbers::pi, std::numbers::pi)};
  any.facing_rad = std::array{0.0, 0.5, -0.5, 1.0}[seed / 2 % 4] * std::numbers::pi;
  // Walls in pieces, not noise alone: what repels is on one side then.
  double range = between(0.1, 5.6);
  for (std::size_t i = 0; i < any.scan.beams.count; ++i) {
    if (between(0.0, 1.0) < 0.02) range = between(0.1, 7.0);
    any.scan.ranges_m.push_back(range > 5.6 ? Scan::kNothing
                                            : static_cast<float>(range * between(0.98, 1.02)));
  }
  return any;
}

}  // namespace underway::bench
