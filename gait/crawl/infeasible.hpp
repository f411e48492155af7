#pragma once

#include <string>
#include <tl/expected.hpp>

namespace underway::gait {

/// Why no joint angles reach: a distance that links would have to span, and what they can span.
struct Infeasible {
  double needs_m = 0.0;  ///< from the one end to the other
  double least_m = 0.0;  ///< the links folded
  double most_m = 0.0;   ///< the links stretched

  /// One sentence, in millimetres.
  [[nodiscard]] std::string sentence() const;
};

/// Angles, or why there are none.
template <class T>
using Feasible = tl::expected<T, Infeasible>;

}  // namespace underway::gait
