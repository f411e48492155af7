#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/planner.hpp"
#include "tests/geometry/random_world.hpp"
#include "tests/planner/fixture.hpp"

// World and query together may be moved, turned or mirrored: whether there is a plan stays the same.
namespace underway {
namespace {

struct Question {
  std::vector<Obstacle> obstacles;
  Bounds bounds;
  Request request;
};

Question moved(Question question, const Pose& by) {
  for (Obstacle& obstacle : question.obstacles) {
    Vec3& center = obstacle.box.center_m;
    const Point at = transform(by, {center.x, center.y});
    center = {at.x, at.y, center.z};
    obstacle.box.rpy_rad.z += by.yaw;
  }
  const auto in_map = [&](const Pose& pose) { return compose(by, pose); };
  question.bounds.corner = in_map(question.bounds.corner);
  question.request.start = in_map(question.request.start);
  question.request.goal = transform(by, question.request.goal);
  question.request.goal_yaw = normalizedAngle(*question.request.goal_yaw + by.yaw);
  return question;
}

/// At the x axis. A box is its own mirror image, so its roll and yaw change their sign.
Question mirrored(Question question) {
  for (Obstacle& obstacle : question.obstacles) {
    OrientedBox& box = obstacle.box;
    box.center_m.y = -box.center_m.y;
    box.rpy_rad = {-box.rpy_rad.x, box.rpy_rad.y, -box.rpy_rad.z};
  }
  const Bounds& b = question.bounds;
  const Point corner = transform(b.corner, {0.0, b.height_m});
  question.bounds.corner = {corner.x, -corner.y, -b.corner.yaw};
  Request& request = question.request;
  request.start = {request.start.x, -request.start.y, normalizedAngle(-request.start.yaw)};
  request.goal.y = -request.goal.y;
  request.goal_yaw = normalizedAngle(-*request.goal_yaw);
  return question;
}

/// How a question is answered; the deadline is for what is neither solved nor proven.
std::optional<ErrorCode> answerTo(const Question& question) {
  const auto world =
      std::make_shared<const World>(*World::make("room", question.bounds, 0.0, question.obstacles));
  Planner dut(world, test::smallRobot());
  const auto plan = dut.plan(question.request, Planner::Clock::now() + std::chrono::milliseconds(1500));
  return plan ? std::nullopt : std::optional(plan.error().code);
}

std::string said(const std::optional<ErrorCode>& code) { return code ? std::string(name(*code)) : "ok"; }

TEST(Answers, StayTheSameWhenWorldAndQueryAreMovedTurnedOrMirrored) {
  constexpr unsigned kSeed = 1;
  test::RandomWorld random(kSeed);
  int solved = 0, undecided = 0;
  for (int round = 0; round < 25; ++round) {
    Question question;
    for (int i = 0; i < 7; ++i) question.obstacles.push_back({"box_" + std::to_string(i), random.box(true)});
    question.bounds = {{-1.0, -1.0, random.oneOf(2) == 0 ? 0.0 : 0.1}, 6.0, 6.0};
    question.request = test::requestFor(random.pose(), random.pose());
    question.request.goal_mode = static_cast<ModeId>(random.oneOf(3));
    const auto as_it_is = answerTo(question);
    const Pose by{random.between(-100, 100), random.between(-100, 100), random.angle()};
    for (const Question& other :
         {moved(question, {3.0, -2.0, 0.0}), moved(question, by), mirrored(question)}) {
      const auto code = answerTo(other);
      if (code == ErrorCode::kTimeout || as_it_is == ErrorCode::kTimeout) {
        ++undecided;
        continue;
      }
      EXPECT_EQ(said(code), said(as_it_is)) << "seed " << kSeed << " round " << round;
    }
    solved += as_it_is ? 0 : 1;
  }
  EXPECT_GT(solved, 8);
  EXPECT_LT(undecided, 10) << "most questions are decided in time";
}

TEST(Answers, AreTheSamePlanInWhateverOrderTheObstaclesAreGiven) {
  constexpr unsigned kSeed = 3;
  test::RandomWorld random(kSeed);
  int solved = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<Obstacle> obstacles;
    for (int i = 0; i < 12; ++i) obstacles.push_back({"box_" + std::to_string(i), random.box(true)});
    const Request request = test::requestFor(random.pose(), random.pose());
    const auto planIn = [&](const std::vector<Obstacle>& given) {
      const auto world = World::make("room", {{-1.0, -1.0, 0.0}, 6.0, 6.0}, 0.0, given);
      Planner dut(std::make_shared<const World>(*world), test::smallRobot());
      return dut.plan(request, Planner::Clock::now() + std::chrono::milliseconds(500));
    };
    const auto plan = planIn(obstacles);
    if (!plan) continue;
    ++solved;
    std::reverse(obstacles.begin(), obstacles.end());
    std::swap(obstacles[2], obstacles[7]);
    const auto other = planIn(obstacles);
    ASSERT_TRUE(other) << "round " << round << ": " << other.error().message;
    ASSERT_EQ(other->segments.size(), plan->segments.size()) << "seed " << kSeed << " round " << round;
    for (std::size_t i = 0; i < plan->segments.size(); ++i)
      EXPECT_EQ(other->segments[i].motion, plan->segments[i].motion) << "round " << round;
  }
  EXPECT_GT(solved, 5);
}

}  // namespace
}  // namespace underway
