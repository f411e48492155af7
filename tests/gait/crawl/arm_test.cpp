#include "gait/crawl/arm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gait/crawl/crawler.hpp"
#include "gait/nao.hpp"
#include "tests/gait/random_numbers.hpp"

namespace underway::gait {
namespace {

using Eigen::Vector3d;

const ArmLengths kNao;

TEST(Arm, PutsTheElbowAsFarOutAsAsked) {
  for (const double spread_m : {-0.01, 0.0, 0.03, 0.0565, 0.1}) {
    const auto roll = shoulderRollFor(kNao, spread_m);
    ASSERT_TRUE(roll);
    for (const double pitch : {-1.0, 0.3, 1.5}) {
      const ArmPlacement placed = placementOf(kNao, {pitch, *roll, 0.0, 0.0});
      EXPECT_NEAR(placed.elbow.y(), spread_m, 1e-15);
      EXPECT_NEAR(std::hypot(placed.elbow.x(), placed.elbow.z()), kNao.projected(spread_m), 1e-15);
    }
  }
}

TEST(Arm, SpreadAndProjectedLengthAreOneTriangle) {
  EXPECT_NEAR(kNao.humerus(), 0.10607, 5e-6);
  EXPECT_NEAR(kNao.projected(kNao.spreadFor(0.08975)), 0.08975, 1e-15);
  EXPECT_FALSE(shoulderRollFor(kNao, 0.107));
}

TEST(Arm, PointsTheForearmWhereverTheElbowCanBend) {
  test::RandomNumbers random(1);
  constexpr double kMost_rad = 1.54462;
  int exact = 0;
  for (int i = 0; i < 50'000; ++i) {
    const ArmAngles shoulder{random.between(-2.0, 2.0), random.between(-0.3, 1.3), 0.0, 0.0};
    const Vector3d wish =
        Vector3d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)).normalized();
    const ArmAngles dut = pointForearm(shoulder, wish, kMost_rad);
    const Vector3d forearm = placementOf(kNao, dut).forearm;
    ASSERT_LE(-dut.elbow_roll, kMost_rad);
    const double off_rad = std::acos(std::min(1.0, forearm.dot(wish)));
    if (-dut.elbow_roll < kMost_rad) {
      ASSERT_LE((forearm - wish).norm(), 1e-12) << "case " << i;
      ++exact;
    } else {
      // Between the upper arm and the wish, in the plane of both: what is missing is the least.
      const Vector3d upper = placementOf(kNao, {dut.shoulder_pitch, dut.shoulder_roll, 0.0, 0.0}).forearm;
      ASSERT_NEAR(off_rad, std::acos(upper.dot(wish)) - kMost_rad, 1e-7) << "case " << i;
    }
  }
  EXPECT_GT(exact, 20'000);
}

/// The skeleton knows nothing of the crawl's arm: both sides must put elbows and forearms alike.
TEST(Arm, AgreesWithTheWholeRobotOnBothSides) {
  test::RandomNumbers random(2);
  const Crawler& crawler = naoCrawler();
  for (int i = 0; i < 1000; ++i) {
    const SideShape shape{
        0.0, 0.0, 0.0, random.between(0.0, 0.4), random.between(-1.57, 0.0), random.between(0.0, 0.1)};
    const auto angles = anglesOf(crawler, shape);
    ASSERT_TRUE(angles);
    std::vector<double> pose(nao().joints().size());
    for (const auto& side : crawler.sides)
      for (const std::size_t joint : {kShoulderPitch, kShoulderRoll, kElbowYaw, kElbowRoll}) {
        const auto names = nao().joints();
        const auto column = std::find(names.begin(), names.end(), side[joint].name) - names.begin();
        pose[static_cast<std::size_t>(column)] = side[joint].toRobot((*angles)[joint]);
      }
    const Placements placed = placementsOf(nao(), pose);
    for (const char* side : {"L", "R"}) {
      const double outwards = side[0] == 'L' ? 1.0 : -1.0;
      const auto& shoulder = placed[*nao().findLink(std::string(side).append("Shoulder"))];
      const auto& forearm = placed[*nao().findLink(std::string(side).append("ForeArm"))];
      const Vector3d elbow = forearm.translation() - shoulder.translation();
      ASSERT_NEAR(elbow.y() * outwards, shape.spread_m, 1e-12) << "case " << i;
      // From the torso's frame to one that lies along the floor: the back rises by shape.back.
      const double along_floor = elbow.z() * std::cos(shape.back) + elbow.x() * std::sin(shape.back);
      ASSERT_NEAR(along_floor, crawler.arm.projected(shape.spread_m) * std::cos(shape.alpha), 1e-12);
      const Vector3d ahead = forearm.linear().col(0);
      if (-(*angles)[kElbowRoll] < crawler.mostBend() - 1e-12) {
        ASSERT_NEAR(ahead.z() * std::cos(shape.back) + ahead.x() * std::sin(shape.back), 1.0, 1e-12);
      }
    }
  }
}

TEST(Arm, EndsTheNominalPushAtTheElbowsLimit) {
  const Crawler& crawler = naoCrawler();
  const auto angles = anglesOf(crawler, {0.0, 0.0, 0.0, radians(19.8), radians(-90.0), 0.0565});
  ASSERT_TRUE(angles);
  EXPECT_NEAR(degrees((*angles)[kElbowRoll]), -88.5, 0.01);
}

}  // namespace
}  // namespace underway::gait
