// The robot that physics plays against the public URDF's figures, and its contact shapes against what they
// enclose.

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "sim/physics/scene.hpp"
#include "sim/physics/shapes.hpp"

namespace underway::physics {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = UNDERWAY_SOURCE_DIR;
const fs::path kJoints = kProject / ".." / "shared" / "facts" / "nao_joints_V50.csv";

class ModelTest : public testing::Test {
 protected:
  void SetUp() override {
    auto made = makeModel(kProject / "robots" / "nao.xml", {}, 0.7);
    ASSERT_TRUE(made) << made.error().message;
    model_ = std::move(*made);
    data_.reset(mj_makeData(model_.get()));
    mj_forward(model_.get(), data_.get());
  }
  [[nodiscard]] int id(mjtObj kind, const std::string& name) const {
    return mj_name2id(model_.get(), kind, name.c_str());
  }

  Model model_;
  Data data_;
};

/// Rows of a table of comma-separated values, by the names in its first line.
std::vector<std::map<std::string, std::string>> readTable(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> names;
  std::vector<std::map<std::string, std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    std::istringstream cells(line);
    std::map<std::string, std::string> row;
    std::size_t column = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++column)
      if (rows.empty() && names.size() == column)
        names.push_back(cell);
      else
        row[names.at(column)] = cell;
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

TEST_F(ModelTest, JointsAndLinksAreThoseOfThePublicUrdf) {
  if (!fs::exists(kJoints)) GTEST_SKIP() << kJoints << " is not there to compare with";
  std::size_t compared = 0;
  for (const auto& row : readTable(kJoints)) {
    const std::string& name = row.at("joint");
    SCOPED_TRACE(name);
    if (name == "LHand" || name == "RHand") continue;  // do not move here
    const auto fact = [&](const char* column) { return std::stod(row.at(column)); };
    const int joint = id(mjOBJ_JOINT, name);
    const int body = id(mjOBJ_BODY, row.at("child"));
    ASSERT_GE(joint, 0);
    ASSERT_GE(body, 0);
    EXPECT_EQ(model_->body_parentid[body], id(mjOBJ_BODY, row.at("parent")));
    const std::array offset{"ox", "oy", "oz"};
    const std::array axis{"ax", "ay", "az"};
    const std::array com{"com_x", "com_y", "com_z"};
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(model_->body_pos[3 * body + i], fact(offset[i]), 1e-9);
      EXPECT_NEAR(model_->jnt_axis[3 * joint + i], fact(axis[i]), 1e-5);
      EXPECT_NEAR(model_->body_ipos[3 * body + i], fact(com[i]), 1e-9);
    }
    EXPECT_NEAR(model_->jnt_range[2 * joint], fact("lower"), 1e-9);
    EXPECT_NEAR(model_->jnt_range[2 * joint + 1], fact("upper"), 1e-9);
    EXPECT_NEAR(model_->body_mass[body], fact("child_mass"), 1e-9);
    EXPECT_NEAR(model_->body_inertia[3 * body] + model_->body_inertia[3 * body + 1] +
                    model_->body_inertia[3 * body + 2],
                fact("ixx") + fact("iyy") + fact("izz"), 1e-9);
    ++compared;
    const int servo = id(mjOBJ_ACTUATOR, name);
    if (name == "RHipYawPitch") {
      EXPECT_LT(servo, 0) << "one motor moves both hips' yaw-pitch";
      continue;
    }
    ASSERT_GE(servo, 0);
    EXPECT_NEAR(model_->actuator_forcerange[2 * servo + 1], fact("effort"), 1e-9);
    EXPECT_NEAR(model_->actuator_forcerange[2 * servo], -fact("effort"), 1e-9);
    EXPECT_NEAR(model_->actuator_user[servo * model_->nuser_actuator], fact("velocity"), 1e-9);
  }
  EXPECT_EQ(compared, 24U);
}

