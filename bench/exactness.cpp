#include "bench/exactness.hpp"
#include "bench/peers/fcl_tree.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <thread>
#include <vector>

#include "bench/random_geometry.hpp"
#include "bench/reference.hpp"
#include "geometry/checker.hpp"
#include "geometry/layer.hpp"

namespace underway::bench {
namespace {

constexpr double kNear_m = 1e-6;
constexpr std::size_t kObstacles = 8;  // in a world
constexpr std::size_t kBodies = 128;   // in a world, each against all obstacles
constexpr double kNudgedShare = 0.5;   // of the cases, to the edge of contact
constexpr double kBound_m = 4e4;

std::vector<Point> footprintOf(const Prism& body) {
  const auto corners = body.footprint();
  return {corners.begin(), corners.end()};
}

/// Adds up what `run(seed)` finds over many rounds, on all cores.
template <class Result>
Result overRounds(std::uint64_t seed, std::uint64_t rounds, const ProgressSink& progress,
                  const std::function<Result(std::uint64_t)>& run) {
  std::atomic<std::uint64_t> next = 0;
  std::mutex adding;
  Result sum;
  const auto work = [&] {
    for (std::uint64_t round = next++; round < rounds; round = next++) {
      const Result one = run(seed * 0x9e3779b97f4a7c15ULL + round);
      const std::lock_guard lock(adding);
      sum.add(one);
      if (progress) progress(static_cast<double>(round + 1) / static_cast<double>(rounds));
    }
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 1; i < std::max(1U, std::thread::hardware_concurrency()); ++i) workers.emplace_back(work);
  work();
  workers.clear();  // joins
  return sum;
}

/// Counts one case: how far apart the references say it is, what the second one says, and the answers.
void count(Exactness& tally, double separation_m, bool second_says_apart, bool touches, bool fcl_touches) {
  const bool collides = separation_m <= 0.0;
  const bool is_near = std::abs(separation_m) <= kNear_m;
  ++tally.cases;
  tally.answers += touches ? tally.cases * tally.cases : 0;
  tally.collisions += collides ? 1 : 0;
  tally.near_contact += is_near ? 1 : 0;
  tally.missed += collides && !touches ? 1 : 0;
  tally.false_alarms += !collides && !is_near && touches ? 1 : 0;
  if (is_near) return;
  if (second_says_apart == collides)
    ++tally.doubtful;
  else if (fcl_touches != collides)
    ++(collides ? tally.fcl_missed : tally.fcl_false_alarms);
}

Exactness pairsOfRound(std::uint64_t seed) {
  RandomGeometry random(seed);
  const Range slab{0.005, random.between(0.1, 0.6)};
  const Point about = random.somewhere();
  const std::vector<Obstacle> obstacles = random.obstacles(about, kObstacles);
  std::optional<std::string> no_twin;
  // Others far around, too far to matter: they make the tree deeper and move its origin away.
  std::vector<Obstacle> all = obstacles;
  for (Obstacle& other : random.farObstacles(about)) all.push_back(std::move(other));
  const Obstacles table(all, no_twin);
  const Layer dut = Layer::seenIn(slab, table);
  std::vector<std::vector<Point>> shadows;
  std::vector<FclTree> scenes;
  for (const Obstacle& obstacle : obstacles) {
    shadows.push_back(reference::shadow(obstacle.box, slab));
    scenes.emplace_back(Obstacles(std::vector{obstacle}, no_twin));
  }
  Exactness tally;
  for (std::size_t k = 0; k < kBodies; ++k) {
    Prism body = random.body(about, slab);
    const auto& shadow = shadows[random.oneOf(kObstacles)];
    if (!shadow.empty() && random.between(0.0, 1.0) < kNudgedShare) {
      const Point by = random.toContact(footprintOf(body), shadow);
      body.frame.x += by.x;
      body.frame.y += by.y;
    }
    std::vector<bool> touched(all.size(), false);
    dut.visitTouched(body, [&](const Piece& piece) {
      touched[*table.find(piece.obstacle->id)] = true;
      return false;
    });
    tally.false_alarms +=
        static_cast<std::uint64_t>(std::count(touched.begin() + kObstacles, touched.end(), true));
    const bool any = std::find(touched.begin(), touched.end(), true) != touched.end();
    FclBody fcl(body.x, body.y, body.z);
    fcl.place(body.frame);
    for (std::size_t i = 0; i < kObstacles; ++i) {
      const bool second_says_apart =
          shadows[i].empty() || reference::distance(footprintOf(body), shadows[i]) > 0.0;
      count(tally, reference::separation(body, obstacles[i].box), second_says_apart, touched[i],
            scenes[i].touches(fcl));
    }
    tally.disagreements += dut.touches(body) != any ? 1 : 0;
  }
  return tally;
}

/// A world of few obstacles, a robot, and what both references make of its motions.
class MotionRound {
 public:
  explicit MotionRound(std::uint64_t seed)
      : random_(seed),
        robot_(benchRobot()),
        about_(random_.somewhere()),
        world_(std::make_shared<const World>(*World::make(
            "random", {{about_.x - kBound_m / 4, about_.y - kBound_m / 4, 0.0}, kBound_m / 2, kBound_m / 2},
            0.0, random_.obstacles(about_, kObstacles)))),
        dut_(world_, robot_),
        fcl_(world_->obstacles()) {}

