#include "bench/geometry.hpp"
#include "bench/peers/fcl_tree.hpp"

#include <cmath>
#include <numbers>

#include "bench/exactness.hpp"
#include "bench/grid_maps.hpp"
#include "bench/random_geometry.hpp"
#include "bench/stopwatch.hpp"
#include "geometry/checker.hpp"
#include "geometry/judge.hpp"
#include "geometry/layer.hpp"

namespace underway::bench {
namespace {

constexpr unsigned long kSeed = 1;
constexpr double kTurn_rad = 0.5 * std::numbers::pi;
constexpr double kEdge_m = 0.5;

/// A room of 8 x 8 m with 64 pieces of furniture.
std::vector<Obstacle> furniture(RandomGeometry& random, std::size_t count, double side_m) {
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < count; ++i) {
    const auto size = [&] { return random.between(0.1, 0.8); };
    obstacles.push_back({"box_" + std::to_string(i),
                         {{random.between(0.0, side_m), random.between(0.0, side_m), 0.5},
                          {size(), size(), 1.0},
                          {0.0, 0.0, random.angle()}}});
  }
  return obstacles;
}

std::shared_ptr<const World> roomOf(std::vector<Obstacle> obstacles, double side_m) {
  return std::make_shared<const World>(
      *World::make("room", {{-2.0, -2.0, 0.0}, side_m + 4.0, side_m + 4.0}, 0.0, std::move(obstacles)));
}

std::vector<Pose> posesIn(RandomGeometry& random, Range x, Range y, std::size_t count) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i)
    poses.push_back({random.between(x.min, x.max), random.between(y.min, y.max), random.angle()});
  return poses;
}

/// The robot's first body, for FCL and for a layer.
struct Upright {
  explicit Upright(const World& world)
      : robot(benchRobot()),
        prism(sweptBox(*robot, stay(0, {}), world.floorZ())),
        fcl(prism.x, prism.y, prism.z),
        layer(Layer::seenIn(prism.z, world.obstacles())),
        scene(world.obstacles()) {
    fcl.place({});
    keep(scene.touches(fcl) ? 1 : 0);  // makes the tree
  }

  [[nodiscard]] bool touches(const Pose& pose) {
    prism.frame = pose;
    return layer.touches(prism);
  }
  [[nodiscard]] bool fclTouches(const Pose& pose) {
    fcl.place(pose);
    return scene.touches(fcl);
  }

  std::shared_ptr<const Robot> robot;
  Prism prism;
  FclBody fcl;
  Layer layer;
  FclTree scene;
};

template <class Item, class Test>
std::function<void()> countOver(const std::vector<Item>& items, Test test) {
  return [&items, test] {
    std::size_t count = 0;
    for (const Item& item : items) count += test(item) ? 1 : 0;
    keep(count);
  };
}

class Figures {
 public:
  explicit Figures(Report& report) : report_(report) {}

  void value(const std::string& what, double value, const char* unit, unsigned long samples,
             const std::string& goal = {}, std::optional<bool> met = {}) {
    report_.rows.push_back({what, value, unit, goal, met, kSeed, samples, {}, {}});
  }

  /// `own` and `peer` each do `count` of the same.
  void ratio(const std::string& what, const std::string& peer, std::size_t count, std::optional<double> goal,
             const std::function<void()>& own, const std::function<void()>& run_peer) {
    constexpr int kRounds = 41;
    const Paired times = inTurn(own, run_peer, kRounds);
    const double scale = 1e6 / static_cast<double>(count);
    report_.rows.push_back({what, times.own_s * scale, "us",
                            goal ? ">= " + std::to_string(static_cast<int>(*goal)) + "x" : "",
                            goal ? std::optional(times.ratio >= *goal) : std::nullopt, kSeed, count * kRounds,
                            Row::Peer{peer, times.peer_s * scale}, times.ratio});
  }

 private:
  Report& report_;
};

