#include "bench/rooms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bench/random_geometry.hpp"

namespace underway::bench {
namespace {

// NAO's needs (robots/nao.yaml), margins of .02 m to both sides included.
constexpr double kBroad_m = 0.39 + 0.04;
constexpr double kDeep_m = 0.26 + 0.04;
constexpr double kCrawlHigh_m = 0.21;
constexpr double kLyingDown_m = 0.81 + 0.04;
constexpr double kGettingUp_m = 0.73 + 0.04;
constexpr double kCrawlBroad_m = 0.52 + 0.04 + 0.06;  // and what 1.5 m of it may drift, to both sides
constexpr double kTurning_m = 0.53;                   // a standing body turns in a circle this wide

constexpr double kTall_m = 1.0;  // higher than any body

/// Builds a room in a frame of its own, x through the passage, and puts it somewhere.
class Builder {
 public:
  Builder(Need need, double slack_m, std::uint64_t seed) : random_(seed), slack_m_(slack_m) {
    width_m_ = random_.between(4.5, 7.0);
    height_m_ = random_.between(3.0, 5.0);
    passage_ = {width_m_ * random_.between(0.45, 0.55), height_m_ * random_.between(0.35, 0.65)};
    start_ = {passage_.x - random_.between(1.3, 1.7), passage_.y + random_.between(-0.6, 0.6),
              random_.angle()};
    goal_ = {passage_.x + random_.between(1.3, 1.7), passage_.y + random_.between(-0.6, 0.6),
             random_.angle()};
    build(need);
    addClutter();
  }

  Room room() {
    const Pose frame{random_.between(-20.0, 20.0), random_.between(-20.0, 20.0), random_.angle()};
    for (Obstacle& obstacle : obstacles_) {
      OrientedBox& box = obstacle.box;
      const Point at = transform(frame, {box.center_m.x, box.center_m.y});
      box.center_m = {at.x, at.y, box.center_m.z};
      box.rpy_rad.z = normalizedAngle(box.rpy_rad.z + frame.yaw);
    }
    Room room;
    room.world = std::make_shared<const World>(
        *World::make("room", {frame, width_m_, height_m_}, 0.0, std::move(obstacles_)));
    room.request.start = compose(frame, start_);
    const Pose goal = compose(frame, goal_);
    room.request.goal = goal.position();
    if (random_.oneOf(3) != 0) room.request.goal_yaw = goal.yaw;
    return room;
  }

 private:
  void build(Need need) {
    switch (need) {
      case Need::kFrontalWidth:
        return addSlot();
      case Need::kLateralWidth:
        return addWall(random_.between(0.06, 0.3), kDeep_m + slack_m_);
      case Need::kCrawlHeight: {
        const double deep = random_.between(0.2, 0.6);
        const double wide = random_.between(kCrawlBroad_m + 0.02, 1.2);
        addWall(deep, wide);
        return addTable(deep, wide, kCrawlHigh_m + slack_m_);
      }
      case Need::kRunIn:
        addLowPassage();
        addWallAcross(-1.0, kLyingDown_m + slack_m_);
        start_ = alongside(-1.0, kLyingDown_m);
        return;
      case Need::kSwitchBox:
        addLowPassage();
        addShelfAcross(1.0, kGettingUp_m + slack_m_);
        goal_ = alongside(1.0, kGettingUp_m);
        return;
    }
  }

  void add(const char* what, Point min, Point max, Range z) {
    obstacles_.push_back({what + std::string("_") + std::to_string(obstacles_.size()),
                          {{0.5 * (min.x + max.x), 0.5 * (min.y + max.y), 0.5 * (z.min + z.max)},
                           {max.x - min.x, max.y - min.y, z.max - z.min},
                           {}}});
  }

  /// From side to side, in some pieces, with a gap at the passage.
  void addWall(double deep, double gap) {
    const Range x = Range{passage_.x, passage_.x}.grown(0.5 * deep);
    addPieces(x, {0.0, passage_.y - 0.5 * gap});
    addPieces(x, {passage_.y + 0.5 * gap, height_m_});
  }

  void addPieces(Range x, Range y) {
    const std::size_t count = 1 + random_.oneOf(3);
    const double each = y.length() / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double from = y.min + each * static_cast<double>(i);
      add("wall", {x.min, from}, {x.max, from + each}, {0.0, random_.between(0.7, kTall_m)});
    }
  }

  /// Over the passage.
  void addTable(double deep, double wide, double underside) {
    add("table", {passage_.x - 0.5 * deep, passage_.y - 0.5 * wide},
        {passage_.x + 0.5 * deep, passage_.y + 0.5 * wide},
        {underside, underside + random_.between(0.4, 0.6)});
  }

  /// A table in a wall too narrow to crawl through at a slant.
  void addLowPassage() {
    const double deep = random_.between(0.3, 0.6);
    const double wide = random_.between(kCrawlBroad_m, kCrawlBroad_m + 0.08);
    addWall(deep, wide);
    addTable(deep, wide, random_.between(0.24, 0.45));
    beside_ = 0.5 * deep;
  }

  /// From side to side, so far from the table.
  void addWallAcross(double side, double leaves) {
    const double near = passage_.x + side * (beside_ + leaves);
    const double far = near + side * random_.between(0.05, 0.3);
    addPieces({std::min(near, far), std::max(near, far)}, {0.0, height_m_});
  }

  /// A shelf that the crawling hands reach under and a standing body does not, and a wall behind it.
  void addShelfAcross(double side, double leaves) {
    const double deep = random_.between(0.15, 0.3);
    const double near = passage_.x + side * (beside_ + leaves);
    const double far = near + side * deep;
    const double underside = random_.between(0.24, 0.45);
    add("shelf", {std::min(near, far), 0.0}, {std::max(near, far), height_m_},
        {underside, underside + random_.between(0.2, 0.5)});
    addWallAcross(side, leaves + deep);
  }

