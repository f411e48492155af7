#include "geometry/checker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "geometry/fcl_scene.hpp"
#include "geometry/headroom.hpp"
#include "geometry/judge.hpp"
#include "geometry/layer.hpp"
#include "geometry/turning.hpp"

namespace underway {
namespace {

bool isTurning(const Motion& motion) { return motion.kind == MotionKind::kTurn && motion.angle_rad != 0.0; }

bool isFinite(const Motion& motion) {
  return std::isfinite(motion.from.x + motion.from.y + motion.from.yaw + motion.to.x + motion.to.y +
                       motion.angle_rad);
}

/// What modes of one slab see, and what hangs above them.
struct View {
  Range slab;
  Layer seen;
  Layer hanging;

  View(Range z, const Obstacles& obstacles)
      : slab(z), seen(Layer::seenIn(z, obstacles)), hanging(Layer::hangingAbove(z.max, obstacles)) {}
  View(Range z, const Layer& as_seen, const Obstacles& obstacles)
      : slab(z), seen(as_seen.askedIn(z)), hanging(Layer::hangingAbove(z.max, obstacles)) {}
  View(const View& before, std::span<const Obstacles::Change> changes)
      : slab(before.slab), seen(before.seen.changed(changes)), hanging(before.hanging.changed(changes)) {}
};

/// `body`: what the motion covers, or of a turn the body where it begins.
std::optional<Layer::Neighbour> nearestTo(const View& view, const Prism& body, const Motion& motion,
                                          double cap_m) {
  return isTurning(motion) ? view.seen.nearest(Turning(body, motion.angle_rad), cap_m)
                           : view.seen.nearest(body, cap_m);
}

/// The bounds, ready to be asked often.
class Fence {
 public:
  explicit Fence(const Bounds& bounds)
      : bounds_(bounds), cos_(std::cos(bounds.corner.yaw)), sin_(std::sin(bounds.corner.yaw)) {}

  [[nodiscard]] bool holds(const Prism& body) const {
    if (isFarInside(body)) return true;
    const auto footprint = body.footprint();
    return std::all_of(footprint.begin(), footprint.end(), [&](Point p) { return bounds_.contains(p); });
  }

  [[nodiscard]] bool holdsTurning(const Prism& body, double angle_rad) const {
    if (isFarInside(body)) return true;
    const Point pivot = body.frame.position();
    const auto footprint = body.footprint();
    return std::all_of(footprint.begin(), footprint.end(), [&](Point corner) {
      const double direction = std::atan2(corner.y - pivot.y, corner.x - pivot.x);
      return bounds_.containsArc(pivot, distance(pivot, corner), direction, angle_rad);
    });
  }

  [[nodiscard]] TurningRoom turningRoom(const Prism& body) const {
    const auto corners = bounds_.corners();
    TurningRoom room{2.0 * std::numbers::pi, 2.0 * std::numbers::pi};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::array side{corners[i], corners[(i + 1) % corners.size()]};
      const TurningRoom beside = Turning(body, 2.0 * std::numbers::pi).roomBeside(side);
      room = {std::min(room.left_rad, beside.left_rad), std::min(room.right_rad, beside.right_rad)};
    }
    return room;
  }

 private:
  /// Whether the body is inside at any heading: most are, and that is quickly seen.
  [[nodiscard]] bool isFarInside(const Prism& body) const {
    const double dx = body.frame.x - bounds_.corner.x;
    const double dy = body.frame.y - bounds_.corner.y;
    const double x = cos_ * dx + sin_ * dy;
    const double y = cos_ * dy - sin_ * dx;
    const double reach = std::max(-body.x.min, body.x.max) + std::max(-body.y.min, body.y.max);
    return x >= reach && y >= reach && x <= bounds_.width_m - reach && y <= bounds_.height_m - reach;
  }

  Bounds bounds_;
  double cos_;
  double sin_;
};

}  // namespace

struct Checker::Engine {
  Engine(std::shared_ptr<const World> w, std::shared_ptr<const Robot> r)
      : world(std::move(w)),
        robot(std::move(r)),
        fence(world->bounds()),
        scene(obstaclesOf(world)),
        judge(*world, *robot, scene) {
    for (std::size_t mode = 0; mode < robot->modes.size(); ++mode)
      of_mode.push_back(viewOf(slabOf(*robot, stay(static_cast<ModeId>(mode), {}), world->floorZ())));
    for (const Switch& change : robot->switches)
      of_switch.push_back(viewOf(slabOf(*robot, switchModes(change, {}), world->floorZ())));
  }

