#include "bench/local_courses.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "bench/requests.hpp"
#include "geometry/map.hpp"
#include "local/low.hpp"

namespace underway::bench {
namespace {

constexpr double kBerth_m = 0.15;  // that start and goal are left
constexpr int kTries = 50;         // to place one thing

Obstacle block(std::string id, Range x, Range y, Range z) {
  return {std::move(id), OrientedBox{{0.5 * (x.min + x.max), 0.5 * (y.min + y.max), 0.5 * (z.min + z.max)},
                                     {x.length(), y.length(), z.length()},
                                     {}}};
}

/// Puts things at random on a plan's way into a world that the map does not know of.
class Intruder {
 public:
  Intruder(const Course& course, const Plan& plan, std::shared_ptr<const Robot> robot, std::uint64_t seed)
      : course_(course), plan_(plan), robot_(std::move(robot)), random_(seed * 7919 + 17) {}

  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  int oneOf(int most) { return std::uniform_int_distribution(1, most)(random_); }

  /// A point of the way, or up to so far beside it.
  Point onTheWay(double beside_m) {
    const double along = between(0.0, plan_.length_m);
    double gone = 0.0;
    Point at = plan_.goal.position();
    for (const Segment& segment : plan_.segments) {
      const double way = length(segment.motion);
      if (way > 0.0 && gone + way >= along) {
        const double share = (along - gone) / way;
        at = {std::lerp(segment.motion.from.x, segment.motion.to.x, share),
              std::lerp(segment.motion.from.y, segment.motion.to.y, share)};
        break;
      }
      gone += way;
    }
    return {at.x + between(-beside_m, beside_m), at.y + between(-beside_m, beside_m)};
  }

  /// Adds all or none; none if start or goal came to stand too near.
  bool add(const std::vector<Obstacle>& parts) {
    World world = *course_.truth;
    for (const Obstacle& part : parts) world = *world.added(part);
    auto shared = std::make_shared<const World>(std::move(world));
    const Checker checker(shared, robot_);
    const Request& request = course_.request;
    const Pose goal{request.goal.x, request.goal.y, request.goal_yaw.value_or(0.0)};
    for (std::size_t i = 0; i < robot_->modes.size(); ++i) {
      const auto mode = static_cast<ModeId>(i);
      const bool is_end = mode == request.goal_mode || mode == 0;
      if (mode == request.start_mode && blocked(checker, stay(mode, request.start))) return false;
      if (is_end && blocked(checker, stay(mode, goal))) return false;
    }
    for (const Segment& segment : plan_.segments)
      if (isLying(segment.motion) && blocked(checker, segment.motion)) return false;
    course_.truth = std::move(shared);
    return true;
  }
  [[nodiscard]] Course course() const { return course_; }

 private:
  /// Whether something of ours has come too near.
  static bool blocked(const Checker& checker, const Motion& motion) {
    for (const std::string& id : checker.blockers(motion, kBerth_m, 100))
      if (id.starts_with(kUnmapped)) return true;
    return false;
  }
  [[nodiscard]] bool isLying(const Motion& motion) const { return isLow(*robot_, motion.mode); }

  Course course_;
  const Plan& plan_;
  std::shared_ptr<const Robot> robot_;
  std::mt19937_64 random_;
};

std::vector<Obstacle> tableAt(Point at, double yaw, Range size, double underside_m, const std::string& id) {
  const Pose frame{at.x, at.y, yaw};
  std::vector<Obstacle> parts{
      {id + "_top", {{at.x, at.y, underside_m + 0.02}, {size.min, size.max, 0.04}, {0.0, 0.0, yaw}}}};
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      const Point leg = transform(frame, {x * (size.min - 0.06), y * (size.max - 0.06)});
      parts.push_back({id + "_leg_" + std::to_string(parts.size()),
                       {{leg.x, leg.y, 0.5 * underside_m}, {0.05, 0.05, underside_m}, {0.0, 0.0, yaw}}});
    }
  return parts;
}

}  // namespace