void addExactness(Figures& figures, bool quick, const std::function<void(double)>& progress) {
  const unsigned long pairs = quick ? 1'000'000 : 100'000'000;
  const unsigned long motions = quick ? 100'000 : 10'000'000;
  const unsigned long clearances = quick ? 10'000 : 1'000'000;
  const auto part = [&](double begin, double length) {
    return [&progress, begin, length](double share) { progress(begin + length * share); };
  };
  const auto add = [&](const std::string& what, const Exactness& found, const char* fcl_missed) {
    figures.value(what + ": missed collisions", static_cast<double>(found.missed), "", found.cases, "0",
                  found.missed == 0);
    figures.value(what + ": false ones beyond 1 um from contact", static_cast<double>(found.false_alarms), "",
                  found.cases, "0", found.false_alarms == 0);
    figures.value(what + ": collisions", static_cast<double>(found.collisions), "", found.cases);
    figures.value(what + ": within 1 um of contact", static_cast<double>(found.near_contact), "",
                  found.cases);
    figures.value(what + ": told differently one by one, in a batch, by visiting",
                  static_cast<double>(found.disagreements), "", found.cases, "0", found.disagreements == 0);
    figures.value(what + ": beyond 1 um, references disagree", static_cast<double>(found.doubtful), "",
                  found.cases);
    figures.value(what + fcl_missed, static_cast<double>(found.fcl_missed), "", found.cases);
    figures.value(what + ": FCL wrong, false", static_cast<double>(found.fcl_false_alarms), "", found.cases);
  };
  add("random pairs", comparePairs(kSeed, pairs, part(0.0, 0.25)), ": FCL wrong, missed");
  add("random motions", compareMotions(kSeed, motions, part(0.25, 0.45)),
      ": FCL wrong, missed (turns sampled each 2 degrees)");
  const ClearanceExactness clear = compareClearances(kSeed, clearances, part(0.7, 0.25));
  figures.value("clearance: told above the truth, or 0 and free, or not 0 and not free",
                static_cast<double>(clear.above_truth), "", clear.cases, "0", clear.above_truth == 0);
  figures.value("clearance of poses and boxes: largest shortfall", clear.shortfall_of_poses_m, "m",
                clear.cases, "<= 1e-6", clear.shortfall_of_poses_m <= 1e-6);
  figures.value("clearance of turns: largest shortfall (reference to 2e-4)", clear.shortfall_of_turns_m, "m",
                clear.cases, "<= 1e-3", clear.shortfall_of_turns_m <= 1e-3);
}

void addRoom(Figures& figures) {
  constexpr double kSide_m = 8.0;
  constexpr std::size_t kPoses = 4000;
  RandomGeometry random(kSeed);
  const auto world = roomOf(furniture(random, 64, kSide_m), kSide_m);
  Upright body(*world);
  const Checker checker(world, body.robot);
  const std::vector<Pose> poses = posesIn(random, {0.0, kSide_m}, {0.0, kSide_m}, kPoses);
  std::vector<Motion> stays, edges, turns;  // edges and turns leave poses that are free
  for (const Pose& pose : poses) {
    stays.push_back(stay(0, pose));
    if (body.touches(pose)) continue;
    edges.push_back(translate(0, Sense::kForward, pose, kEdge_m));
    turns.push_back(turn(0, pose, kTurn_rad, normalizedAngle(pose.yaw + kTurn_rad)));
  }
  const auto is_free = [&](const Motion& motion) { return checker.isFree(motion, 0.0); };
  // As a user of FCL does it: pose by pose, until one touches.
  const auto sampled = [&](const Motion& motion, int steps) {
    const double yaw = motion.from.yaw;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const Pose at{motion.from.x + t * (motion.to.x - motion.from.x),
                    motion.from.y + t * (motion.to.y - motion.from.y), yaw + t * motion.angle_rad};
      if (body.fclTouches(at)) return false;
    }
    return true;
  };
  figures.ratio("one upright body against 64 boxes", "FCL's tree", poses.size(), 30.0,
                countOver(poses, [&](const Pose& pose) { return body.touches(pose); }),
                countOver(poses, [&](const Pose& pose) { return body.fclTouches(pose); }));
  figures.ratio("the same, asked of the checker, bounds and all", "FCL's tree", stays.size(), {},
                countOver(stays, is_free),
                countOver(poses, [&](const Pose& pose) { return body.fclTouches(pose); }));
  figures.ratio("one 0.5 m edge against 64 boxes", "FCL each 1 cm", edges.size(), 300.0,
                countOver(edges, is_free),
                countOver(edges, [&](const Motion& motion) { return sampled(motion, 50); }));
  figures.ratio("one 90 degree turn against 64 boxes", "FCL each 2 degrees", turns.size(), 100.0,
                countOver(turns, is_free),
                countOver(turns, [&](const Motion& motion) { return sampled(motion, 45); }));
}

/// How long one call for many bodies takes, by pair of body and obstacle [ns].
double nanosecondsAPair(const Layer& layer, const std::vector<Prism>& bodies, std::size_t obstacles) {
  std::vector<char> touched(bodies.size());
  const double seconds = medianOf([&] { layer.touchEach(bodies, touched); }, 31);
  return 1e9 * seconds / static_cast<double>(bodies.size() * obstacles);
}

void addBatch(Figures& figures) {
  constexpr double kSide_m = 8.0;
  constexpr std::size_t kBodies = 10'000;
  RandomGeometry random(kSeed);
  const auto world = roomOf(furniture(random, 64, kSide_m), kSide_m);
  Upright body(*world);
  std::vector<Prism> bodies;
  for (const Pose& pose : posesIn(random, {0.0, kSide_m}, {0.0, kSide_m}, kBodies)) {
    body.prism.frame = pose;
    bodies.push_back(body.prism);
  }
  const double pair = nanosecondsAPair(body.layer, bodies, 64);
  figures.value("one upright pair in a batch (10,000 poses and 64 boxes in one call)", pair, "ns",
                kBodies * 64, "< 1", pair < 1.0);
  // Slats side by side, slantwise over the room: every node's area meets every body's, so the tree sorts out
  // nothing.
  std::vector<Obstacle> slats;
  slats.reserve(64);
  for (int i = 0; i < 64; ++i)
    slats.push_back({"slat_" + std::to_string(i),
                     {{4.0 + 0.001 * i, 4.0, 0.5}, {11.0, 0.001, 1.0}, {0.0, 0.0, 0.25 * std::numbers::pi}}});
  const auto slatted = roomOf(slats, kSide_m);
  const Layer layer = Layer::seenIn(body.prism.z, slatted->obstacles());
  figures.value("the same, where the tree sorts nothing out", nanosecondsAPair(layer, bodies, 64), "ns",
                kBodies * 64);
}

