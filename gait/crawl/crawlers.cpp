// The robots that come along.

#include <cmath>
#include <numbers>

#include "gait/crawl/crawler.hpp"
#include "gait/nao.hpp"

namespace underway::gait {
namespace {

/// What turns the robot's left on both sides: yaw and roll.
bool isMirrored(std::size_t joint) { return joint >= kShoulderRoll; }

Crawler makeNao() {
  constexpr double kToeAhead_m = 0.0935;
  constexpr double kToeBelow_m = 0.04519;
  Crawler crawler;
  crawler.name = "nao";
  crawler.links_m = {std::hypot(kToeAhead_m, kToeBelow_m), 0.1029, 0.1, 0.185};
  crawler.arm = {0.105, 0.015};
  crawler.shoulder_half_width_m = 0.098;
  crawler.hip_half_width_m = 0.05;
  constexpr std::array kJoints{"AnklePitch",   "KneePitch", "HipPitch", "ShoulderPitch",
                               "ShoulderRoll", "ElbowYaw",  "ElbowRoll"};
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t joint = 0; joint < kCrawlJoints; ++joint) {
      const std::string name = std::string(side == 0 ? "L" : "R").append(kJoints[joint]);
      const double sign = side == 1 && isMirrored(joint) ? -1.0 : 1.0;
      const double offset = joint == kAnkle ? std::atan2(kToeAhead_m, kToeBelow_m) : 0.0;
      crawler.sides[side][joint] = {name, sign, offset, nao().links[*nao().findJoint(name)].limits};
    }
  crawler.head = MappedJoint{"HeadPitch", 1.0, 0.0, nao().links[*nao().findJoint("HeadPitch")].limits};
  for (const char* name : {"HeadYaw", "LHipYawPitch", "LHipRoll", "LAnkleRoll", "LWristYaw", "RHipRoll",
                           "RAnkleRoll", "RWristYaw"})
    crawler.held.push_back({name, 0.0});
  return crawler;
}

struct PoppyRow {
  const char* joint;
  double sign;        ///< on the left
  double offset_rad;  ///< on the left
  double right_sign;  ///< times both, on the right
  JointLimits left;
  JointLimits right;
};

/// Its legs bend as NAO's do. Its arms hang on the same joints; at 0 they are straight out and bend upwards,
/// where NAO's point ahead and bend inwards.
std::vector<PoppyRow> poppyRows(double ankle_rad) {
  constexpr double kQuarter_rad = 0.5 * std::numbers::pi;
  return {
      {"ankle_y", 1.0, ankle_rad, -1.0, {-0.610865, 1.221730, 7.0, 3.1}, {-1.221730, 0.436332, 7.0, 3.1}},
      {"knee_y", 1.0, 0.0, -1.0, {-0.034907, 2.094395, 7.0, 3.1}, {-2.094395, 0.034907, 7.0, 3.1}},
      {"hip_y", 1.0, 0.0, -1.0, {-1.832596, 1.483530, 8.2, 7.3}, {-1.483530, 1.832596, 8.2, 7.3}},
      {"shoulder_y", 1.0, 0.0, -1.0, {-2.094395, 2.705260, 7.0, 3.1}, {-2.705260, 2.094395, 7.0, 3.1}},
      {"shoulder_x",
       -1.0,
       kQuarter_rad,
       1.0,
       {-1.832596, 1.919862, 7.0, 3.1},
       {-1.919862, 1.832596, 7.0, 3.1}},
      {"arm_z", 1.0, kQuarter_rad, -1.0, {-1.570796, 1.570796, 7.0, 3.1}, {-1.570796, 1.570796, 7.0, 3.1}},
      {"elbow_y", 1.0, 0.0, -1.0, {-2.443461, 0.0, 7.0, 3.1}, {0.0, 2.565634, 7.0, 3.1}},
  };
}

Crawler makePoppy() {
  constexpr double kToeAhead_m = 0.110;
  constexpr double kToeBelow_m = 0.035;
  Crawler crawler;
  crawler.name = "poppy";
  crawler.links_m = {std::hypot(kToeAhead_m, kToeBelow_m), 0.18, 0.182, 0.2665};
  crawler.arm = {0.148, 0.0};
  crawler.shoulder_half_width_m = 0.1055;
  crawler.hip_half_width_m = 0.0665;
  const std::vector<PoppyRow> rows = poppyRows(std::atan2(kToeAhead_m, kToeBelow_m));
  for (std::size_t joint = 0; joint < kCrawlJoints; ++joint) {
    const PoppyRow& row = rows[joint];
    const std::string name = row.joint;
    crawler.sides[0][joint] = {std::string("l_").append(name), row.sign, row.offset_rad, row.left};
    crawler.sides[1][joint] = {std::string("r_").append(name), row.right_sign * row.sign,
                               row.right_sign * row.offset_rad, row.right};
  }
  crawler.head = MappedJoint{"head_y", -1.0, 0.0, {-0.698132, 0.139626, 10.0, 1.8}};
  for (const char* name :
       {"head_z", "l_hip_x", "l_hip_z", "r_hip_x", "r_hip_z", "abs_y", "abs_x", "abs_z", "bust_y", "bust_x"})
    crawler.held.push_back({name, 0.0});
  return crawler;
}

}  // namespace

const Crawler& naoCrawler() {
  static const Crawler kNao = makeNao();
  return kNao;
}

const Crawler& poppyCrawler() {
  static const Crawler kPoppy = makePoppy();
  return kPoppy;
}

}  // namespace underway::gait
