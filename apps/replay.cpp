#include "apps/replay.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "geometry/convex.hpp"

namespace underway {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t milli(double number) { return std::llround(1000.0 * number); }

Json pointOf(Point p) { return {milli(p.x), milli(p.y)}; }

/// The differences of a column's numbers from one tick to the next.
template <class Tick>
Json column(const std::vector<Tick>& ticks, const std::function<std::int64_t(const Tick&)>& value) {
  Json differences = Json::array();
  std::int64_t last = 0;
  for (const Tick& tick : ticks) {
    const std::int64_t now = value(tick);
    differences.push_back(now - last);
    last = now;
  }
  return differences;
}

// --- what stands still -------------------------------------------------------------------------------------

/// What a thing is for a robot: "low" to its lidar at the waist, "over" what goes lying, or else "tall".
std::string kindOf(double bottom_m, double top_m, const Robot& robot) {
  double lowest_m = robot.modes.front().body_m.z.max;
  for (const Mode& mode : robot.modes) lowest_m = std::min(lowest_m, mode.body_m.z.max);
  if (lowest_m < robot.modes.front().body_m.z.max && bottom_m >= lowest_m) return "over";
  if (robot.senses.waist && top_m < robot.senses.waist->height_m) return "low";
  return "tall";
}

Json obstacleOf(const Obstacle& obstacle, bool is_unmapped, const World& world, const Robot& robot) {
  std::vector<Point> points;
  double bottom_m = INFINITY;
  double top_m = -INFINITY;
  for (const Vec3& corner : corners(obstacle.box)) {
    points.push_back({corner.x, corner.y});
    bottom_m = std::min(bottom_m, corner.z - world.floorZ());
    top_m = std::max(top_m, corner.z - world.floorZ());
  }
  Json outline = Json::array();
  for (const Point p : convexHull(points)) outline.push_back(pointOf(p));
  return {{"id", obstacle.id},
          {"kind", kindOf(bottom_m, top_m, robot)},
          {"unmapped", is_unmapped},
          {"z", {milli(bottom_m), milli(top_m)}},
          {"outline", outline}};
}

Json obstaclesOf(const Replay& replay) {
  Json all = Json::array();
  const Obstacles& mapped = replay.map.obstacles();
  for (const Obstacle& obstacle : replay.truth.obstacles()) {
    const auto there = mapped.find(obstacle.id);
    const bool is_unmapped = !there || !(mapped[*there].box == obstacle.box);
    all.push_back(obstacleOf(obstacle, is_unmapped, replay.truth, replay.robot));
  }
  return all;
}

Json modesOf(const Robot& robot) {
  Json modes = Json::array();
  for (const Mode& mode : robot.modes) {
    const BodyBox& body = mode.body_m;
    modes.push_back({{"name", mode.name},
                     {"body", {milli(body.x.min), milli(body.x.max), milli(body.y.min), milli(body.y.max)}},
                     {"low", body.z.max < robot.modes.front().body_m.z.max}});
  }
  return modes;
}

Json goalOf(const Goal& goal) {
  return {milli(goal.at.x), milli(goal.at.y), goal.yaw ? Json(milli(*goal.yaw)) : Json()};
}

Json goalsIn(const Request& request) {
  Json all = Json::array();
  for (const Goal& goal : goalsOf(request)) all.push_back(goalOf(goal));
  return all;
}

// --- what moves --------------------------------------------------------------------------------------------

Json poseOf(const Pose& pose) { return {milli(pose.x), milli(pose.y), milli(pose.yaw)}; }

Json planOf(const OwnTrack::NewPlan& made) {
  Json segments = Json::array();
  for (const Segment& segment : made.plan.segments) {
    const Motion& motion = segment.motion;
    segments.push_back({{"kind", static_cast<int>(motion.kind)},
                        {"mode", motion.mode},
                        {"to_mode", motion.to_mode},
                        {"from", poseOf(motion.from)},
                        {"to", poseOf(motion.to)}});
  }
  return {{"tick", made.tick},
          {"length", milli(made.plan.length_m)},
          {"time", milli(made.plan.total_time_s)},
          {"segments", segments}};
}

Json surprisesOf(const OwnTrack::Seen& seen) {
  Json cells = Json::array();
  for (const Point cell : seen.cells) cells.push_back(pointOf(cell));
  return {{"tick", seen.tick}, {"cells", cells}};
}

/// As many looks as a page of a few megabytes has room for.
Json looksOf(const std::vector<OwnTrack::Look>& looks) {
  constexpr std::size_t kMost_bytes = 2'000'000;
  std::size_t bytes = 0;
  for (const OwnTrack::Look& look : looks) bytes += look.ranges.size();
  const std::size_t every = bytes / kMost_bytes + 1;
  Json some = Json::array();
  for (std::size_t i = 0; i < looks.size(); i += every) some.push_back({looks[i].tick, looks[i].ranges});
  return some;
}

Json truthOf(const TrueTrack& track) {
  using Tick = TrueTrack::Tick;
  const auto& ticks = track.ticks();
  return {{"tick", column<Tick>(ticks, [](const Tick& t) { return static_cast<std::int64_t>(t.tick); })},
          {"x", column<Tick>(ticks, [](const Tick& t) { return milli(t.pose.x); })},
          {"y", column<Tick>(ticks, [](const Tick& t) { return milli(t.pose.y); })},
          {"yaw", column<Tick>(ticks, [](const Tick& t) { return milli(t.pose.yaw); })},
          {"mode", column<Tick>(ticks, [](const Tick& t) { return std::int64_t{t.mode}; })},
          {"clearance", column<Tick>(ticks, [](const Tick& t) { return milli(t.clearance_m); })},
          {"speed", column<Tick>(ticks, [](const Tick& t) { return milli(t.speed_mps); })}};
}

Json beliefOf(const OwnTrack& track) {
  using Tick = OwnTrack::Tick;
  const auto& ticks = track.ticks();
  return {
      {"tick", column<Tick>(ticks, [](const Tick& t) { return static_cast<std::int64_t>(t.tick); })},
      {"x", column<Tick>(ticks, [](const Tick& t) { return milli(t.believed.x); })},
      {"y", column<Tick>(ticks, [](const Tick& t) { return milli(t.believed.y); })},
      {"yaw", column<Tick>(ticks, [](const Tick& t) { return milli(t.believed.yaw); })},
      {"state", column<Tick>(ticks, [](const Tick& t) { return static_cast<std::int64_t>(t.state); })},
      {"segment", column<Tick>(ticks, [](const Tick& t) { return static_cast<std::int64_t>(t.segment); })},
      {"plans", column<Tick>(ticks, [](const Tick& t) { return static_cast<std::int64_t>(t.plans); })}};
}

template <class Items, class Item>
Json listOf(const Items& items, Json (*of)(const Item&)) {
  Json all = Json::array();
  for (const Item& item : items) all.push_back(of(item));
  return all;
}

}  // namespace