  Exactness compare() {
    Exactness tally;
    for (std::size_t k = 0; k < kBodies; ++k) {
      const Motion motion = nudged(random_.motion(about_, *robot_));
      const bool touches = !dut_.isFree(motion, 0.0);
      tally.disagreements += touches == (dut_.areFree(std::span(&motion, 1), 0.0)[0] != 0) ? 1 : 0;
      tally.disagreements += touches == dut_.blockers(motion, 0.0).empty() ? 1 : 0;
      const auto [first, second_says_apart] = separationOf(motion);
      count(tally, first, second_says_apart, touches, fclTouches(motion));
    }
    return tally;
  }

  ClearanceExactness compareClearances() {
    ClearanceExactness tally;
    for (std::size_t k = 0; k < kBodies; ++k) {
      Motion motion = nudged(random_.motion(about_, *robot_));
      if (random_.oneOf(3) == 0) motion = stay(motion.mode, motion.from);
      const double told = dut_.closeness(motion, kCap_m).clearance_m;
      const bool is_turning = motion.kind == MotionKind::kTurn && motion.angle_rad != 0.0;
      const double at_most = is_turning ? distanceOfTurn(motion, kTurn_m, kCap_m).at_most_m : planar(motion);
      ++tally.cases;
      tally.above_truth += told > at_most ? 1 : 0;
      double& shortfall = is_turning ? tally.shortfall_of_turns_m : tally.shortfall_of_poses_m;
      shortfall = std::max(shortfall, std::min(at_most, kCap_m) - told);
      // And 0 exactly when the motion is not free.
      tally.above_truth += (told == 0.0) == dut_.isFree(motion, 0.0) ? 1 : 0;
    }
    return tally;
  }

 private:
  static constexpr double kTurn_m = 2e-4;  // to which the reference finds a turn's
  static constexpr double kCap_m = 10.0;

  [[nodiscard]] Prism swept(const Motion& motion) const { return sweptBox(*robot_, motion, 0.0); }

  const std::vector<Point>& shadowOf(const Obstacle& obstacle, Range slab) {
    auto& known = shadows_[{obstacle.id, slab.min, slab.max}];
    if (!known) known = reference::shadow(obstacle.box, slab);
    return *known;
  }

  /// To the edge of contact with some obstacle, at the beginning, the end or some heading on the way.
  Motion nudged(Motion motion) {
    if (random_.between(0.0, 1.0) >= kNudgedShare) return motion;
    Prism body = swept(motion);
    const auto& obstacle = world_->obstacles()[random_.oneOf(kObstacles)];
    const auto& shadow = shadowOf(obstacle, body.z);
    if (shadow.empty()) return motion;
    body.frame.yaw += motion.angle_rad * random_.between(0.0, 1.0);
    const Point by = random_.toContact(footprintOf(body), shadow);
    for (Pose* pose : {&motion.from, &motion.to}) pose->x += by.x, pose->y += by.y;
    return motion;
  }

