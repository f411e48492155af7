#include "geometry/read/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/grid.hpp"
#include "geometry/read/walls.hpp"

namespace underway {
namespace {

const std::vector<std::string_view>& scenarioKeys() {
  static const std::vector<std::string_view> kKeys{"name",      "floor_z_m", "bounds_m",
                                                   "obstacles", "map",       "queries"};
  return kKeys;
}

/// A length or coordinate the world has room for.
double metres(const YamlValue& value, double number) {
  if (std::abs(number) > World::kLargest_m)
    value.refuse("must be within 100 km, found " + std::to_string(number) + " m");
  return number;
}

Vec3 vec3(const YamlValue& value) {
  const std::vector<double> numbers = value.numbers(3, 3);
  return {metres(value, numbers[0]), metres(value, numbers[1]), metres(value, numbers[2])};
}

/// Names that may be given once each.
class Names {
 public:
  void add(const YamlValue& value, const std::string& name) {
    if (!taken_.insert(name).second) value.refuse(inQuotes(name) + " is given twice; each needs its own");
  }

 private:
  std::set<std::string> taken_;
};

Obstacle obstacleOf(const YamlValue& value) {
  value.allowOnly({"id", "center_m", "size_m", "rpy_rad"});
  Obstacle obstacle;
  obstacle.id = value.at("id").text();
  obstacle.box.center_m = vec3(value.at("center_m"));
  const YamlValue size = value.at("size_m");
  obstacle.box.size_m = vec3(size);
  if (std::min({obstacle.box.size_m.x, obstacle.box.size_m.y, obstacle.box.size_m.z}) <= 0.0)
    size.refuse("must be above 0 in x, y and z");
  if (const YamlValue rpy = value.find("rpy_rad")) {
    const std::vector<double> angles = rpy.numbers(3, 3);
    obstacle.box.rpy_rad = {angles[0], angles[1], angles[2]};
  }
  return obstacle;
}

Bounds boundsFrom(const YamlValue& value) {
  value.allowOnly({"min", "max"});
  const YamlValue highest = value.at("max");
  const std::vector<double> min = value.at("min").numbers(2, 2);
  const std::vector<double> max = highest.numbers(2, 2);
  for (const double number : {min[0], min[1], max[0], max[1]}) metres(value, number);
  if (max[0] <= min[0] || max[1] <= min[1]) highest.refuse("must be above min in x and in y");
  return {{min[0], min[1], 0.0}, max[0] - min[0], max[1] - min[1]};
}

std::string expectationOf(const YamlValue& value) {
  const std::string expect = value.text("ok");
  std::vector<std::string> known{"ok"};
  for (int code = 0; code < kErrorCodeCount; ++code) known.emplace_back(name(static_cast<ErrorCode>(code)));
  if (std::find(known.begin(), known.end(), expect) == known.end())
    value.refuse("expected " + listed(known) + ", found " + inQuotes(expect));
  return expect;
}

Query queryOf(const YamlValue& value) {
  value.allowOnly({"name", "start", "start_mode", "goal", "goal_mode", "expect", "must_use"});
  Query query;
  query.name = value.at("name").text();
  const std::vector<double> start = value.at("start").numbers(3, 3);
  query.start = {start[0], start[1], start[2]};
  query.start_mode = value.find("start_mode").text();
  const std::vector<double> goal = value.at("goal").numbers(2, 3);
  query.goal = {goal[0], goal[1]};
  if (goal.size() == 3) query.goal_yaw = goal[2];
  query.goal_mode = value.find("goal_mode").text();
  query.expect = expectationOf(value.find("expect"));
  for (const YamlValue& mode : value.find("must_use").items()) query.must_use.push_back(mode.text());
  return query;
}

std::vector<Obstacle> obstaclesOf(const YamlValue& list) {
  Names ids;
  std::vector<Obstacle> obstacles;
  for (const YamlValue& value : list.items()) {
    obstacles.push_back(obstacleOf(value));
    ids.add(value.find("id"), obstacles.back().id);
  }
  return obstacles;
}

std::vector<Query> queriesOf(const YamlValue& list) {
  Names names;
  std::vector<Query> queries;
  for (const YamlValue& value : list.items()) {
    queries.push_back(queryOf(value));
    names.add(value.find("name"), queries.back().name);
  }
  return queries;
}

/// The walls of the map_server map that a scenario names, and that map's bounds.
struct Floor {
  std::vector<Obstacle> walls;
  std::optional<Bounds> bounds;
};

Floor floorOf(const YamlFile& yaml, const YamlValue& map, double floor_z_m, Unknown unknown) {
  map.allowOnly({"image", "height_m"});
  const YamlValue image = map.at("image");
  const YamlValue height = map.at("height_m");
  const std::string image_name = image.text();
  const double height_m = metres(height, height.number());
  if (height && height_m <= 0.0) height.refuse("must be above 0 m");
  if (yaml.fault()) return {};
  const std::filesystem::path file = yaml.path().parent_path() / image_name;
  MapOptions options;
  options.unknown = unknown;
  const auto grid = readGrid(file, options);
  auto walls = grid ? wallsOf(*grid, unknown, floor_z_m, height_m, file) : tl::unexpected(grid.error());
  if (!walls) {
    image.refuse(walls.error().message);
    return {};
  }
  return {std::move(*walls), boundsOf(*grid)};
}

}  // namespace

bool isScenario(const YamlValue& root) {
  return std::any_of(scenarioKeys().begin(), scenarioKeys().end(),
                     [&](std::string_view key) { return static_cast<bool>(root.find(key)); });
}

Expected<Map> mapFromScenario(YamlFile& yaml, const MapOptions& options) {
  const YamlValue root = yaml.root();
  root.allowOnly(scenarioKeys());
  const std::string name = root.find("name").text(yaml.path().stem().string());
  const YamlValue floor = root.find("floor_z_m");
  const double floor_z_m = metres(floor, floor.number(0.0));

  std::vector<Obstacle> obstacles = obstaclesOf(root.find("obstacles"));
  std::vector<Query> queries = queriesOf(root.find("queries"));
  std::optional<Bounds> bounds;
  if (const YamlValue map = root.find("map")) {
    Floor found = floorOf(yaml, map, floor_z_m, options.unknown);
    bounds = found.bounds;
    std::move(found.walls.begin(), found.walls.end(), std::back_inserter(obstacles));
  }
  if (const YamlValue given = root.find("bounds_m"))
    bounds = boundsFrom(given);
  else if (!bounds)
    root.refuse("key \"bounds_m\" is missing: give {min: [x, y], max: [x, y]}");
  if (yaml.fault()) return tl::unexpected(*yaml.fault());

  auto world = World::make(name, *bounds, floor_z_m, std::move(obstacles));
  if (!world) return fail(ErrorCode::kInvalidMap, yaml.path().string() + ": " + world.error().message);
  return Map{std::move(*world), std::move(queries)};
}

}  // namespace underway
