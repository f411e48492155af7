#pragma once

#include <cstdint>
#include <optional>

#include "local/command.hpp"
#include "local/senses.hpp"

namespace underway {

/// What a robot's senses told at one moment, with the scans that `Senses` only points to. Times are by the
/// robot's clock.
struct HeardSenses {
  std::uint64_t tick = 0;  ///< tells it from others; 0: the robot does not count
  Senses rest;             ///< all but the scans: its pointers are null
  std::optional<Scan> scan;
  std::optional<Scan> depth;

  /// Valid as long as this object stays where and as it is.
  [[nodiscard]] Senses senses() const {
    Senses all = rest;
    all.scan = scan ? &*scan : nullptr;
    all.depth = depth ? &*depth : nullptr;
    return all;
  }
};

/// What a robot is told to do.
struct HeardCommand {
  std::uint64_t tick = 0;  ///< of the senses that it answers; 0: of none
  Command command;
};

}  // namespace underway
