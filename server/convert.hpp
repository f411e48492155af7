#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "idl/underway.h"
#include "planner/plan_document.hpp"
#include "server/question.hpp"
#include "server/served.hpp"

/// Between the wire (idl/underway.idl) and the planner's types. What comes from the wire is trusted in
/// nothing: counts, enumerators, flags, string ends, ranges and finiteness are checked before a field is
/// used. Thread safety: free functions without state.
namespace underway {

struct FreeReply {
  void operator()(underway_PlanReply* reply) const;
};
/// Owns a reply and everything it points to.
using WireReply = std::unique_ptr<underway_PlanReply, FreeReply>;

struct FreeRequest {
  void operator()(underway_PlanRequest* request) const;
};
/// Owns a request and everything it points to.
using WireRequest = std::unique_ptr<underway_PlanRequest, FreeRequest>;

/// A request as the server uses it.
struct Received {
  Asked asked;
  std::chrono::milliseconds deadline{};  ///< from its arrival
};

[[nodiscard]] RequestId idOf(const underway_RequestId& wire);

/// The partition that a reply belongs in: the robot's name, or the default partition "" if that is no robot
/// name.
using WireName = char[65];
[[nodiscard]] std::string partitionOf(const WireName& robot);

/// Errors: kInvalidRequest, one sentence naming the field.
[[nodiscard]] Expected<WireRequest> toWire(const RequestId& id, const Question& question);
[[nodiscard]] Expected<Received> fromWire(const underway_PlanRequest& wire, const Robot& robot);

/// Never fails: a plan that the wire cannot carry becomes an error reply (kInternal) that says why; of an
/// error, a message is cut at 4096 bytes and the list of what blocks at 64. `served` has no fault.
[[nodiscard]] WireReply toWire(const RequestId& id, const Served& served, const Expected<Given>& answer);

/// The document that planning on the spot would have given. Errors: kInternal for a reply that is malformed;
/// kInvalidRequest when a mode of the question is unknown to the server, for then there is no such document.
[[nodiscard]] Expected<PlanDocument> fromWire(const underway_PlanReply& wire, const Question& question);

}  // namespace underway