void addChange(Figures& figures) {
  constexpr std::size_t kBoxes = 10'000;
  constexpr std::size_t kChanges = 4000;
  constexpr double kSide_m = 100.0;
  RandomGeometry random(kSeed);
  auto world = roomOf(furniture(random, kBoxes, kSide_m), kSide_m);
  Checker checker(world, benchRobot());
  const Motion pose = stay(0, {0.5 * kSide_m, 0.5 * kSide_m, 0.0});
  std::vector<double> took_us, judge_us;
  for (std::size_t i = 0; i < kChanges; ++i) {
    const Obstacle& moved = world->obstacles()[random.oneOf(kBoxes)];
    OrientedBox box = moved.box;
    box.center_m.x += random.between(-1.0, 1.0);
    box.center_m.y += random.between(-1.0, 1.0);
    std::shared_ptr<const World> next;
    std::optional<Checker> changed;
    took_us.push_back(1e6 * secondsOf([&] {
                        next = std::make_shared<const World>(*world->moved(moved.id, box));
                        changed.emplace(checker.at(next));
                      }));
    judge_us.push_back(1e6 * secondsOf([&] { keep(changed->judge().isClear(pose, 0.0) ? 1 : 0); }));
    world = next;
    checker = std::move(*changed);
  }
  const double median = quantile(took_us, 0.5);
  figures.value("changing one box of 10,000: world and checker, p50", median, "us", kChanges, "< 50",
                median < 50.0);
  figures.value("changing one box of 10,000: world and checker, p99", quantile(took_us, 0.99), "us",
                kChanges);
  figures.value("the judge's first answer after that, p50", quantile(judge_us, 0.5), "us", kChanges);
  figures.value("the judge's first answer after that, longest (FCL's tree made anew)",
                quantile(judge_us, 1.0), "us", kChanges);
}

void addGrid(Figures& figures, const GridMaps& maps) {
  const std::string& name = maps.name();
  std::shared_ptr<const World> world;
  const auto load = [&](const std::filesystem::path& file) {
    auto map = readMap(file, maps.options());
    world = std::make_shared<const World>(std::move(map->world));
    keep(Checker(world, benchRobot()).isFree(stay(0, {})) ? 1 : 0);
  };
  // Together, since together they are compared.
  const Paired times = inTurn([&] { load(maps.plain()); }, [&] { load(maps.fourfold()); }, 7);
  figures.value("load and index " + name + " (" + std::to_string(maps.cells()) + " cells)", 1e3 * times.own_s,
                "ms", maps.cells(), "< 150", times.own_s < 0.150);
  figures.value("4x the area of " + name, times.ratio, "x the time", 4 * maps.cells(), "< 4.5",
                times.ratio < 4.5);
  load(maps.plain());
  figures.value("obstacles of " + name + ", after merging", static_cast<double>(world->obstacles().size()),
                "", maps.cells());
  const Checker checker(world, benchRobot());
  const double judge_s = secondsOf([&] { keep(checker.judge().isClear(stay(0, {}), 0.0) ? 1 : 0); });
  figures.value("the judge's first answer there (FCL's tree made)", 1e3 * judge_s, "ms", 1);
  RandomGeometry random(kSeed);
  Upright body(*world);
  const Bounds& bounds = world->bounds();
  const auto poses = posesIn(random, {bounds.corner.x, bounds.corner.x + bounds.width_m},
                             {bounds.corner.y, bounds.corner.y + bounds.height_m}, 4000);
  figures.ratio("a pose in " + name + ", after merging, through the index", "FCL's tree", poses.size(), 10.0,
                countOver(poses, [&](const Pose& pose) { return body.touches(pose); }),
                countOver(poses, [&](const Pose& pose) { return body.fclTouches(pose); }));
}

}  // namespace

Expected<Report> geometry(const GeometryOptions& options, const std::function<void(double)>& progress) {
  const auto maps = GridMaps::make(options.grid, options.resolution_m);
  if (!maps) return tl::unexpected(maps.error());
  Report report{"geometry", {}};
  Figures figures(report);
  addRoom(figures);
  addBatch(figures);
  addChange(figures);
  addGrid(figures, *maps);
  progress(0.05);
  addExactness(figures, options.quick, [&](double share) { progress(0.05 + 0.95 * share); });
  progress(1.0);
  return report;
}

}  // namespace underway::bench
