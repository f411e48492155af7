#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/error.hpp"
#include "geometry/grid.hpp"
#include "geometry/map.hpp"
#include "geometry/read/yaml.hpp"

namespace underway {

/// How the pixels of a ROS map_server map are read; see cell_judge.hpp.
enum class PixelMode { kTrinary, kScale, kRaw };

/// The numbers of a map_server YAML.
struct MapServerSettings {
  double resolution_m = 0.0;  ///< side of a cell
  Pose origin;                ///< of the lower left corner, in the map frame
  double occupied_thresh = 0.65;
  double free_thresh = 0.196;
  bool negate = false;
  PixelMode mode = PixelMode::kTrinary;
};

/// The cells of a map_server YAML, with the image it names beside it. The file is not ours: keys that
/// map_server does not know are left to those who put them there. Errors: kInvalidMap.
[[nodiscard]] Expected<Grid> gridFromMapServer(YamlFile& yaml);

/// The cells of an image that comes without YAML; the options hold its numbers. Errors: kInvalidMap.
[[nodiscard]] Expected<Grid> gridFromImage(const std::filesystem::path& file, std::string_view bytes,
                                           const MapOptions& options);

/// Refuses the options that are for an image without YAML only.
[[nodiscard]] Expected<void> refuseImageOptions(const std::filesystem::path& file, const MapOptions& options);

}  // namespace underway
