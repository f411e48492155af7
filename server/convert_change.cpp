#include "server/convert_change.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "server/wire_limits.hpp"
#include "server/wire_memory.hpp"

namespace underway {
namespace {

using underway::read;

constexpr double kLargestAngle_rad = 1000.0;

underway_Vector wireVector(const Vec3& vector) { return {vector.x, vector.y, vector.z}; }
Vec3 vectorOf(const underway_Vector& wire) { return {wire.x, wire.y, wire.z}; }

bool isWithin(const underway_Vector& vector, double largest) {  // false for NaN
  return std::abs(vector.x) <= largest && std::abs(vector.y) <= largest && std::abs(vector.z) <= largest;
}

/// An obstacle's id as files may have it, too.
bool isObstacleId(std::optional<std::string_view> id) {
  return id && !id->empty() && std::none_of(id->begin(), id->end(), [](char c) {
           return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
         });
}

/// What is wrong with a change, naming the field; empty if nothing is.
std::string faultOf(const underway_Change& wire) {
  if (bitsOf<std::uint32_t>(wire.kind) > underway_REMOVE_ALL)
    return "kind must be ADD_OBSTACLE, MOVE_OBSTACLE, REMOVE_OBSTACLE or REMOVE_ALL";
  if (!isObstacleId(textOf(wire.obstacle)))
    return "obstacle must be an id of 1 to 255 bytes without control characters";
  if (wire.kind == underway_REMOVE_OBSTACLE || wire.kind == underway_REMOVE_ALL) return {};
  if (!isWithin(wire.center_m, World::kLargest_m)) return "center_m must be numbers from -100000 to 100000 m";
  if (!isWithin(wire.size_m, World::kLargest_m) ||
      !(std::min({wire.size_m.x, wire.size_m.y, wire.size_m.z}) > 0.0))
    return "size_m must be numbers above 0, to 100000 m";
  if (!isWithin(wire.rpy_rad, kLargestAngle_rad)) return "rpy_rad must be numbers from -1000 to 1000 rad";
  return {};
}

tl::unexpected<Error> faultAt(std::size_t i, const std::string& fault) {
  return fail(ErrorCode::kInvalidRequest, "changes[" + std::to_string(i) + "]: " + fault);
}

constexpr const char* kTooMany = "changes must be 1024 at most: make them in several requests";

bool read(const underway_WorldState& wire, WorldNow& world) {
  world.revision = wire.revision;
  world.obstacles = wire.obstacles;
  return read(wire.map_name, world.map_name) && read(wire.world_hash, world.hash);
}

}  // namespace

void FreeChange::operator()(underway_ChangeRequest* request) const {
  dds_sample_free(request, &underway_ChangeRequest_desc, DDS_FREE_ALL);
}

void FreeChange::operator()(underway_ChangeReply* reply) const {
  dds_sample_free(reply, &underway_ChangeReply_desc, DDS_FREE_ALL);
}

Expected<WireChangeRequest> toWire(const RequestId& id, const ChangeQuestion& question) {
  WireChangeRequest wire(allocate<underway_ChangeRequest>());
  std::copy(id.client.begin(), id.client.end(), std::begin(wire->id.client));
  wire->id.number = id.sequence;
  if (!isRobotName(question.robot) || !copyText(question.robot, wire->robot))
    return fail(ErrorCode::kInvalidRequest, "the robot's name must be 1 to 64 of A-Z a-z 0-9 _ -");
  if (question.changes.size() > kMostChanges) return fail(ErrorCode::kInvalidRequest, kTooMany);
  wire->if_revision = question.if_revision;
  const auto changes = allocate(wire->changes, question.changes.size());
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const WorldChange& from = question.changes[i];
    underway_Change& to = changes[i];
    to.kind = static_cast<underway_ChangeKind>(from.kind);
    to.center_m = wireVector(from.box.center_m);
    to.size_m = wireVector(from.box.size_m);
    to.rpy_rad = wireVector(from.box.rpy_rad);
    const bool is_copied = copyText(from.obstacle, to.obstacle);
    if (const std::string fault = faultOf(to); !is_copied || !fault.empty())
      return faultAt(i, is_copied ? fault : "obstacle must be an id of 1 to 255 bytes");
  }
  return wire;
}

Expected<std::vector<WorldChange>> fromWire(const underway_ChangeRequest& wire) {
  const auto robot = textOf(wire.robot);
  if (!robot || !isRobotName(*robot))
    return fail(ErrorCode::kInvalidRequest, "robot must be 1 to 64 of A-Z a-z 0-9 _ -");
  if (!isCounted(wire.changes, kMostChanges)) return fail(ErrorCode::kInvalidRequest, kTooMany);
  std::vector<WorldChange> changes;
  for (std::size_t i = 0; i < wire.changes._length; ++i) {
    const underway_Change& from = wire.changes._buffer[i];
    if (const std::string fault = faultOf(from); !fault.empty()) return faultAt(i, fault);
    WorldChange change{static_cast<WorldChange::Kind>(from.kind), std::string(*textOf(from.obstacle)), {}};
    if (change.kind == WorldChange::Kind::kAdd || change.kind == WorldChange::Kind::kMove)
      change.box = {vectorOf(from.center_m), vectorOf(from.size_m), vectorOf(from.rpy_rad)};
    changes.push_back(std::move(change));
  }
  return changes;
}

void write(const World& world, underway_WorldState& state) {
  state.map_name = wireText(world.name());
  state.revision = world.revision();
  state.world_hash = wireText(world.hash());
  state.obstacles = static_cast<std::uint32_t>(world.obstacles().size());
}

WireChangeReply toWire(const RequestId& id, const World& world, const Expected<Changed>& outcome,
                       double took_ms) {
  WireChangeReply wire(allocate<underway_ChangeReply>());
  std::copy(id.client.begin(), id.client.end(), std::begin(wire->id.client));
  wire->id.number = id.sequence;
  wire->ok = outcome.has_value();
  if (!outcome) wire->code = static_cast<underway_ErrorCode>(outcome.error().code);
  wire->message = wireText(outcome ? std::string() : outcome.error().message);
  write(world, wire->world);
  const Repair repair = outcome ? outcome->repair : Repair{};
  wire->checked = repair.checked;
  wire->closed = repair.closed;
  wire->opened = repair.opened;
  wire->took_ms = took_ms;
  return wire;
}

Expected<ChangeAnswer> fromWire(const underway_ChangeReply& wire) {
  ChangeAnswer answer{{}, Repair{wire.checked, wire.closed, wire.opened}, wire.took_ms};
  bool ok = false;
  Error error;
  if (!read(wire.ok, ok) || !read(wire.code, ErrorCode::kInternal, error.code) ||
      !read(wire.message, error.message) || !read(wire.world, answer.world) || !areFinite(wire.took_ms))
    return fail(ErrorCode::kInternal,
                "the server's reply is malformed: check that server and client are of the same version");
  if (!ok) answer.repaired = tl::unexpected(std::move(error));
  return answer;
}

}  // namespace underway
