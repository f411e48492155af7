#pragma once

#include <memory>

#include "idl/underway.h"
#include "server/robot/heard.hpp"

/// Between the wire (idl/underway.idl) and what the local layer hears and says, in the manner of convert.hpp:
/// nothing that comes is trusted.
namespace underway {

struct FreeSenses {
  void operator()(underway_Senses* senses) const;
};
using WireSenses = std::unique_ptr<underway_Senses, FreeSenses>;

/// Nothing of the robot's own senses is refused; a scan with more than 4096 beams tells nothing.
[[nodiscard]] WireSenses toWire(std::uint64_t tick, const Senses& senses, const Robot& robot);
/// The scan has the beams that the local layer is made for (server/robot/beams.hpp). Errors: kInvalidRequest,
/// naming the field.
[[nodiscard]] Expected<HeardSenses> fromWire(const underway_Senses& wire, const Robot& robot);

[[nodiscard]] underway_Command toWire(std::uint64_t tick, const Command& command, const Robot& robot);
/// Errors: kInvalidRequest, naming the field.
[[nodiscard]] Expected<HeardCommand> fromWire(const underway_Command& wire, const Robot& robot);

}  // namespace underway
