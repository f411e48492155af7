#include "bench/oracle/headings.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace underway::bench {
namespace {

constexpr double kPi = std::numbers::pi;

/// The shortest vector of the first quadrant near an angle.
Heading nearest(double angle_rad, double within_rad) {
  for (int longest = 1;; ++longest)
    for (int other = 0; other <= longest; ++other)
      for (const auto& [x, y] : {std::pair(longest, other), std::pair(other, longest)})
        if (std::abs(std::atan2(y, x) - angle_rad) <= within_rad) return {x, y, 0.0};
}

}  // namespace

std::vector<Heading> latticeHeadings(int count) {
  if (count < 8 || count % 8 != 0) throw std::invalid_argument("headings come in multiples of 8");
  const double step = 2.0 * kPi / count;
  const int quarter = count / 4;
  std::vector<Heading> headings;
  for (int i = 0; i < count; ++i) {
    Heading heading = i < quarter ? nearest(i * step, i % (count / 8) == 0 ? 1e-9 : step / 3.0)
                                  : Heading{-headings[static_cast<std::size_t>(i - quarter)].y,
                                            headings[static_cast<std::size_t>(i - quarter)].x, 0.0};
    heading.yaw = std::atan2(heading.y, heading.x);
    headings.push_back(heading);
  }
  return headings;
}

}  // namespace underway::bench
