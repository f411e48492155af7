#pragma once

#include <vector>

namespace underway::bench {

/// A heading along which cells line up: `x` cells right, `y` cells up. One step of it, to any of the body's
/// four sides, leads from the middle of a cell to the middle of another.
struct Heading {
  int x = 1;
  int y = 0;
  double yaw = 0.0;  ///< atan2(y, x) [rad]
};

/// So many headings (a multiple of 8), nearly uniform, counter-clockwise from 0: heading i + count / 4 is
/// heading i turned by a right angle. Of all vectors within a third of a step of the uniform angle it is the
/// shortest.
[[nodiscard]] std::vector<Heading> latticeHeadings(int count);

}  // namespace underway::bench
