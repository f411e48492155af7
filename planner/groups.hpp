#pragma once

#include <cstdint>
#include <vector>

#include "geometry/robot.hpp"

namespace underway {

/// Index into Groups::modes.
using GroupId = std::uint8_t;

/// The robot's modes by what they can do where they stand: modes that turn, and change into each other on the
/// spot, are companions and form a group; a mode that cannot turn is a group of its own.
struct Groups {
  explicit Groups(const Robot& robot);

  std::vector<std::vector<ModeId>> modes;  ///< of each group, ascending
  std::vector<GroupId> of_mode;
};

}  // namespace underway
