// The robot that physics plays (robots/nao.xml) against the one that gaits are made for (gait/nao.cpp): two
// tables that must say the same.

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

#include "gait/nao.hpp"
#include "sim/physics/scene.hpp"
#include "tests/gait/random_numbers.hpp"

namespace underway::physics {
namespace {

using gait::nao;

class SkeletonTest : public testing::Test {
 protected:
  void SetUp() override {
    auto made = makeModel(UNDERWAY_SOURCE_DIR "/robots/nao.xml", {}, 0.7);
    ASSERT_TRUE(made) << made.error().message;
    model_ = std::move(*made);
    data_.reset(mj_makeData(model_.get()));
  }
  [[nodiscard]] int body(const std::string& name) const {
    return mj_name2id(model_.get(), mjOBJ_BODY, name.c_str());
  }
  /// Sets a joint, and whatever turns with it.
  void turn(const std::string& joint, double angle_rad) {
    const int id = mj_name2id(model_.get(), mjOBJ_JOINT, joint.c_str());
    ASSERT_GE(id, 0) << joint;
    data_->qpos[model_->jnt_qposadr[id]] = angle_rad;
    for (const gait::Link& link : nao().links)
      if (link.turns_with == joint) turn(link.joint, angle_rad);
  }

  Model model_;
  Data data_;
};

TEST_F(SkeletonTest, LinksAreInTheSamePlacesAtAnyPose) {
  gait::test::RandomNumbers random(1);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> pose;
    for (const std::string& joint : nao().joints()) {
      const gait::JointLimits& limits = nao().links[*nao().findJoint(joint)].limits;
      pose.push_back(random.between(limits.lower_rad, limits.upper_rad));
      turn(joint, pose.back());
    }
    mj_kinematics(model_.get(), data_.get());
    const gait::Placements placed = placementsOf(nao(), pose);
    const double* root = data_->xpos + 3 * body("torso");  // unturned
    for (std::size_t link = 0; link < placed.size(); ++link) {
      const double* at = data_->xpos + 3 * body(nao().links[link].name);
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_NEAR(at[axis] - root[axis], placed[link].translation()[axis], 1e-6)
            << nao().links[link].name << ", case " << i;
    }
  }
}

TEST_F(SkeletonTest, LinksWeighAndMayMoveTheSame) {
  for (const gait::Link& link : nao().links) {
    const int id = body(link.name);
    ASSERT_GE(id, 0) << link.name;
    EXPECT_DOUBLE_EQ(model_->body_mass[id], link.mass_kg) << link.name;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(model_->body_ipos[3 * id + axis], link.mass_center[axis], 1e-12) << link.name;
    if (link.joint.empty()) continue;
    const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, link.joint.c_str());
    EXPECT_NEAR(model_->jnt_range[2 * joint], link.limits.lower_rad, 1e-9) << link.joint;
    EXPECT_NEAR(model_->jnt_range[2 * joint + 1], link.limits.upper_rad, 1e-9) << link.joint;
  }
}

/// Both stand equally tall and reach equally far: the balls enclose what MuJoCo's shapes do.
TEST_F(SkeletonTest, ShapesAreTheSame) {
  for (const gait::Link& link : nao().links) {
    double reach = 0.0;
    for (const gait::Ball& ball : link.shape) reach = std::max(reach, ball.center.norm() + ball.radius_m);
    double other = 0.0;
    const int id = body(link.name);
    for (int geom = 0; geom < model_->ngeom; ++geom) {
      if (model_->geom_bodyid[geom] != id) continue;
      const double* size = model_->geom_size + 3 * geom;
      const Eigen::Map<const Eigen::Vector3d> middle(model_->geom_pos + 3 * geom);
      double turned[9];
      mju_quat2Mat(turned, model_->geom_quat + 4 * geom);
      const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(turned);
      for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
          for (const double z : {-1.0, 1.0}) {
            const bool is_box = model_->geom_type[geom] == mjGEOM_BOX;
            const bool is_capsule = model_->geom_type[geom] == mjGEOM_CAPSULE;
            const Eigen::Vector3d corner = is_box ? Eigen::Vector3d(x * size[0], y * size[1], z * size[2])
                                                  : Eigen::Vector3d(0.0, 0.0, is_capsule ? z * size[1] : 0.0);
            other = std::max(other, (middle + frame * corner).norm() + (is_box ? 0.0 : size[0]));
          }
    }
    EXPECT_NEAR(reach, other, 1e-9) << link.name;
  }
}

}  // namespace
}  // namespace underway::physics
