#include "planner/change.hpp"

#include <spdlog/fmt/fmt.h>

#include <utility>

namespace underway {

Expected<Changed> change(Planner& planner, std::span<const WorldChange> changes, std::uint64_t if_revision) {
  const auto checker = planner.checker();
  const World& world = checker->world();
  if (if_revision != 0 && if_revision != world.revision())
    return fail(ErrorCode::kStaleRevision,
                fmt::format("the world is at revision {}, not {}: look at what has changed, and ask again",
                            world.revision(), if_revision));
  Expected<World> next = changed(world, changes);
  if (!next) return tl::unexpected(next.error());
  auto revision = std::make_shared<const World>(std::move(*next));
  const Repair repair = changes.empty() ? Repair{} : planner.update(revision);
  return Changed{std::move(revision), repair};
}

}  // namespace underway
