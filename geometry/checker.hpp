#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/motion.hpp"
#include "geometry/robot.hpp"
#include "geometry/turning.hpp"
#include "geometry/world.hpp"

namespace underway {

class Judge;
class Layer;

/// Where an obstacle comes closest to a moving body.
struct Nearest {
  std::string id;  ///< obstacle id
  Point at;        ///< a point of the obstacle, as the mode sees it, in the map frame [m]
};

/// How close a motion comes to the obstacles its mode sees.
struct Closeness {
  double clearance_m =
      0.0;  ///< planar; never above the truth and at most 1 um below; capped; 0 when it touches
  std::optional<Nearest> nearest;    ///< empty when nothing is closer than the cap
  std::optional<double> headroom_m;  ///< smallest vertical gap above the body; empty when nothing hangs there
};

/// Answers what a robot may do in a world: is this motion free, and how close does it come? Which engine
/// answers is nobody's business outside this folder.
///
/// A mode sees the slab [floor + max(step over, 5 mm), floor + body height]; obstacles are cut to it and
/// projected. Touching is a collision. All motions are judged exactly, not sampled: a translation sweeps one
/// box, widened to both sides by drift times length; a switch is its box; a turn is arcs against edges
/// (turning.hpp). What is further than 1 um from contact is told right; nothing that touches is told free.
///
/// Thread safety: every const member may be called from any number of threads.
class Checker {
 public:
  Checker(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot);
  ~Checker();
  Checker(Checker&&) noexcept;
  Checker& operator=(Checker&&) noexcept;

  /// The checker of another revision of the world. It shares with this one what did not change, so few
  /// changes take microseconds; this one stays as it is. Any world is right, a related one is quick.
  [[nodiscard]] Checker at(std::shared_ptr<const World> revision) const;

  [[nodiscard]] const World& world() const;
  [[nodiscard]] const Robot& robot() const;

  /// Free of obstacles when the body grows by `margin_m` to all four sides, and inside the bounds as it is.
  [[nodiscard]] bool isFree(const Motion& motion, double margin_m) const;
  [[nodiscard]] bool isFree(const Motion& motion) const { return isFree(motion, robot().margin_m); }
  /// The same for many motions in one call: element i says whether motion i is free.
  [[nodiscard]] std::vector<char> areFree(std::span<const Motion> motions, double margin_m) const;

  /// Whether the whole body stays inside the bounds. What is not finite does not.
  [[nodiscard]] bool isInBounds(const Motion& motion) const;

  /// Clearance up to a cap, nearest obstacle (of equally near ones that with the smallest id) and headroom.
  /// Bounds are no obstacles.
  [[nodiscard]] Closeness closeness(const Motion& motion, double cap_m = 1.0) const;
  /// Its clearance alone, which is told far sooner: headroom below tilted obstacles takes long in turns [m].
  [[nodiscard]] double clearance(const Motion& motion, double cap_m) const;

  /// Whether the mode's body can turn all the way round at a point, kept `margin_m` from everything and in
  /// bounds. Judged by the circle round the body: `false` may still leave single turns free.
  [[nodiscard]] bool isFreeAllRound(ModeId mode, Point at, double margin_m) const;

  /// How far a mode's body can turn from a free pose, each way, kept `margin_m` from everything and in
  /// bounds. Never more than it truly can; less by 1e-7 rad or so, and by more where it comes to the bounds.
  [[nodiscard]] TurningRoom turningRoom(ModeId mode, const Pose& at, double margin_m) const;

  /// Ids of obstacles that the motion touches when the body grows by `margin_m`, sorted, up to `most`.
  [[nodiscard]] std::vector<std::string> blockers(const Motion& motion, double margin_m,
                                                  std::size_t most = 8) const;

  /// The pieces of floor that a motion's body must not touch; lives as long as the checker.
  [[nodiscard]] const Layer& seenBy(const Motion& motion) const;

  /// The independent second opinion on a motion (geometry/judge.hpp); lives as long as the checker.
  [[nodiscard]] const Judge& judge() const;

 private:
  struct Engine;
  explicit Checker(std::unique_ptr<const Engine> engine);
  std::unique_ptr<const Engine> engine_;
};

}  // namespace underway
