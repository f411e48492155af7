#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "planner/interrupt.hpp"
#include "planner/passage.hpp"

namespace underway {

/// A step of the way from start to goal, in order. Stations of stops only may be left out.
struct Station {
  std::vector<Option> options;
  bool may_be_skipped = false;
  std::size_t reach = 1;          ///< how many stations ahead its legs may lead
  const Legs* legs_on = nullptr;  ///< of the legs that leave it
};

/// A route and what lies close beside it: stations from start to goal, of which one option each is taken.
using Corridor = std::vector<Station>;

/// The cheapest way through a corridor that costs less than a bound, by dynamic programming over stations,
/// options and ways, all of it free. Empty when there is none or it was interrupted.
[[nodiscard]] std::optional<Passage> cheapestThrough(const Corridor& corridor, Cost bound,
                                                     Interrupt& interrupt);

}  // namespace underway
