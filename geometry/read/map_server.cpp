#include "geometry/read/map_server.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/read/bytes.hpp"
#include "geometry/read/cell_judge.hpp"
#include "geometry/read/image.hpp"

namespace underway {
namespace {

constexpr auto kInvalid = ErrorCode::kInvalidMap;

/// What is wrong with which of the numbers, by its key in YAML.
struct Fault {
  const char* key;
  std::string what;
};

std::optional<Fault> faultOf(const MapServerSettings& settings) {
  const auto is_share = [](double value) { return value >= 0.0 && value <= 1.0; };
  if (!std::isfinite(settings.resolution_m) || settings.resolution_m <= 0.0)
    return Fault{"resolution", "must be above 0 m, and finite"};
  for (const double number : {settings.origin.x, settings.origin.y, settings.origin.yaw})
    if (!std::isfinite(number)) return Fault{"origin", "must be finite"};
  if (!is_share(settings.occupied_thresh)) return Fault{"occupied_thresh", "must be between 0 and 1"};
  if (!is_share(settings.free_thresh)) return Fault{"free_thresh", "must be between 0 and 1"};
  if (settings.free_thresh > settings.occupied_thresh)
    return Fault{"free_thresh", "must not be above the threshold for occupied; are the two swapped?"};
  return std::nullopt;
}

/// The flag that gives the number for an image without YAML.
std::string flagOf(const std::string& key) {
  std::string flag = "--" + key + (key == "resolution" ? "_m" : "");
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

PixelMode pixelMode(const YamlValue& value) {
  const std::string mode = value.text("trinary");
  if (mode == "scale") return PixelMode::kScale;
  if (mode == "raw") return PixelMode::kRaw;
  if (mode != "trinary") value.refuse("expected trinary, scale or raw, found " + inQuotes(mode));
  return PixelMode::kTrinary;
}

MapServerSettings settingsOf(const YamlValue& root) {
  MapServerSettings settings;
  settings.resolution_m = root.at("resolution").number();
  const std::vector<double> origin = root.at("origin").numbers(3, 3);
  settings.origin = {origin[0], origin[1], origin[2]};
  settings.negate = root.at("negate").flag();
  settings.occupied_thresh = root.at("occupied_thresh").number();
  settings.free_thresh = root.at("free_thresh").number();
  settings.mode = pixelMode(root.find("mode"));
  if (const auto fault = faultOf(settings)) root.find(fault->key).refuse(fault->what);
  return settings;
}

Expected<Grid> decodeGrid(const std::string& file, std::string_view bytes,
                          const MapServerSettings& settings) {
  Grid grid;
  grid.resolution_m = settings.resolution_m;
  grid.origin = settings.origin;
  std::optional<CellJudge> judge;
  const auto put_row = [&](const ImageFormat& format, std::uint32_t row,
                           std::span<const std::uint16_t> samples) {
    if (!judge) {
      judge.emplace(settings, format);
      grid.width = format.width;
      grid.height = format.height;
      grid.cells.resize(std::size_t{format.width} * format.height);
    }
    // An image begins at its top, a grid at its lowest row.
    Cell* cells = grid.cells.data() + std::size_t{format.height - 1 - row} * format.width;
    for (std::size_t x = 0; x < format.width; ++x)
      cells[x] = (*judge)(samples.subspan(x * format.channels, format.channels));
  };
  if (const auto decoded = decodeImage(bytes, file, put_row); !decoded)
    return tl::unexpected(decoded.error());
  return grid;
}

}  // namespace

Expected<Grid> gridFromMapServer(YamlFile& yaml) {
  const YamlValue root = yaml.root();
  const MapServerSettings settings = settingsOf(root);
  const std::filesystem::path image = yaml.path().parent_path() / root.at("image").text();
  if (yaml.fault()) return tl::unexpected(*yaml.fault());
  const auto bytes = readBytes(image, kLargestImageFile, kInvalid);
  if (!bytes) {
    root.at("image").refuse(bytes.error().message);
    return tl::unexpected(*yaml.fault());
  }
  return decodeGrid(image.string(), *bytes, settings);
}

Expected<Grid> gridFromImage(const std::filesystem::path& file, std::string_view bytes,
                             const MapOptions& options) {
  const auto refuse = [&](const std::string& what) { return fail(kInvalid, file.string() + ": " + what); };
  if (const auto readable = checkIsReadable(bytes, file.string()); !readable)
    return tl::unexpected(readable.error());
  MapServerSettings settings;
  if (!options.resolution_m)
    return refuse(
        "an image does not say how large its cells are; give --resolution-m, or the map's YAML file");
  settings.resolution_m = *options.resolution_m;
  settings.origin = options.origin.value_or(settings.origin);
  settings.occupied_thresh = options.occupied_thresh.value_or(settings.occupied_thresh);
  settings.free_thresh = options.free_thresh.value_or(settings.free_thresh);
  if (const auto fault = faultOf(settings)) return refuse(flagOf(fault->key) + " " + fault->what);
  return decodeGrid(file.string(), bytes, settings);
}

Expected<void> refuseImageOptions(const std::filesystem::path& file, const MapOptions& options) {
  const std::pair<bool, const char*> given[] = {{options.resolution_m.has_value(), "resolution"},
                                                {options.origin.has_value(), "origin"},
                                                {options.occupied_thresh.has_value(), "occupied_thresh"},
                                                {options.free_thresh.has_value(), "free_thresh"}};
  for (const auto& [is_given, key] : given)
    if (is_given)
      return fail(kInvalid,
                  file.string() + ": " + flagOf(key) +
                      " is for an image that comes without YAML; leave it out, the file says it itself");
  return {};
}

}  // namespace underway