std::string replayData(const Replay& replay) {
  Json states = Json::array();
  for (int i = 0; i <= static_cast<int>(State::kStalled); ++i) states.push_back(name(static_cast<State>(i)));
  Json bounds = Json::array();
  for (const Point corner : replay.truth.bounds().corners()) bounds.push_back(pointOf(corner));
  const Beams beams;
  const Json data{
      {"title", replay.title},
      {"outcome", replay.outcome},
      {"robot", replay.robot.name},
      {"tick_s", sim::SimulatedRobot::kTick_s},
      {"states", states},
      {"modes", modesOf(replay.robot)},
      {"bounds", bounds},
      {"obstacles", obstaclesOf(replay)},
      {"start", poseOf(replay.request.start)},
      {"goals", goalsIn(replay.request)},
      {"plans", listOf(replay.own_track.plans(), planOf)},
      {"surprises", listOf(replay.own_track.surprises(), surprisesOf)},
      {"beams", {{"first_rad", beams.first_rad}, {"step_rad", beams.step_rad}, {"each", kReplayBeams}}},
      {"looks", looksOf(replay.own_track.looks())},
      {"truth", truthOf(replay.true_track)},
      {"belief", beliefOf(replay.own_track)}};
  return data.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// --- recording ---------------------------------------------------------------------------------------------

void TrueTrack::add(std::uint64_t tick, const sim::SimulatedRobot& body) {
  const sim::Truth& truth = body.truth();
  Tick now{tick, truth.pose, truth.mode, checker_->clearance(stay(truth.mode, truth.pose), 1.0), 0.0};
  if (!ticks_.empty() && ticks_.back().mode == truth.mode)  // a change of mode jumps
    now.speed_mps =
        distance(ticks_.back().pose.position(), truth.pose.position()) / sim::SimulatedRobot::kTick_s;
  ticks_.push_back(now);
}

double TrueTrack::leastClearance() const {
  double least_m = 1.0;
  for (const Tick& tick : ticks_) least_m = std::min(least_m, tick.clearance_m);
  return least_m;
}

void OwnTrack::add(const Mission& mission, State state, const HeardSenses& heard) {
  const Executor& executor = mission.executor();
  const auto plans = static_cast<std::size_t>(mission.plans());
  if (plans > plans_.size()) plans_.push_back({heard.tick, executor.plan()});
  ticks_.push_back({heard.tick, executor.pose(), state, executor.segment(), plans});
  if (heard.scan) looks_.push_back({heard.tick, packedRanges(*heard.scan)});
  constexpr std::uint64_t kEvery = 5;  // ticks
  if (heard.tick % kEvery != 0) return;
  std::vector<Point> cells = executor.surprises();
  if (surprises_.empty() ? cells.empty() : cells.size() == surprises_.back().cells.size()) return;
  surprises_.push_back({heard.tick, std::move(cells)});
}

std::string packedRanges(const Scan& scan) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr long kNothing = 4095;
  std::string text;
  for (std::size_t i = 0; i < scan.ranges_m.size(); i += kReplayBeams) {
    const auto begin = scan.ranges_m.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end =
        scan.ranges_m.begin() + static_cast<std::ptrdiff_t>(std::min(i + kReplayBeams, scan.ranges_m.size()));
    const double nearest_m = *std::min_element(begin, end);
    const long cm = nearest_m < 40.0 ? std::lround(100.0 * nearest_m) : kNothing;
    text += kDigits[static_cast<std::size_t>(cm / 64)];
    text += kDigits[static_cast<std::size_t>(cm % 64)];
  }
  return text;
}

}  // namespace underway
