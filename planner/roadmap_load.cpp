#include "planner/roadmap_load.hpp"

#include <spdlog/fmt/fmt.h>

#include <bit>
#include <numeric>

#include "planner/arrange.hpp"

namespace underway {
namespace {

std::uint64_t freeWaysOf(const Roadmap& roadmap) {
  return std::accumulate(roadmap.ways.begin(), roadmap.ways.end(), std::uint64_t{0},
                         [](std::uint64_t sum, Roadmap::Ways ways) {
                           return sum + static_cast<std::uint64_t>(std::popcount(ways));
                         });
}

}  // namespace

Expected<LoadedRoadmap> load(std::string_view bytes, const RoadmapKey& here, const Stances& stances,
                             const Checker& checker) {
  const Expected<RoadmapFile> file = fromBytes(bytes, here, stances, checker.robot());
  if (!file) return tl::unexpected(file.error());
  Loaded how{file->key.world == here.world, file->roadmap.batches, {}};
  LoadedRoadmap loaded{*revalidated(file->roadmap, stances, checker, how.repair), how};
  if (how.is_of_this_world && how.repair.closed + how.repair.opened > 0)
    return fail(
        ErrorCode::kInvalidRequest,
        fmt::format("the roadmap file lies about its own map: {} ways that it calls free are not, {} that it "
                    "calls blocked are free: let it be grown anew",
                    how.repair.closed, how.repair.opened));
  if (const std::uint64_t free = freeWaysOf(file->roadmap); 2 * how.repair.closed > free)
    return fail(
        ErrorCode::kInvalidRequest,
        fmt::format("the roadmap was made for a map too different from this one, {} of its {} free ways are "
                    "blocked here: give its map, or another file",
                    how.repair.closed, free));
  loaded.how = how;
  arrange(loaded.roadmap, stances.all());
  return loaded;
}

}  // namespace underway