  /// The least separation by the first reference, and whether the second says that all are apart.
  std::pair<double, bool> separationOf(const Motion& motion) {
    if (motion.kind == MotionKind::kTurn) {
      const auto bracket = distanceOfTurn(motion, 0.1 * kNear_m, 2.0 * kNear_m);
      // What may or may not touch is within a tenth of what counts as near.
      const double least = bracket.at_most_m > 0.0 ? std::max(bracket.at_least_m, 1e-12) : -1.0;
      return {least, bracket.at_most_m > 0.0};
    }
    const Prism body = swept(motion);
    double least = 1e9;
    for (const Obstacle& obstacle : world_->obstacles())
      least = std::min(least, reference::separation(body, obstacle.box));
    return {least, planar(motion) > 0.0};
  }

  /// As a user of FCL does it: turns are sampled.
  bool fclTouches(const Motion& motion) {
    constexpr double kStep_rad = 2.0 * std::numbers::pi / 180.0;
    const Prism body = swept(motion);
    FclBody fcl(body.x, body.y, body.z);
    const double turned = sweptAngle(motion);
    const int steps = static_cast<int>(std::ceil(std::abs(turned) / kStep_rad));
    for (int i = 0; i <= steps; ++i) {
      fcl.place({body.frame.x, body.frame.y, body.frame.yaw + (steps > 0 ? turned * i / steps : 0.0)});
      if (fcl_.touches(fcl)) return true;
    }
    return false;
  }

  double planar(const Motion& motion) {
    const Prism body = swept(motion);
    double least = 1e9;
    for (const Obstacle& obstacle : world_->obstacles())
      if (const auto& shadow = shadowOf(obstacle, body.z); !shadow.empty())
        least = std::min(least, reference::distance(footprintOf(body), shadow));
    return least;
  }

  reference::Bracket distanceOfTurn(const Motion& motion, double tolerance_m, double enough_m) {
    const Prism body = swept(motion);
    reference::Bracket least{1e9, 1e9};
    for (const Obstacle& obstacle : world_->obstacles()) {
      const auto& shadow = shadowOf(obstacle, body.z);
      if (shadow.empty()) continue;
      const auto one = reference::distanceOfTurn(body, sweptAngle(motion), shadow, tolerance_m, enough_m);
      least = {std::min(least.at_least_m, one.at_least_m), std::min(least.at_most_m, one.at_most_m)};
    }
    return least;
  }

  RandomGeometry random_;
  std::shared_ptr<const Robot> robot_;
  Point about_;
  std::shared_ptr<const World> world_;
  Checker dut_;
  FclTree fcl_;
  std::map<std::tuple<std::string, double, double>, std::optional<std::vector<Point>>> shadows_;
};

std::uint64_t roundsFor(std::uint64_t cases, std::uint64_t in_a_round) {
  return (cases + in_a_round - 1) / in_a_round;
}

}  // namespace

void Exactness::add(const Exactness& other) {
  cases += other.cases;
  collisions += other.collisions;
  near_contact += other.near_contact;
  missed += other.missed;
  false_alarms += other.false_alarms;
  fcl_missed += other.fcl_missed;
  fcl_false_alarms += other.fcl_false_alarms;
  disagreements += other.disagreements;
  doubtful += other.doubtful;
  answers += other.answers;  // in any order
}

void ClearanceExactness::add(const ClearanceExactness& other) {
  cases += other.cases;
  above_truth += other.above_truth;
  shortfall_of_poses_m = std::max(shortfall_of_poses_m, other.shortfall_of_poses_m);
  shortfall_of_turns_m = std::max(shortfall_of_turns_m, other.shortfall_of_turns_m);
}

Exactness comparePairs(std::uint64_t seed, std::uint64_t pairs, const ProgressSink& progress) {
  return overRounds<Exactness>(seed, roundsFor(pairs, kBodies * kObstacles), progress, pairsOfRound);
}

Exactness compareMotions(std::uint64_t seed, std::uint64_t motions, const ProgressSink& progress) {
  return overRounds<Exactness>(seed, roundsFor(motions, kBodies), progress,
                               [](std::uint64_t s) { return MotionRound(s).compare(); });
}

ClearanceExactness compareClearances(std::uint64_t seed, std::uint64_t cases, const ProgressSink& progress) {
  return overRounds<ClearanceExactness>(seed, roundsFor(cases, kBodies), progress,
                                        [](std::uint64_t s) { return MotionRound(s).compareClearances(); });
}

}  // namespace underway::bench
