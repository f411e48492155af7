#include "planner/certify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

/// A sound plan under the table of scenario 3, to be spoilt.
class Certificate : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    planner_ = new Planner(test::ourWorld("scenario3"), test::nao());
    plan_ = new Plan(*planner_->plan(request(), test::soon()));
  }
  static void TearDownTestSuite() {
    delete plan_;
    delete planner_;
  }
  static Request request() { return test::requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}); }

  /// The certificate's sentences on the plan after a change.
  static std::string sentencesAfter(const std::function<void(Plan&)>& spoil) {
    Plan plan = *plan_;
    spoil(plan);
    std::string sentences;
    for (const Flaw& flaw : certify(plan, request(), *planner_->checker())) sentences += flaw.sentence + "\n";
    return sentences;
  }

  static std::size_t firstOf(MotionKind kind, ModeId mode) {
    for (std::size_t i = 0; i < plan_->segments.size(); ++i)
      if (plan_->segments[i].motion.kind == kind && plan_->segments[i].motion.mode == mode) return i;
    return 0;
  }

  static Planner* planner_;
  static Plan* plan_;
};
Planner* Certificate::planner_ = nullptr;
Plan* Certificate::plan_ = nullptr;

void expectSays(const std::string& sentences, const char* part) {
  EXPECT_NE(sentences.find(part), std::string::npos) << "says: " << sentences;
}

TEST_F(Certificate, FindsNoFlawInASoundPlan) {
  EXPECT_EQ(sentencesAfter([](Plan&) {}), "");
}

TEST_F(Certificate, FindsWhatDoesNotChain) {
  expectSays(sentencesAfter([](Plan& p) { p.segments.erase(p.segments.begin() + 1); }), "bit for bit");
  expectSays(sentencesAfter([](Plan& p) { p.segments[0].motion.from.x = std::nextafter(0.6, 1.0); }),
             "bit for bit");
  expectSays(sentencesAfter([](Plan& p) { p.segments.pop_back(); }), "goal");
  expectSays(sentencesAfter([](Plan& p) { p.segments.clear(); }), "from the goal");
}

TEST_F(Certificate, FindsMotionsTheRobotDoesNotHave) {
  const std::size_t crawl = firstOf(MotionKind::kTranslate, 2);
  const std::size_t turn = firstOf(MotionKind::kTurn, 0);
  expectSays(sentencesAfter([&](Plan& p) { p.segments[crawl].motion.sense = Sense::kBackward; }),
             "does not move backward");
  expectSays(sentencesAfter([&](Plan& p) { p.segments[crawl].motion.to.y += 1e-6; }), "leaves the axis");
  expectSays(sentencesAfter([&](Plan& p) { p.segments[turn].motion.mode = 2; }), "cannot turn");
  expectSays(sentencesAfter([&](Plan& p) { p.segments[turn].motion.angle_rad += 0.01; }),
             "angle does not lead");
  const std::size_t down = firstOf(MotionKind::kSwitch, 0);
  expectSays(sentencesAfter([&](Plan& p) { p.segments[down].motion.to.x += 0.01; }), "displacement");
  expectSays(sentencesAfter([&](Plan& p) { p.segments[crawl].motion.mode = 9; }),
             "mode the robot does not have");
}

TEST_F(Certificate, FindsWrongNumbers) {
  expectSays(sentencesAfter([](Plan& p) { p.segments[1].duration_s *= 0.9; }), "at the mode's speed");
  expectSays(sentencesAfter([](Plan& p) { p.total_time_s += 1.0; }), "in total");
  expectSays(sentencesAfter([](Plan& p) { p.length_m += 1.0; }), "in total");
  const std::size_t crawl = firstOf(MotionKind::kTranslate, 2);
  expectSays(sentencesAfter([&](Plan& p) { p.segments[crawl].closeness.clearance_m += 0.002; }), "has less");
  expectSays(sentencesAfter([&](Plan& p) { p.segments[crawl].closeness.clearance_m -= 0.002; }), "and has");
  expectSays(sentencesAfter([&](Plan& p) { p.segments[crawl].closeness.clearance_m = 0.0; }), "no clearance");
}

TEST_F(Certificate, FindsACollisionWhateverThePlanClaims) {
  // Straight through the wall and the table, walking.
  const Robot& robot = *test::nao();
  const Motion walk = translate(0, Sense::kForward, {0.6, 2.0, 0.0}, Point{5.4, 2.0});
  Plan plan = timedPlan({{walk, duration(robot, walk), {0.05, std::nullopt, std::nullopt}}}, request().start);
  std::string sentences;
  for (const Flaw& flaw : certify(plan, request(), *planner_->checker())) sentences += flaw.sentence + "\n";
  expectSays(sentences, "has less");
  expectSays(sentences, "are asked for");
}

TEST_F(Certificate, FindsASegmentCloserThanTheMargin) {
  // Past the wall's end with 10 mm; the margin is 20 mm. The wall ends at y = 2.40, half the body is .195 m.
  const Robot& robot = *test::nao();
  const Pose from{1.0, 2.605, 0.0};
  Request across = test::requestFor(from, {3.0, 2.605, 0.0});
  const Motion walk = translate(0, Sense::kForward, from, Point{3.0, 2.605});
  const Plan plan = timedPlan({{walk, duration(robot, walk), {0.01, std::nullopt, std::nullopt}}}, from);
  std::string sentences;
  for (const Flaw& flaw : certify(plan, across, *planner_->checker())) sentences += flaw.sentence + "\n";
  expectSays(sentences, "0.0200 m are asked for");
}

}  // namespace
}  // namespace underway
