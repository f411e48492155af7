#include "geometry/checker.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/fcl_scene.hpp"
#include "geometry/judge.hpp"
#include "geometry/layer.hpp"
#include "geometry/turn_minimum.hpp"

namespace underway {
namespace {

constexpr double kTurnContact_m = 1e-4;  // a turn is refused when it may come this close to contact
constexpr double kAnyHeight_m = 1e6;

struct Rectangle {
  Range x;
  Range y;
  [[nodiscard]] Rectangle grown(double by) const { return {x.grown(by), y.grown(by)}; }
};

Rectangle rectangleAround(ConvexView points) {
  Rectangle box{{points[0].x, points[0].x}, {points[0].y, points[0].y}};
  for (const Point p : points) box = {hull(box.x, {p.x, p.x}), hull(box.y, {p.y, p.y})};
  return box;
}

}  // namespace

struct Checker::Engine {
  Engine(std::shared_ptr<const World> w, std::shared_ptr<const Robot> r)
      : world(std::move(w)), robot(std::move(r)), scene(*world), judge(*world, *robot, scene) {
    for (std::size_t mode = 0; mode < robot->modes.size(); ++mode)
      addLayer(slabOf(*robot, stay(static_cast<ModeId>(mode), {}), world->floorZ()));
    for (const Switch& change : robot->switches)
      addLayer(slabOf(*robot, switchModes(change, {}), world->floorZ()));
  }

  void addLayer(Range slab) {
    const bool known =
        std::any_of(layers.begin(), layers.end(), [&](const Layer& l) { return l.slab() == slab; });
    if (!known) layers.emplace_back(*world, slab);
  }

  [[nodiscard]] const Layer& layerOf(Range slab) const {
    return *std::find_if(layers.begin(), layers.end(), [&](const Layer& l) { return l.slab() == slab; });
  }

  [[nodiscard]] Prism swept(const Motion& motion) const { return sweptBox(*robot, motion, world->floorZ()); }

  [[nodiscard]] bool isInside(const Prism& box) const {
    const auto footprint = box.footprint();
    return std::all_of(footprint.begin(), footprint.end(),
                       [&](Point p) { return world->bounds().contains(p); });
  }

  /// Calls `test(body, moved)` on bodies along a motion that, grown by `moved` [m], cover all of it; halves
  /// the intervals of a turn that fail, down to kTurnContact_m. True when all pass.
  template <class Test>
  [[nodiscard]] bool allAlong(const Motion& motion, const Test& test) const {
    Prism body = swept(motion);
    if (motion.kind != MotionKind::kTurn || motion.angle_rad == 0.0) return test(body, 0.0);
    const double reach = reachOf(robot->modes[motion.mode].body_m);
    const auto passes = [&](const auto& self, double middle, double half) -> bool {
      body.frame.yaw = motion.from.yaw + middle;
      if (test(body, reach * half)) return true;
      if (reach * half <= kTurnContact_m) return false;
      return self(self, middle - 0.5 * half, 0.5 * half) && self(self, middle + 0.5 * half, 0.5 * half);
    };
    return passes(passes, 0.5 * sweptAngle(motion), 0.5 * std::abs(sweptAngle(motion)));
  }

  /// All that a motion's body can reach, as an axis-aligned rectangle.
  [[nodiscard]] Rectangle regionOf(const Motion& motion) const {
    if (motion.kind != MotionKind::kTurn || motion.angle_rad == 0.0)
      return rectangleAround(swept(motion).footprint());
    const double reach = reachOf(robot->modes[motion.mode].body_m);
    return Rectangle{{motion.from.x, motion.from.x}, {motion.from.y, motion.from.y}}.grown(reach);
  }

