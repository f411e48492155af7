#include "gait/rest.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gait/crawl/plane.hpp"
#include "gait/nao.hpp"

namespace underway::gait {
namespace {

/// A box on legs of four balls, its mass anywhere.
Skeleton tableWith(Eigen::Vector3d mass_center) {
  Skeleton skeleton;
  Link root;
  root.name = "table";
  root.axis = Eigen::Vector3d::UnitZ();
  root.mass_kg = 1.0;
  root.mass_center = mass_center;
  for (const double x : {-0.1, 0.1})
    for (const double y : {-0.05, 0.05}) root.shape.push_back({{x, y, 0.0}, 0.01});
  root.shape.push_back({{0.15, 0.0, 0.1}, 0.0});
  skeleton.links.push_back(root);
  return skeleton;
}

TEST(Rest, StandsOnWhatIsUnderTheCentreOfMass) {
  const Rest rest = settle(tableWith({0.04, 0.01, 0.2}), {}, 0.1);
  EXPECT_NEAR(rest.pitch_rad, 0.0, 1e-9);
  EXPECT_NEAR(rest.root.z(), 0.01, 1e-12);
  EXPECT_EQ(rest.contacts.size(), 4U);
  EXPECT_NEAR(rest.margin_m, 0.04, 1e-9);
  EXPECT_NEAR(rest.high.x(), 0.15, 1e-9);
}

TEST(Rest, TipsOverWhatItsMassHangsOut) {
  const Rest rest = settle(tableWith({0.12, 0.0, 0.06}), {}, 0.0);
  // Onto the front legs and the ball ahead: the line under both.
  EXPECT_NEAR(rest.pitch_rad, std::atan2(0.11, 0.05), 0.1);
  EXPECT_EQ(rest.contacts.size(), 3U);
  EXPECT_GT(rest.margin_m, 0.0);
}

TEST(Rest, NaoStandsOnItsFeetAndLiesOnItsChest) {
  const std::vector<double> straight(nao().joints().size());
  const Rest upright = settle(nao(), straight, 0.0);
  EXPECT_NEAR(upright.pitch_rad, 0.0, radians(1.0));
  EXPECT_NEAR(upright.high.z(), 0.574, 0.005);
  EXPECT_GT(upright.margin_m, 0.02);
  std::vector<double> reaching = straight;  // arms and head in line with the body
  const JointTable columns(nao().joints());
  for (const char* joint : {"LShoulderPitch", "RShoulderPitch"})
    reaching[*columns.find(joint)] = radians(-90.0);
  const Rest prone = settle(nao(), reaching, radians(80.0));
  EXPECT_NEAR(prone.pitch_rad, radians(90.0), radians(12.0));
  EXPECT_LT(prone.mass_center.z(), 0.12);
}

TEST(Rest, TheHeavierEndStays) {
  // Straight arms overhead reach ahead and back again: what bears the weight does not move.
  JointTable reach(nao().joints());
  std::vector<double> pose(reach.joints().size());
  for (int i = 0; i <= 10; ++i) {
    for (const char* joint : {"LShoulderPitch", "RShoulderPitch"})
      pose[*reach.find(joint)] = radians(-60.0 - 3.0 * i);
    reach.append(0.1 * i, pose);
  }
  const std::vector<Rest> rests = settleAll(nao(), reach, radians(87.0));
  for (const Rest& rest : rests) EXPECT_GE(rest.margin_m, 0.0);
  EXPECT_LT(std::abs(rests.back().root.x()), 0.05);
}

TEST(Rest, RefusesWhatCannotLie) {
  EXPECT_THROW(static_cast<void>(settle(Skeleton{}, {}, 0.0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(settleAll(nao(), JointTable({"HeadYaw"}), 0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace underway::gait
