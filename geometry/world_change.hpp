#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "geometry/world.hpp"

namespace underway {

/// One thing that changes in a world.
struct WorldChange {
  enum class Kind : std::uint8_t { kAdd, kMove, kRemove };
  Kind kind = Kind::kAdd;
  std::string obstacle;  ///< its id: new for kAdd, there already for the others
  OrientedBox box = {};  ///< where it is afterwards; ignored for kRemove
};

/// The world after changes, made one after the other; the revision rises by one for each. All of them or
/// none. Errors: kInvalidRequest, one sentence with the number of the change.
[[nodiscard]] Expected<World> changed(const World& world, std::span<const WorldChange> changes);

}  // namespace underway