  std::shared_ptr<const World> world;
  std::shared_ptr<const Robot> robot;
  FclScene scene;
  Judge judge;
  std::vector<Layer> layers;
};

Checker::Checker(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot)
    : engine_(std::make_unique<Engine>(std::move(world), std::move(robot))) {}
Checker::~Checker() = default;
Checker::Checker(Checker&&) noexcept = default;
Checker& Checker::operator=(Checker&&) noexcept = default;

const World& Checker::world() const { return *engine_->world; }
const Robot& Checker::robot() const { return *engine_->robot; }
const Judge& Checker::judge() const { return engine_->judge; }

bool Checker::isFree(const Motion& motion, double margin_m) const {
  return isInBounds(motion) && engine_->allAlong(motion, [&](const Prism& body, double moved) {
    return !engine_->scene.touches(body.grown(margin_m + moved));
  });
}

bool Checker::isInBounds(const Motion& motion) const {
  const Prism body = engine_->swept(motion);
  if (motion.kind != MotionKind::kTurn || motion.angle_rad == 0.0) return engine_->isInside(body);
  const Point pivot = motion.from.position();
  const auto footprint = body.footprint();
  return std::all_of(footprint.begin(), footprint.end(), [&](Point corner) {
    const double direction = std::atan2(corner.y - pivot.y, corner.x - pivot.x);
    return world().bounds().containsArc(pivot, distance(pivot, corner), direction, motion.angle_rad);
  });
}

bool Checker::isFreeAllRound(ModeId mode, Point at, double margin_m) const {
  const BodyBox& body = robot().modes[mode].body_m;
  const double room = reachOf(body) + std::sqrt(2.0) * margin_m;
  const Prism square{{at.x, at.y, 0.0}, {-room, room}, {-room, room}, {}};
  if (!engine_->isInside(square)) return false;
  const Layer& layer = engine_->layerOf(slabOf(robot(), stay(mode, {}), world().floorZ()));
  bool free = true;
  engine_->scene.visitNear({at.x - room, at.x + room}, {at.y - room, at.y + room}, layer.slab(),
                           [&](std::size_t i) {
                             const ConvexView piece = layer.piece(i);
                             free = piece.empty() || distanceTo(piece, at) > room;
                             return !free;
                           });
  return free;
}

Closeness Checker::closeness(const Motion& motion, double cap_m, double turn_tolerance_m) const {
  const Prism body = engine_->swept(motion);
  const Layer& layer = engine_->layerOf(body.z);
  const Rectangle region = engine_->regionOf(motion).grown(cap_m);
  const TurnMinimum along(motion, reachOf(robot().modes[motion.mode].body_m), turn_tolerance_m);
  Closeness result{cap_m, std::nullopt, std::nullopt};
  const auto footprint_at = [&](double yaw) {
    Prism turned = body;
    turned.frame.yaw = yaw;
    return turned.footprint();
  };
  engine_->scene.visitNear(region.x, region.y, {body.z.min, kAnyHeight_m}, [&](std::size_t i) {
    const Obstacle& obstacle = world().obstacles()[i];
    if (const ConvexView piece = layer.piece(i); !piece.empty()) {
      const auto gap_at = [&](double yaw) { return gapBetween(footprint_at(yaw), piece); };
      const Gap least = along.leastGap(gap_at, result.clearance_m);
      if (least.distance_m < result.clearance_m) {
        result.clearance_m = least.distance_m;
        result.nearest = Nearest{obstacle.id, least.at};
      }
    }
    const auto height_at = [&](double yaw, double moved) {
      Prism turned = body.grown(moved);
      turned.frame.yaw = yaw;
      return lowestAbove(obstacle.box, turned.footprint(), body.z.max);
    };
    if (const auto lowest = along.lowest(height_at)) {
      const double gap = *lowest - body.z.max;
      result.headroom_m = std::min(result.headroom_m.value_or(gap), gap);
    }
    return false;
  });
  return result;
}

std::vector<std::string> Checker::blockers(const Motion& motion, double margin_m, std::size_t most) const {
  std::set<std::size_t> found;
  // The passing pieces tell nothing; of the failing ones, those at the finest halving name who is hit.
  (void)engine_->allAlong(motion, [&](const Prism& body, double moved) {
    if (moved > kTurnContact_m) return false;
    engine_->scene.visitTouched(body.grown(margin_m + moved), [&](std::size_t i) {
      found.insert(i);
      return false;
    });
    return true;
  });
  std::vector<std::string> ids;
  for (const std::size_t i : found)
    if (ids.size() < most) ids.push_back(world().obstacles()[i].id);
  return ids;
}

}  // namespace underway
