#include "tests/judge/scene.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>

namespace judge {
namespace {

/// Occupied cells beside each other in a row make one box, of at most so many cells: short boxes are cheap to
/// pass over.
constexpr std::size_t kLongestRun = 20;
constexpr double kWallHeight_m = 10.0;

struct Grid {
  Image image;
  double resolution_m = 0.0;
  Pose origin;  ///< of the lower left corner
  std::vector<bool> occupied;
};

Grid readGrid(const std::filesystem::path& file, const YAML::Node& yaml, Unknown unknown) {
  const auto mode = yaml["mode"].as<std::string>("trinary");
  if (mode != "trinary") throw InputError(file.string() + ": mode " + mode + " is not judged, only trinary");
  Grid grid;
  grid.image = readImage(file.parent_path() / yaml["image"].as<std::string>());
  grid.resolution_m = yaml["resolution"].as<double>();
  const auto origin = yaml["origin"].as<std::vector<double>>();
  grid.origin = {origin.at(0), origin.at(1), origin.at(2)};
  const auto negate_word = yaml["negate"].as<std::string>("0");
  const bool negate = negate_word == "1" || negate_word == "true";
  const auto occupied_above = yaml["occupied_thresh"].as<double>();
  const auto free_below = yaml["free_thresh"].as<double>();
  for (const double shade : grid.image.shade) {
    const double p = (negate ? shade : grid.image.white - shade) / grid.image.white;
    const bool is_known = p > occupied_above || p < free_below;
    grid.occupied.push_back(is_known ? p > occupied_above : unknown == Unknown::kOccupied);
  }
  return grid;
}

/// Cells [first, last) of a row (0 is the top) as one box standing on the floor.
Box boxOf(const Grid& grid, std::size_t row, std::size_t first, std::size_t last, double floor_z_m,
          double height_m) {
  const double cell = grid.resolution_m;
  const double x = 0.5 * cell * static_cast<double>(first + last);
  const double y = cell * (static_cast<double>(grid.image.height - row) - 0.5);
  const Vec2 center = placed(grid.origin, Vec2{x, y});
  return {"",
          {center.x, center.y, floor_z_m + 0.5 * height_m},
          {cell * static_cast<double>(last - first), cell, height_m},
          {0.0, 0.0, grid.origin.yaw}};
}

void addCells(Scene& scene, const Grid& grid, double height_m) {
  const std::size_t width = grid.image.width;
  for (std::size_t row = 0; row < grid.image.height; ++row) {
    std::size_t column = 0;
    while (column < width) {
      const std::size_t first = column;
      while (column < width && column - first < kLongestRun && grid.occupied[row * width + column]) ++column;
      if (column == first)
        ++column;
      else
        scene.boxes.push_back(boxOf(grid, row, first, column, scene.floor_z_m, height_m));
    }
  }
}

Polygon boundsOf(const Grid& grid) {
  return placed(grid.origin, Rect{0.0, grid.resolution_m * static_cast<double>(grid.image.width), 0.0,
                                  grid.resolution_m * static_cast<double>(grid.image.height)});
}

Vec3 vec3(const YAML::Node& node) {
  const auto v = node.as<std::vector<double>>();
  return {v.at(0), v.at(1), v.at(2)};
}

Scene readScenario(const std::filesystem::path& file, const YAML::Node& yaml, Unknown unknown) {
  Scene scene;
  scene.name = yaml["name"].as<std::string>(file.stem().string());
  scene.floor_z_m = yaml["floor_z_m"].as<double>(0.0);
  for (const YAML::Node& node : yaml["obstacles"])
    scene.boxes.push_back({node["id"].as<std::string>(), vec3(node["center_m"]), vec3(node["size_m"]),
                           node["rpy_rad"] ? vec3(node["rpy_rad"]) : Vec3{}});
  if (const YAML::Node map = yaml["map"]) {
    const std::filesystem::path map_file = file.parent_path() / map["image"].as<std::string>();
    const Grid grid = readGrid(map_file, YAML::LoadFile(map_file), unknown);
    scene.bounds = boundsOf(grid);
    addCells(scene, grid, map["height_m"].as<double>(kWallHeight_m));
  }
  if (const YAML::Node bounds = yaml["bounds_m"]) {
    const auto low = bounds["min"].as<std::vector<double>>();
    const auto high = bounds["max"].as<std::vector<double>>();
    scene.bounds = placed(Pose{}, Rect{low.at(0), high.at(0), low.at(1), high.at(1)});
  }
  if (scene.bounds.empty())
    throw InputError(file.string() + ": neither bounds_m nor a map says how far it reaches");
  return scene;
}

}  // namespace

Scene readScene(const std::filesystem::path& file, Unknown unknown) try {
  const YAML::Node yaml = YAML::LoadFile(file);
  if (!yaml["image"]) return readScenario(file, yaml, unknown);
  Scene scene;
  scene.name = file.stem().string();
  const Grid grid = readGrid(file, yaml, unknown);
  scene.bounds = boundsOf(grid);
  addCells(scene, grid, kWallHeight_m);
  return scene;
} catch (const YAML::Exception& error) {
  throw InputError(file.string() + ": " + error.what());
} catch (const std::out_of_range&) {
  throw InputError(file.string() + ": a list is too short");
}

}  // namespace judge
