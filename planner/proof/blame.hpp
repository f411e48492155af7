#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "geometry/error.hpp"
#include "planner/proof/proof.hpp"

namespace underway::proof {

/// What stands between start and goal.
struct Blame {
  std::vector<Blocking> blocking;  ///< one an obstacle: without all of them there would be a way
  std::string sentence;            ///< what is missing: "crawl needs 0.210 m of height, beam leaves 0.190 m"
  bool is_irreducible = false;     ///< shown: without only some of them there would still be none
};

/// Whether the request has a plan in another world: the planner's word, within a short time.
using IsSolvable = std::function<bool(const std::shared_ptr<const World>&)>;

/// The obstacles to blame for there being no plan, as few as can be told in the time: those on the way with
/// the fewest of them, less those that are not needed. That a plan exists without all of them is the
/// planner's word; that none does without fewer is proven. What is missing at each is told by rule
/// (need.hpp).
///
/// Nothing to blame (no obstacles): the robot or the bounds leave no way. Thread safety: may be called from
/// any number of threads, each with an interrupt of its own.
[[nodiscard]] Blame blame(const Checker& checker, const Proof& proof, const IsSolvable& is_solvable,
                          Interrupt& interrupt);

}  // namespace underway::proof
