#include "geometry/map.hpp"

#include <cmath>

#include "geometry/grid.hpp"
#include "geometry/read/bytes.hpp"
#include "geometry/read/image.hpp"
#include "geometry/read/map_server.hpp"
#include "geometry/read/scenario.hpp"
#include "geometry/read/walls.hpp"
#include "geometry/read/yaml.hpp"

namespace underway {
namespace {

constexpr auto kInvalid = ErrorCode::kInvalidMap;
constexpr double kFloorOfGrid_m = 0.0;

Expected<Map> mapFromGrid(const std::filesystem::path& file, const Expected<Grid>& grid,
                          const MapOptions& options) {
  if (!grid) return tl::unexpected(grid.error());
  if (!std::isfinite(options.wall_height_m) || options.wall_height_m <= 0.0)
    return fail(kInvalid, file.string() + ": the height of its walls must be above 0 m, and finite");
  auto walls = wallsOf(*grid, options.unknown, kFloorOfGrid_m, options.wall_height_m, file);
  if (!walls) return tl::unexpected(walls.error());
  auto world = World::make(file.stem().string(), boundsOf(*grid), kFloorOfGrid_m, std::move(*walls));
  if (!world) return fail(kInvalid, file.string() + ": " + world.error().message);
  return Map{std::move(*world), {}};
}

bool isMapServer(const YamlValue& root) { return root.find("image") || root.find("resolution"); }

}  // namespace

Expected<Map> readMap(const std::filesystem::path& file, const MapOptions& options) {
  const auto bytes = readBytes(file, kLargestImageFile, kInvalid);
  if (!bytes) return tl::unexpected(bytes.error());
  if (isImage(*bytes)) return mapFromGrid(file, gridFromImage(file, *bytes, options), options);

  auto yaml = parseYaml(file, *bytes, kInvalid);
  if (!yaml) return tl::unexpected(yaml.error());
  if (const auto refused = refuseImageOptions(file, options); !refused)
    return tl::unexpected(refused.error());
  const YamlValue root = yaml->root();
  if (isMapServer(root)) return mapFromGrid(file, gridFromMapServer(*yaml), options);
  if (root.find("modes")) root.refuse("is a robot, not a map");
  if (!isScenario(root))
    root.refuse(
        "is no map: expected a scenario (bounds_m, obstacles ...) or a ROS map_server map (image, resolution "
        "...)");
  if (yaml->fault()) return tl::unexpected(*yaml->fault());
  return mapFromScenario(*yaml, options);
}

Expected<Grid> readGrid(const std::filesystem::path& file, const MapOptions& options) {
  const auto bytes = readBytes(file, kLargestImageFile, kInvalid);
  if (!bytes) return tl::unexpected(bytes.error());
  if (isImage(*bytes)) return gridFromImage(file, *bytes, options);

  auto yaml = parseYaml(file, *bytes, kInvalid);
  if (!yaml) return tl::unexpected(yaml.error());
  if (const auto refused = refuseImageOptions(file, options); !refused)
    return tl::unexpected(refused.error());
  return gridFromMapServer(*yaml);
}

}  // namespace underway
