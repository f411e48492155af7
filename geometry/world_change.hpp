#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "geometry/world.hpp"

namespace underway {

/// One thing that changes in a world.
struct WorldChange {
  enum class Kind : std::uint8_t { kAdd, kMove, kRemove, kRemoveAll };
  Kind kind = Kind::kAdd;
  /// Its id: new for kAdd, there already for kMove and kRemove. Of kRemoveAll how the ids begin of all that
  /// go, which may be none.
  std::string obstacle;
  OrientedBox box = {};  ///< where it is afterwards; ignored when removing
};

/// The world after changes, made one after the other; the revision rises by one for each
/// obstacle. All of them or
/// none. Errors: kInvalidRequest, one sentence with the number of the change.
[[nodiscard]] Expected<World> changed(const World& world, std::span<const WorldChange> changes);

}  // namespace underway