  Engine(const Engine& before, std::shared_ptr<const World> revision)
      : world(std::move(revision)),
        robot(before.robot),
        fence(world->bounds()),
        of_mode(before.of_mode),
        of_switch(before.of_switch),
        scene(before.scene.changed(obstaclesOf(world))),
        judge(*world, *robot, scene) {
    const auto changes = Obstacles::changes(before.world->obstacles(), world->obstacles());
    const bool are_few = changes.size() <= world->obstacles().size() / 8 + 8;  // else it is quicker anew
    views.reserve(before.views.size());
    for (const View& view : before.views)
      are_few ? views.emplace_back(view, changes) : views.emplace_back(view.slab, world->obstacles());
  }

  static std::shared_ptr<const Obstacles> obstaclesOf(const std::shared_ptr<const World>& world) {
    return {world, &world->obstacles()};
  }

  std::size_t viewOf(Range slab) {
    const auto known =
        std::find_if(views.begin(), views.end(), [&](const View& view) { return view.slab == slab; });
    if (known != views.end()) return static_cast<std::size_t>(known - views.begin());
    // Walls that reach through all slabs look the same in each: one tree does for all.
    const auto alike = std::find_if(views.begin(), views.end(), [&](const View& view) {
      return Layer::looksAlike(view.slab, slab, world->obstacles());
    });
    if (alike != views.end())
      views.emplace_back(slab, alike->seen, world->obstacles());
    else
      views.emplace_back(slab, world->obstacles());
    return views.size() - 1;
  }

  [[nodiscard]] const View& view(const Motion& motion) const {
    if (motion.kind != MotionKind::kSwitch) return views[of_mode[motion.mode]];
    const Switch* change = robot->findSwitch(motion.mode, motion.to_mode);
    return views[of_switch[static_cast<std::size_t>(change - robot->switches.data())]];
  }

  [[nodiscard]] Prism swept(const Motion& motion) const {
    return sweptBox(*robot, motion, view(motion).slab);
  }

  [[nodiscard]] bool isInBounds(const Motion& motion, const Prism& body) const {
    return isFinite(motion) &&
           (isTurning(motion) ? fence.holdsTurning(body, motion.angle_rad) : fence.holds(body));
  }

  std::shared_ptr<const World> world;
  std::shared_ptr<const Robot> robot;
  Fence fence;
  std::vector<View> views;
  std::vector<std::size_t> of_mode;    // index into views
  std::vector<std::size_t> of_switch;  // by the robot's order
  FclScene scene;
  Judge judge;
};

Checker::Checker(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot)
    : engine_(std::make_unique<Engine>(std::move(world), std::move(robot))) {}
Checker::Checker(std::unique_ptr<const Engine> engine) : engine_(std::move(engine)) {}
Checker::~Checker() = default;
Checker::Checker(Checker&&) noexcept = default;
Checker& Checker::operator=(Checker&&) noexcept = default;

Checker Checker::at(std::shared_ptr<const World> revision) const {
  if (revision->floorZ() != world().floorZ()) return {std::move(revision), engine_->robot};
  return Checker(std::make_unique<const Engine>(*engine_, std::move(revision)));
}

const World& Checker::world() const { return *engine_->world; }
const Robot& Checker::robot() const { return *engine_->robot; }
const Judge& Checker::judge() const { return engine_->judge; }
const Layer& Checker::seenBy(const Motion& motion) const { return engine_->view(motion).seen; }

bool Checker::isFree(const Motion& motion, double margin_m) const {
  const View& view = engine_->view(motion);
  const Prism body = sweptBox(robot(), motion, view.slab);
  if (!engine_->isInBounds(motion, body)) return false;
  const Prism grown = body.grown(margin_m);
  return !(isTurning(motion) ? view.seen.touches(Turning(grown, motion.angle_rad))
                             : view.seen.touches(grown));
}