TEST_F(ModelTest, WeighsWhatTheRobotWeighs) {
  double mass_kg = 0.0;
  for (int body = 0; body < model_->nbody; ++body) mass_kg += model_->body_mass[body];
  EXPECT_NEAR(mass_kg, 5.3054, 1e-3);
}

TEST_F(ModelTest, StandsAsHighAsTheRobot) {
  const BodyBox box = enclose(*model_, *data_, {});
  EXPECT_NEAR(box.z.min, 0.0, 1e-3);
  EXPECT_NEAR(box.z.max, 0.574, 0.005);
}

/// Whether a point given in a body's frame lies in one of the body's shapes.
bool isInside(const mjModel& model, int body, const std::array<double, 3>& p) {
  constexpr double kTolerance_m = 1e-3;
  for (int geom = model.body_geomadr[body]; geom < model.body_geomadr[body] + model.body_geomnum[body];
       ++geom) {
    double rotation[9];
    double arm[3];
    double local[3];
    mju_quat2Mat(rotation, model.geom_quat + 4 * geom);
    mju_sub3(arm, p.data(), model.geom_pos + 3 * geom);
    mju_rotVecMatT(local, arm, rotation);
    const double* size = model.geom_size + 3 * geom;
    if (model.geom_type[geom] == mjGEOM_BOX) {
      if (std::abs(local[0]) <= size[0] + kTolerance_m && std::abs(local[1]) <= size[1] + kTolerance_m &&
          std::abs(local[2]) <= size[2] + kTolerance_m)
        return true;
      continue;
    }
    const double half = model.geom_type[geom] == mjGEOM_CAPSULE ? size[1] : 0.0;
    local[2] -= std::clamp(local[2], -half, half);
    if (mju_norm3(local) <= size[0] + kTolerance_m) return true;
  }
  return false;
}

TEST_F(ModelTest, ShapesEncloseTheSensorsOnTheShell) {
  struct Place {
    const char* body;
    std::array<double, 3> p;  ///< in the body's frame [m], from the public URDF
  };
  const std::vector<Place> places{{"Head", {0.0312, 0.0, 0.1014}},
                                  {"Head", {-0.0257, 0.0, 0.1045}},
                                  {"Head", {0.001, 0.0, 0.1099}},
                                  {"Head", {0.05871, 0.0, 0.06364}},
                                  {"Head", {0.05071, 0.0, 0.01774}},
                                  {"Head", {0.0441, 0.0257, 0.0466}},
                                  {"torso", {0.049871, 0.001588, 0.0552}},
                                  {"l_ankle", {0.0876, 0.019, -0.0353}},
                                  {"l_ankle", {0.0876, -0.014, -0.0353}},
                                  {"l_ankle", {0.07025, 0.0299, -0.04511}},
                                  {"l_ankle", {-0.03025, 0.0299, -0.04511}},
                                  {"l_ankle", {-0.02965, -0.0191, -0.04511}},
                                  {"r_ankle", {0.0876, -0.019, -0.0353}},
                                  {"r_ankle", {-0.02965, -0.0299, -0.04511}},
                                  {"l_wrist", {0.032, 0.025, 0.003}},
                                  {"l_wrist", {0.038, 0.0, 0.025}},
                                  {"r_wrist", {0.035, -0.025, 0.0035}},
                                  {"l_wrist", {0.06907, 0.01157, -0.00304}}};
  for (const Place& place : places)
    EXPECT_TRUE(isInside(*model_, id(mjOBJ_BODY, place.body), place.p))
        << place.body << " " << place.p[0] << " " << place.p[1] << " " << place.p[2];
}

TEST(MakeModel, SaysWhatIsWrongWithAFile) {
  const auto missing = makeModel("no/such/robot.xml", {}, 0.7);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kInvalidRobot);
  const auto not_a_robot = makeModel(kProject / "robots" / "nao.yaml", {}, 0.7);
  ASSERT_FALSE(not_a_robot);
  EXPECT_NE(not_a_robot.error().message.find("nao.yaml"), std::string::npos);
}

}  // namespace
}  // namespace underway::physics