  /// Beside the table, in the strip that is left there.
  Pose alongside(double side, double leaves) {
    const double off = random_.between(0.8, 1.1) * (random_.oneOf(2) == 0 ? 1.0 : -1.0);
    return {passage_.x + side * (beside_ + 0.5 * leaves), passage_.y + off, random_.angle()};
  }

  /// Three sides round the start, and a mouth that is narrower than the slot.
  void addSlot() {
    const double wide = random_.between(kBroad_m + 0.03, kTurning_m - 0.03);
    const double thick = random_.between(0.05, 0.1);
    const double jamb = random_.between(0.05, 0.15);
    start_ = {passage_.x - 0.7, passage_.y, random_.oneOf(2) == 0 ? 0.0 : std::numbers::pi};
    const double back = start_.x - random_.between(0.2, 0.4);
    const double front = start_.x + random_.between(0.3, 0.6);
    const auto [low, high] = Range{passage_.y, passage_.y}.grown(0.5 * wide);
    const auto [mouth_low, mouth_high] = Range{passage_.y, passage_.y}.grown(0.5 * (kBroad_m + slack_m_));
    const Range z{0.0, kTall_m};
    add("slot", {back, low - thick}, {front, low}, z);
    add("slot", {back, high}, {front, high + thick}, z);
    add("slot", {back - thick, low - thick}, {back, high + thick}, z);
    add("jamb", {front, low - thick}, {front + jamb, mouth_low}, z);
    add("jamb", {front, mouth_high}, {front + jamb, high + thick}, z);
  }

  /// Whether a circle is clear of the way through the passage, of start and of goal.
  [[nodiscard]] bool isOutOfTheWay(Point at, double radius) const {
    const auto is_near = [&](Point p, double room) { return distance(at, p) < room + radius; };
    const bool is_on_axis = std::abs(at.y - passage_.y) < 0.6 + radius && std::abs(at.x - passage_.x) < 1.7;
    return !is_on_axis && !is_near(start_.position(), 0.6) && !is_near(goal_.position(), 0.6) &&
           std::abs(at.x - passage_.x) > 0.9 + radius;
  }

  void addClutter() {
    for (std::size_t i = 0, count = 6 + random_.oneOf(40); i < count; ++i) {
      const Point at{random_.between(0.0, width_m_), random_.between(0.0, height_m_)};
      const Vec3 size{random_.between(0.05, 0.5), random_.between(0.05, 0.5), random_.between(0.05, 0.8)};
      const double yaw = random_.angle();
      const double bottom = random_.oneOf(3) == 0 ? random_.between(0.1, 0.7) : 0.0;
      if (!isOutOfTheWay(at, 0.5 * std::hypot(size.x, size.y))) continue;
      obstacles_.push_back(
          {"clutter_" + std::to_string(i), {{at.x, at.y, bottom + 0.5 * size.z}, size, {0.0, 0.0, yaw}}});
    }
  }

  RandomGeometry random_;
  double slack_m_;
  double width_m_;
  double height_m_;
  Point passage_;
  Pose start_;
  Pose goal_;
  double beside_ = 0.0;  // half the table's depth
  std::vector<Obstacle> obstacles_;
};

}  // namespace

std::string_view name(Need need) {
  static constexpr std::array<std::string_view, 5> kNames{"frontal width", "lateral width", "crawl height",
                                                          "run-in", "switch box"};
  return kNames.at(static_cast<std::size_t>(need));
}

Room roomWith(Need need, double slack_m, std::uint64_t seed) {
  return Builder(need, slack_m, seed * kNeeds.size() + static_cast<std::uint64_t>(need)).room();
}

Room clutteredRoom(std::uint64_t seed) {
  constexpr double kNear_m = 0.3;  // nothing stands nearer to start and goal than this, but for its corners
  RandomGeometry random(seed);
  const double side = random.between(2.5, 5.0);
  const auto pose = [&] {
    return Pose{random.between(0.4, side - 0.4), random.between(0.4, side - 0.4), random.angle()};
  };
  const auto mode = [&] { return static_cast<ModeId>(random.oneOf(4) == 0 ? 2 : 0); };
  const Pose start = pose();
  const Pose goal = pose();
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0, count = 8 + random.oneOf(40); i < count; ++i) {
    OrientedBox box{{random.between(0.0, side), random.between(0.0, side), random.between(0.0, 0.9)},
                    {random.between(0.05, 1.2), random.between(0.05, 0.4), random.between(0.05, 0.6)},
                    {0.0, 0.0, random.angle()}};
    if (random.oneOf(4) == 0)
      box.rpy_rad = {random.between(-1.0, 1.0), random.between(-1.0, 1.0), box.rpy_rad.z};
    const Point at{box.center_m.x, box.center_m.y};
    const double away = kNear_m + 0.4 * box.size_m.x;
    if (distance(at, start.position()) < away || distance(at, goal.position()) < away) continue;
    obstacles.push_back({"box_" + std::to_string(i), box});
  }
  Room room;
  room.world = std::make_shared<const World>(
      *World::make("clutter", {{0.0, 0.0, 0.0}, side, side}, 0.0, std::move(obstacles)));
  room.request.start = start;
  room.request.start_mode = mode();
  room.request.goal = goal.position();
  if (random.oneOf(3) != 0) room.request.goal_yaw = goal.yaw;
  room.request.goal_mode = mode();
  return room;
}

}  // namespace underway::bench
