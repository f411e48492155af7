#include "geometry/world_change.hpp"

namespace underway {
namespace {

/// An empty beginning is every id's, and never meant.
Expected<World> withoutAll(const World& world, const std::string& beginning) {
  if (beginning.empty())
    return fail(ErrorCode::kInvalidRequest, "say how the ids begin of the obstacles that go");
  std::vector<std::string> ids;
  for (const Obstacle& obstacle : world.obstacles())
    if (obstacle.id.starts_with(beginning)) ids.push_back(obstacle.id);
  Expected<World> last = world;
  for (const std::string& id : ids)
    if (last) last = last->removed(id);
  return last;
}

Expected<World> after(const World& world, const WorldChange& change) {
  switch (change.kind) {
    case WorldChange::Kind::kAdd:
      return world.added({change.obstacle, change.box});
    case WorldChange::Kind::kMove:
      return world.moved(change.obstacle, change.box);
    case WorldChange::Kind::kRemove:
      return world.removed(change.obstacle);
    case WorldChange::Kind::kRemoveAll:
      return withoutAll(world, change.obstacle);
  }
  return fail(ErrorCode::kInvalidRequest, "there is no such kind of change");
}

}  // namespace

Expected<World> changed(const World& world, std::span<const WorldChange> changes) {
  World last = world;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Expected<World> next = after(last, changes[i]);
    if (!next)
      return fail(ErrorCode::kInvalidRequest, "change " + std::to_string(i + 1) +
                                                  " cannot be made: " + next.error().message +
                                                  (changes.size() > 1 ? "; none was made" : ""));
    last = std::move(*next);
  }
  return last;
}

}  // namespace underway
