#include "gait/crawl/gait.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "gait/crawl/recipes.hpp"
#include "gait/nao.hpp"
#include "gait/rest.hpp"

namespace underway::gait {
namespace {

const JointLimits& limitsOf(const std::string& joint) { return nao().links[*nao().findJoint(joint)].limits; }

JointTable motionOf(const CrawlGait& gait, int cycles = 1) {
  const auto motion = crawlMotion(naoCrawler(), gait, cycles);
  EXPECT_TRUE(motion) << gait.name << ": " << motion.error().message;
  return motion.value_or(JointTable({"none"}));
}

/// Gaits whose push needs no search.
std::vector<CrawlGait> knownGaits() {
  std::vector<CrawlGait> gaits;
  for (const Recipe& recipe : naoRecipes())
    if (!recipe.is_optimised) gaits.push_back(recipe.from);
  CrawlGait slide = nominalGait();
  slide.name = "sliding";
  slide.lying.lowering = Lowering::kSlide;
  slide.lying.knee_rad = radians(30.0);
  gaits.push_back(slide);
  return gaits;
}

TEST(Crawl, MovesAllOfNaosJointsWithinTheirLimits) {
  for (const CrawlGait& gait : knownGaits()) {
    const JointTable motion = motionOf(gait, 2);
    ASSERT_EQ(motion.joints().size(), nao().joints().size());
    for (std::size_t row = 0; row < motion.rows(); ++row)
      for (std::size_t j = 0; j < motion.joints().size(); ++j) {
        const JointLimits& limits = limitsOf(motion.joints()[j]);
        ASSERT_GE(motion.angles(row)[j], limits.lower_rad) << gait.name << " " << motion.joints()[j];
        ASSERT_LE(motion.angles(row)[j], limits.upper_rad) << gait.name << " " << motion.joints()[j];
        if (row == 0) continue;
        const double speed = std::abs(motion.angles(row)[j] - motion.angles(row - 1)[j]) /
                             (motion.time(row) - motion.time(row - 1));
        ASSERT_LE(speed, limits.speed_radps * 1.00001) << gait.name << " " << motion.joints()[j];
      }
  }
}

TEST(Crawl, IsMirroredLeftToRight) {
  const JointTable motion = motionOf(nominalGait());
  for (const auto& [joint, sign] : {std::pair{"KneePitch", 1.0},
                                    {"ShoulderPitch", 1.0},
                                    {"ShoulderRoll", -1.0},
                                    {"ElbowYaw", -1.0},
                                    {"ElbowRoll", -1.0}})
    for (std::size_t row = 0; row < motion.rows(); ++row)
      ASSERT_EQ(motion.angles(row)[*motion.find(std::string("L").append(joint))],
                sign * motion.angles(row)[*motion.find(std::string("R").append(joint))]);
}

TEST(Crawl, EndsTheNominalPushWithTheElbowsAtTheirLimit) {
  const JointTable motion = motionOf(nominalGait());
  const CrawlTimes times = nominalGait().times;
  const auto end = motion.sample(times.extension_s + times.push_s);
  EXPECT_NEAR(degrees(end[*motion.find("LElbowRoll")]), -88.5, 0.01);
  const auto start = motion.sample(times.extension_s);
  EXPECT_NEAR(degrees(start[*motion.find("LHipPitch")]), 27.5, 1e-6);
  EXPECT_NEAR(degrees(start[*motion.find("LAnklePitch")]), -65.9, 0.1);
}

TEST(Crawl, RepeatsItselfAnyNumberOfTimes) {
  const JointTable one = motionOf(nominalGait(), 1);
  const JointTable four = motionOf(nominalGait(), 4);
  EXPECT_DOUBLE_EQ(four.duration(), 4.0 * nominalGait().times.cycle());
  EXPECT_EQ(four.rows() - 1, 4 * (one.rows() - 1));
  const std::vector<double> first(one.angles(0).begin(), one.angles(0).end());
  const std::vector<double> last(four.angles(four.rows() - 1).begin(), four.angles(four.rows() - 1).end());
  for (std::size_t j = 0; j < first.size(); ++j) EXPECT_NEAR(first[j], last[j], 1e-12);
  EXPECT_THROW(static_cast<void>(crawlMotion(naoCrawler(), nominalGait(), 0)), std::invalid_argument);
}

/// It may be paused anywhere: at every row the robot lies on what it lies on, its mass above its support, and
/// it never tips from one row to the next.
TEST(Crawl, IsStaticallyStableThroughout) {
  for (const CrawlGait& gait : knownGaits()) {
    const std::vector<Rest> rests = settleAll(nao(), motionOf(gait, 2), radians(87.0));
    for (std::size_t i = 0; i < rests.size(); ++i) {
      EXPECT_GT(rests[i].margin_m, 0.004) << gait.name << ", row " << i;
      if (i > 0) {
        EXPECT_LT(std::abs(rests[i].pitch_rad - rests[i - 1].pitch_rad), radians(4.0))
            << gait.name << " tips at row " << i;
      }
    }
  }
}

TEST(Crawl, GoesAheadAndStaysLow) {
  for (const CrawlGait& gait : knownGaits()) {
    const JointTable motion = motionOf(gait, 2);
    const std::vector<Rest> rests = settleAll(nao(), motion, radians(87.0));
    const double ahead_m = rests.back().root.x() - rests[rests.size() / 2].root.x();
    EXPECT_GT(ahead_m, 0.02) << gait.name;
    for (const Rest& rest : rests) EXPECT_LE(rest.high.z(), 0.214) << gait.name;
  }
}

TEST(Crawl, TurnsByGoingFartherOnOneSide) {
  CrawlGait gait = nominalGait();
  gait.push.hip = line(radians(15.0), radians(15.0));  // room for the hips to differ
  gait.turn_rad = radians(4.0);
  const JointTable left = motionOf(gait);
  gait.turn_rad = radians(-4.0);
  const JointTable right = motionOf(gait);
  const auto at = [](const JointTable& table, const char* joint) {
    return table.sample(1.8)[*table.find(joint)];  // the end of the push
  };
  EXPECT_GT(std::abs(at(left, "LAnklePitch") - at(left, "RAnklePitch")), radians(1.0));
  EXPECT_NEAR(at(left, "LAnklePitch"), at(right, "RAnklePitch"), 1e-12)
      << "the other way is the mirror image";
  EXPECT_NEAR(at(left, "LShoulderRoll"), -at(right, "RShoulderRoll"), 1e-12);
}

TEST(Crawl, SaysWhichJointCannot) {
  CrawlGait gait = nominalGait();
  gait.toe_to_elbow_m = 0.40;
  const auto ankle = crawlMotion(naoCrawler(), gait);
  ASSERT_FALSE(ankle);
  EXPECT_NE(ankle.error().message.find("AnklePitch would be at"), std::string::npos) << ankle.error().message;
  gait.toe_to_elbow_m = 0.70;
  const auto far = crawlMotion(naoCrawler(), gait);
  ASSERT_FALSE(far);
  EXPECT_NE(far.error().message.find("cannot be taken"), std::string::npos) << far.error().message;
  gait = nominalGait();
  gait.times.push_s = 0.05;
  const auto hasty = crawlMotion(naoCrawler(), gait);
  ASSERT_FALSE(hasty);
  EXPECT_NE(hasty.error().message.find("more time"), std::string::npos) << hasty.error().message;
}

/// Any robot by its lengths: another one, on its own terms.
TEST(Crawl, SuitsAnotherHumanoid) {
  const Crawler& poppy = poppyCrawler();
  CrawlGait gait;
  gait.name = "poppy";
  gait.push = {line(radians(15.0), radians(15.0)), line(radians(-5.0), radians(-5.0)),
               line(radians(-35.0), radians(-80.0))};
  gait.spread_m = 0.05;
  gait.toe_to_elbow_m = 0.75;
  gait.lying.shoulder_height_m = 0.06;
  gait.lying.hip_rad = radians(-5.0);
  gait.lying.arm_rise_rad = radians(-10.0);
  gait.times = {1.5, 2.0, 3.0};
  const auto motion = crawlMotion(poppy, gait, 2);
  ASSERT_TRUE(motion) << motion.error().message;
  EXPECT_TRUE(motion->find("l_ankle_y") && motion->find("r_arm_z"));
}

}  // namespace
}  // namespace underway::gait
