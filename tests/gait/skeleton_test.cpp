#include "gait/skeleton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gait/nao.hpp"
#include "tests/gait/random_numbers.hpp"

namespace underway::gait {
namespace {

std::vector<double> randomPose(test::RandomNumbers& random) {
  std::vector<double> pose;
  for (const std::string& joint : nao().joints()) {
    const JointLimits& limits = nao().links[*nao().findJoint(joint)].limits;
    pose.push_back(random.between(limits.lower_rad, limits.upper_rad));
  }
  return pose;
}

TEST(Nao, WeighsWhatItsUrdfSays) {
  EXPECT_NEAR(nao().mass(), 5.305, 0.001);
  EXPECT_NEAR(naoV40().mass(), 5.1954, 0.0001);
}

TEST(Nao, StandsAsTallAsItIs) {
  const Placements placed = placementsOf(nao(), std::vector<double>(nao().joints().size()));
  double top = 0.0;
  double bottom = 0.0;
  for (const Ball& ball : ballsOf(nao(), placed)) {
    top = std::max(top, ball.center.z() + ball.radius_m);
    bottom = std::min(bottom, ball.center.z() - ball.radius_m);
  }
  EXPECT_NEAR(top - bottom, 0.574, 0.005);
}

TEST(Nao, MirroredPosesAreMirrorImages) {
  test::RandomNumbers random(1);
  const std::vector<std::string> joints = nao().joints();
  for (int i = 0; i < 200; ++i) {
    std::vector<double> left = randomPose(random);
    std::vector<double> right = left;
    for (std::size_t a = 0; a < joints.size(); ++a)
      for (std::size_t b = 0; b < joints.size(); ++b) {
        const bool are_mates = joints[a].substr(1) == joints[b].substr(1) && joints[a] != joints[b];
        const bool is_pitch = nao().links[*nao().findJoint(joints[a])].axis.y() != 0.0;
        if (are_mates) right[a] = is_pitch ? left[b] : -left[b];
        if (a == b && joints[a] == "HeadYaw") right[a] = -left[a];
      }
    const Eigen::Vector3d one = massCenterOf(nao(), placementsOf(nao(), left));
    const Eigen::Vector3d other = massCenterOf(nao(), placementsOf(nao(), right));
    ASSERT_NEAR(one.x(), other.x(), 1e-12);
    ASSERT_NEAR(one.y(), -other.y(), 1e-12);
    ASSERT_NEAR(one.z(), other.z(), 1e-12);
  }
}

TEST(Skeleton, TurnsBothHipsWithTheirOneMotor) {
  std::vector<double> pose(nao().joints().size());
  const auto joints = nao().joints();
  EXPECT_EQ(std::count(joints.begin(), joints.end(), "RHipYawPitch"), 0);
  pose[static_cast<std::size_t>(std::find(joints.begin(), joints.end(), "LHipYawPitch") - joints.begin())] =
      -0.5;
  const Placements placed = placementsOf(nao(), pose);
  const Eigen::Vector3d left = placed[*nao().findLink("l_ankle")].translation();
  const Eigen::Vector3d right = placed[*nao().findLink("r_ankle")].translation();
  EXPECT_NEAR(left.x(), right.x(), 1e-12);
  EXPECT_NEAR(left.y(), -right.y(), 1e-12);
  EXPECT_GT(std::abs(left.y() - 0.05), 0.01) << "nothing turned";
}

TEST(Skeleton, RefusesPosesOfTheWrongLength) {
  EXPECT_THROW(static_cast<void>(placementsOf(nao(), std::vector<double>(3))), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(placementsOf(nao(), std::vector<double>(99))), std::invalid_argument);
}

}  // namespace
}  // namespace underway::gait
