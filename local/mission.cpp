#include "local/mission.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace underway {
namespace {

constexpr int kMostRefusals = 3;  // of plans, with a fresh look between them
constexpr double kLookAgain_s = 2.0;
constexpr double kAskAgain_s = 1.0;   // a server that is gone
constexpr double kMostLost_s = 30.0;  // standing still without localisation

/// How large what was seen in a cell is taken, for the noise and for corners that were not seen: all cells
/// together leave no gaps for a body. Where that leaves no plan less is tried, which the guard watches over
/// all the same.
constexpr std::array kSize_m{0.06, 0.04, 0.02};

/// What was seen in a cell, as an obstacle as high as the robot.
Obstacle obstacleAt(Point cell, double size_m, const World& world, const Robot& robot) {
  const double height = robot.modes.front().body_m.z.max;
  const auto at = [](double x) { return std::to_string(std::lround(std::floor(x / Window::kCell_m))); };
  return {"seen_" + at(cell.x) + "_" + at(cell.y),
          {{cell.x, cell.y, world.floorZ() + 0.5 * height}, {size_m, size_m, height}, {}}};
}

/// Whether the robot stands in a cell, by its own belief: then it cannot be there.
bool standsIn(const BodyBox& body, const Pose& at, Point cell) {
  const Pose back = before({0.0, 0.0, 0.0}, at);
  const Point p = transform({back.x, back.y, -at.yaw}, cell);
  constexpr double kHalf_m = 0.045;  // of the largest, along its diagonal
  return p.x > body.x.min - kHalf_m && p.x < body.x.max + kHalf_m && p.y > body.y.min - kHalf_m &&
         p.y < body.y.max + kHalf_m;
}

}  // namespace

Mission::Mission(std::shared_ptr<const World> map, std::shared_ptr<const Robot> robot, Request request,
                 PlanSource source, const ExecutorSettings& settings)
    : map_(std::move(map)),
      world_(map_),
      robot_(robot),
      request_(std::move(request)),
      source_(std::move(source)),
      executor_(std::move(robot), settings) {}

Tick Mission::tick(const Senses& senses) {
  Tick tick = executor_.tick(senses);
  switch (tick.state) {
    case State::kArrived:
      outcome_ = Outcome::kArrived;
      break;
    case State::kFallen:
      outcome_ = Outcome::kNeedsHelp, why_ = "the robot has fallen; get it up, then ask for a new plan";
      if (!senses.has_fallen) ask(senses);
      break;
    case State::kStalled:
      outcome_ = Outcome::kNeedsHelp, why_ = "the crawl does not progress, or there is no room to get up";
      break;
    case State::kLost:
      if (lost_s_ == 0.0) lost_s_ = senses.now_s;
      why_ = "localisation is silent; standing still until it is back";
      if (senses.now_s - lost_s_ > kMostLost_s) outcome_ = Outcome::kNeedsHelp;
      break;
    case State::kIdle:
    case State::kBlocked:
      ask(senses);
      break;
    default:
      lost_s_ = 0.0;
      break;
  }
  return tick;
}

void Mission::ask(const Senses& senses) {
  const bool is_first = plans_ == 0;
  if (senses.now_s < again_s_) return;
  if (!is_first) world_ = worldWithSurprises(refusals_ == 0 ? world_ : map_);
  auto plan = planFromHere();
  if (!plan) return refused(plan.error(), senses.now_s);
  ++plans_;
  refusals_ = 0;
  countInPlace();
  if (outcome_ == Outcome::kNoWay) return;
  executor_.follow(std::move(*plan), world_, *map_);
}

/// Plans that do not get it away are no way either.
void Mission::countInPlace() {
  constexpr int kMost = 8;
  constexpr double kAway_m = 0.1;
  const Point here = executor_.pose().position();
  in_place_ = distance(here, asked_at_) < kAway_m ? in_place_ + 1 : 0;
  if (in_place_ == 0) asked_at_ = here;
  outcome_ = in_place_ >= kMost ? Outcome::kNoWay : Outcome::kUnderway;
  why_ = in_place_ >= kMost ? "none of the last plans could be followed away from here" : "";
}

Expected<Plan> Mission::planFromHere() {
  Request request = request_;
  if (plans_ > 0) {
    request.start = executor_.pose();
    request.start_mode = executor_.mode();
  }
  return source_(request, world_);
}

void Mission::refused(const Error& error, double now_s) {
  why_ = error.message;
  if (error.code == ErrorCode::kBusy) return;  // asked again with the next tick, standing still
  if (error.code == ErrorCode::kNoServer) {
    again_s_ = now_s + kAskAgain_s;  // it stands still meanwhile
    return;
  }
  again_s_ = now_s + kLookAgain_s;
  if (++refusals_ >= kMostRefusals || plans_ == 0) outcome_ = Outcome::kNoWay;
}

std::shared_ptr<const World> Mission::worldWithSurprises(const std::shared_ptr<const World>& base) const {
  World world = *base;
  const BodyBox& body = robot_->modes[executor_.mode()].body_m;
  const double size_m = kSize_m.at(std::min(static_cast<std::size_t>(refusals_), kSize_m.size() - 1));
  for (const Point cell : executor_.surprises()) {
    if (standsIn(body, executor_.pose(), cell)) continue;
    if (auto with = world.added(obstacleAt(cell, size_m, world, *robot_))) world = std::move(*with);
  }
  return std::make_shared<const World>(std::move(world));
}

}  // namespace underway
