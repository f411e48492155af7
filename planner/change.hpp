#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "geometry/world_change.hpp"
#include "planner/planner.hpp"

namespace underway {

/// What came of changing a planner's world.
struct Changed {
  std::shared_ptr<const World> world;  ///< as it is now
  Repair repair;                       ///< of the roadmap
};

/// Changes the world that a planner plans in, all changes or none; without any only tells how it is. Queries
/// that have begun end in the world they began in.
///
/// `if_revision`: 0, or the revision the world must have. Errors: kInvalidRequest for a change that cannot be
/// made, kStaleRevision for another revision. Thread safety: beside any queries, but by one thread at a time.
[[nodiscard]] Expected<Changed> change(Planner& planner, std::span<const WorldChange> changes,
                                       std::uint64_t if_revision = 0);

}  // namespace underway