std::vector<char> Checker::areFree(std::span<const Motion> motions, double margin_m) const {
  std::vector<char> free(motions.size(), 0);
  // Boxes by the layer that sees them; turns one by one.
  struct Batch {
    std::vector<Prism> boxes;
    std::vector<std::size_t> of;  // index of the motion
  };
  std::vector<Batch> batches(engine_->views.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (isTurning(motions[i])) {
      free[i] = isFree(motions[i], margin_m) ? 1 : 0;
      continue;
    }
    const View& view = engine_->view(motions[i]);
    const Prism body = sweptBox(robot(), motions[i], view.slab);
    if (!engine_->isInBounds(motions[i], body)) continue;
    Batch& batch = batches[static_cast<std::size_t>(&view - engine_->views.data())];
    batch.boxes.push_back(body.grown(margin_m));
    batch.of.push_back(i);
  }
  std::vector<char> touched;
  for (std::size_t v = 0; v < batches.size(); ++v) {
    const Batch& batch = batches[v];
    touched.resize(batch.boxes.size());
    engine_->views[v].seen.touchEach(batch.boxes, touched);
    for (std::size_t k = 0; k < batch.of.size(); ++k) free[batch.of[k]] = touched[k] == 0 ? 1 : 0;
  }
  return free;
}

bool Checker::isInBounds(const Motion& motion) const {
  return engine_->isInBounds(motion, engine_->swept(motion));
}

bool Checker::isFreeAllRound(ModeId mode, Point at, double margin_m) const {
  const BodyBox& body = robot().modes[mode].body_m;
  const double room = reachOf(body) + std::sqrt(2.0) * margin_m;
  const Prism square{{at.x, at.y, 0.0}, {-room, room}, {-room, room}, {}};
  return engine_->fence.holds(square) && !engine_->views[engine_->of_mode[mode]].seen.touches(at, room);
}

TurningRoom Checker::turningRoom(ModeId mode, const Pose& at, double margin_m) const {
  const View& view = engine_->views[engine_->of_mode[mode]];
  const Prism body = sweptBox(robot(), stay(mode, at), view.slab);
  if (!engine_->fence.holds(body)) return {};
  TurningRoom room = view.seen.turningRoom(body.grown(margin_m));
  if (!engine_->fence.holdsTurning(body, 2.0 * std::numbers::pi)) {
    const TurningRoom inside = engine_->fence.turningRoom(body);
    room = {std::min(room.left_rad, inside.left_rad), std::min(room.right_rad, inside.right_rad)};
  }
  return room;
}

Closeness Checker::closeness(const Motion& motion, double cap_m) const {
  if (!isFinite(motion)) return {};
  const View& view = engine_->view(motion);
  const Prism body = sweptBox(robot(), motion, view.slab);
  const auto nearest = nearestTo(view, body, motion, cap_m);
  Closeness result{cap_m, std::nullopt, std::nullopt};
  if (nearest) {
    result.clearance_m = nearest->gap.distance_m;
    result.nearest = Nearest{nearest->piece->obstacle->id, nearest->gap.at};
  }
  result.headroom_m = isTurning(motion) ? headroomBelow(view.hanging, body, motion.angle_rad)
                                        : headroomBelow(view.hanging, body);
  return result;
}

double Checker::clearance(const Motion& motion, double cap_m) const {
  if (!isFinite(motion)) return 0.0;
  const View& view = engine_->view(motion);
  const auto nearest = nearestTo(view, sweptBox(robot(), motion, view.slab), motion, cap_m);
  return nearest ? nearest->gap.distance_m : cap_m;
}

std::vector<std::string> Checker::blockers(const Motion& motion, double margin_m, std::size_t most) const {
  if (!isFinite(motion)) return {};
  std::set<std::string> ids;
  const auto note = [&](const Piece& piece) {
    ids.insert(piece.obstacle->id);
    if (ids.size() > most) ids.erase(std::prev(ids.end()));
    return false;
  };
  const Prism body = engine_->swept(motion).grown(margin_m);
  const Layer& seen = engine_->view(motion).seen;
  if (isTurning(motion))
    seen.visitTouched(Turning(body, motion.angle_rad), note);
  else
    seen.visitTouched(body, note);
  return {ids.begin(), ids.end()};
}

}  // namespace underway