Expected<std::vector<Course>> coursesOf(const std::filesystem::path& file, const Robot& robot) {
  auto map = readMap(file);
  if (!map) return tl::unexpected(map.error());
  const auto world = std::make_shared<const World>(std::move(map->world));
  std::vector<Course> courses;
  for (const Query& query : map->queries)
    if (query.expect == "ok")
      courses.push_back({world->name() + ", " + query.name, world, world, requestOf(query, robot)});
  if (courses.empty())
    return fail(ErrorCode::kInvalidRequest,
                file.string() + " has no query that expects 'ok': nothing to drive");
  return courses;
}

Course withUnmappedBoxes(const Course& course, const Plan& plan, const std::shared_ptr<const Robot>& robot,
                         std::uint64_t seed) {
  Intruder intruder(course, plan, robot, seed);
  const int count = intruder.oneOf(3);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < kTries; ++k) {
      const Point at = intruder.onTheWay(0.4);
      const Vec3 size{intruder.between(0.1, 0.4), intruder.between(0.1, 0.4), intruder.between(0.4, 1.0)};
      const double yaw = intruder.between(0.0, std::numbers::pi);
      if (intruder.add({{std::string(kUnmapped) + "_" + std::to_string(i),
                         {{at.x, at.y, 0.5 * size.z}, size, {0.0, 0.0, yaw}}}}))
        break;
    }
  return intruder.course();
}

Course withUnmappedTables(const Course& course, const Plan& plan, const std::shared_ptr<const Robot>& robot,
                          std::uint64_t seed) {
  Intruder intruder(course, plan, robot, seed);
  const int count = intruder.oneOf(2);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < kTries; ++k) {
      const Point at = intruder.onTheWay(0.4);
      const Range size{intruder.between(0.4, 0.9), intruder.between(0.4, 0.9)};
      if (intruder.add(tableAt(at, intruder.between(0.0, std::numbers::pi), size,
                               intruder.between(0.34, 0.54),
                               std::string(kUnmapped) + "_" + std::to_string(i))))
        break;
    }
  return intruder.course();
}

Expected<Course> narrowCourse(const Robot& robot, ModeId id) {
  constexpr double kSpare_m = 0.06;
  constexpr double kWall_m = 0.1;
  constexpr Range kX{2.45, 2.55};
  const Mode& mode = robot.modes.at(id);
  const bool is_low = isLow(robot, id);
  double drift_m = 0.0;
  if (const Switch* down = robot.findSwitch(0, id); is_low && down != nullptr)
    if (const Switch* up = robot.findSwitch(id, 0); up != nullptr) {
      const double crawled =
          down->body_m.x.max - down->displacement.x + kWall_m - up->body_m.x.min + 2.0 * robot.margin_m;
      drift_m = 2.0 * mode.drift_m_per_m * crawled;
    }
  const double wide_m =
      (mode.canMove(Sense::kForward) ? mode.body_m.y : mode.body_m.x).length() + kSpare_m + drift_m;
  const Range gap{1.2 - 0.5 * wide_m, 1.2 + 0.5 * wide_m};
  std::vector<Obstacle> walls{block("below", kX, {0.0, gap.min}, {0.0, 1.0}),
                              block("above", kX, {gap.max, 3.0}, {0.0, 1.0})};
  if (is_low) walls.push_back(block("lintel", kX, gap, {mode.body_m.z.max + 0.05, 1.0}));
  auto world = World::make("gap", {{0.0, 0.0, 0.0}, 5.0, 3.0}, 0.0, std::move(walls));
  if (!world) return tl::unexpected(world.error());
  const auto shared = std::make_shared<const World>(std::move(*world));
  return Course{mode.name, shared, shared, {{0.8, 2.2, 0.0}, 0, {4.2, 2.2}, 0.0, 0, Policy::kPriority}};
}

}  // namespace underway::bench
