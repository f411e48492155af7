#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/world_change.hpp"
#include "idl/underway.h"
#include "planner/change.hpp"
#include "server/change_client.hpp"
#include "server/question.hpp"

/// Between the wire (idl/underway.idl) and changes of a world, in the manner of convert.hpp.
namespace underway {

struct FreeChange {
  void operator()(underway_ChangeRequest* request) const;
  void operator()(underway_ChangeReply* reply) const;
};
using WireChangeRequest = std::unique_ptr<underway_ChangeRequest, FreeChange>;
using WireChangeReply = std::unique_ptr<underway_ChangeReply, FreeChange>;

/// Errors: kInvalidRequest, one sentence naming the field.
[[nodiscard]] Expected<WireChangeRequest> toWire(const RequestId& id, const ChangeQuestion& question);
[[nodiscard]] Expected<std::vector<WorldChange>> fromWire(const underway_ChangeRequest& wire);

/// The state of a world; texts are to be freed with the sample it becomes a part of.
void write(const World& world, underway_WorldState& state);
/// `world` is as it is now; `outcome` what came of the changes.
[[nodiscard]] WireChangeReply toWire(const RequestId& id, const World& world,
                                     const Expected<Changed>& outcome, double took_ms);
/// The server's refusal is the answer's. Errors: kInternal for a reply that is malformed.
[[nodiscard]] Expected<ChangeAnswer> fromWire(const underway_ChangeReply& wire);

}  // namespace underway
