#include "gait/nao.hpp"

#include <cmath>
#include <initializer_list>
#include <tuple>
#include <utility>

namespace underway::gait {
namespace {

using Vector = Eigen::Vector3d;
using Shape = std::vector<Ball>;

Shape ball(Vector center, double radius_m) { return {{center, radius_m}}; }

Shape capsule(Vector from, Vector to, double radius_m) { return {{from, radius_m}, {to, radius_m}}; }

Shape box(const Vector& center, const Vector& half_size) {
  Shape corners;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        corners.push_back({center + half_size.cwiseProduct(Vector(x, y, z)), 0.0});
  return corners;
}

Shape all(std::initializer_list<Shape> shapes) {
  Shape balls;
  for (const Shape& shape : shapes) balls.insert(balls.end(), shape.begin(), shape.end());
  return balls;
}

/// A link of nao_V50.urdf, and what it weighs in nao_V40.urdf. Lengths in m, angles in rad, masses in kg.
struct Row {
  const char* link;
  const char* joint;
  const char* parent;
  Vector offset;
  Vector axis;
  JointLimits limits;
  double mass_v50_kg;
  double mass_v40_kg;
  Vector mass_center;
  Shape shape;
};

// A table.
// clang-format off
std::vector<Row> middle() {
  return {
      {"torso", "", "", {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0},
       {}, 1.04956, 1.04956, {-0.00413, 0.0, 0.04342},
       all({capsule({0.0025, -0.03, 0.062}, {0.0025, 0.03, 0.062}, 0.0555),
            capsule({0.0, -0.07, 0.1}, {0.0, 0.07, 0.1}, 0.034),
            capsule({0.01, 0.0, -0.055}, {0.01, 0.0, 0.02}, 0.042)})},
      {"Neck", "HeadYaw", "torso", {0.0, 0.0, 0.1265}, {0.0, 0.0, 1.0},
       {-2.08567, 2.08567, 8.26797, 1.547}, 0.07842, 0.06442, {-1e-05, 0.0, -0.02742}, {}},
      {"Head", "HeadPitch", "Neck", {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
       {-0.671952, 0.514872, 7.19407, 1.532}, 0.60533, 0.60533, {-0.00112, 0.0, 0.05258},
       all({ball({0.0, 0.0, 0.0535}, 0.061), capsule({0.0, -0.035, 0.053}, {0.0, 0.035, 0.053}, 0.0315)})},
  };
}

std::vector<Row> left() {
  return {
      {"LShoulder", "LShoulderPitch", "torso", {0.0, 0.098, 0.1}, {0.0, 1.0, 0.0},
       {-2.08567, 2.08567, 8.26797, 1.329}, 0.09304, 0.07504, {-0.00165, -0.02663, 0.00014}, {}},
      {"LBicep", "LShoulderRoll", "LShoulder", {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0},
       {-0.314159, 1.32645, 7.19407, 1.7835}, 0.15777, 0.15777, {0.02455, 0.00563, 0.0033},
       all({ball({0.0, 0.003, 0.0}, 0.0395), capsule({0.01, 0.004, 0.0}, {0.1, 0.015, 0.0}, 0.03)})},
      {"LElbow", "LElbowYaw", "LBicep", {0.105, 0.015, 0.0}, {1.0, 0.0, 0.0},
       {-2.08567, 2.08567, 8.26797, 1.547}, 0.06483, 0.06483, {-0.02744, 0.0, -0.00014}, {}},
      {"LForeArm", "LElbowRoll", "LElbow", {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0},
       {-1.54462, -0.0349066, 7.19407, 1.532}, 0.07761, 0.07761, {0.02556, 0.00281, 0.00076},
       capsule({0.0, 0.0, 0.0}, {0.056, 0.0, 0.0}, 0.03)},
      {"l_wrist", "LWristYaw", "LForeArm", {0.05595, 0.0, 0.0}, {1.0, 0.0, 0.0},
       {-1.82387, 1.82387, 24.6229, 0.4075}, 0.18533, 0.18533, {0.03434, -0.00088, 0.00308},
       capsule({0.02, 0.0, 0.0}, {0.088, 0.0, 0.0}, 0.027)},
      {"LPelvis", "LHipYawPitch", "torso", {0.0, 0.05, -0.085}, {0.0, std::sqrt(0.5), -std::sqrt(0.5)},
       {-1.14529, 0.740718, 4.16174, 3.348}, 0.06981, 0.06981, {-0.00781, -0.01114, 0.02661}, {}},
      {"LHip", "LHipRoll", "LPelvis", {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0},
       {-0.379435, 0.79046, 4.16174, 3.348}, 0.14053, 0.13053, {-0.01549, 0.00029, -0.00515},
       ball({0.0, 0.0, -0.005}, 0.045)},
      {"LThigh", "LHipPitch", "LHip", {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
       {-1.53589, 0.48398, 6.40239, 3.023}, 0.38968, 0.38968, {0.00138, 0.00221, -0.05373},
       capsule({0.004, 0.0, -0.01}, {0.008, 0.0, -0.095}, 0.038)},
      {"LTibia", "LKneePitch", "LThigh", {0.0, 0.0, -0.1}, {0.0, 1.0, 0.0},
       {-0.0923279, 2.11255, 6.40239, 3.023}, 0.30142, 0.29142, {0.00453, 0.00225, -0.04936},
       capsule({0.004, 0.0, -0.005}, {-0.004, 0.0, -0.095}, 0.037)},
      {"LAnklePitch", "LAnklePitch", "LTibia", {0.0, 0.0, -0.1029}, {0.0, 1.0, 0.0},
       {-1.18944, 0.922581, 6.40239, 3.023}, 0.13416, 0.13416, {0.00045, 0.00029, 0.00685}, {}},
      {"l_ankle", "LAnkleRoll", "LAnklePitch", {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0},
       {-0.397761, 0.768992, 4.16174, 3.348}, 0.17184, 0.16184, {0.02542, 0.0033, -0.03239},
       all({box({0.019, 0.006, -0.0301}, {0.074, 0.044, 0.015}),
            capsule({0.0935, -0.02, -0.0351}, {0.0935, 0.032, -0.0351}, 0.01)})},
  };
}

// clang-format on

/// The side's letter in a name: "LThigh", "l_ankle" and the like.
std::string mirrored(std::string name) {
  if (name.starts_with("L")) name[0] = 'R';
  if (name.starts_with("l_")) name[0] = 'r';
  return name;
}

Vector mirrored(const Vector& v) { return {v.x(), -v.y(), v.z()}; }

/// The right side's link. Pitch turns both sides alike; roll and yaw turn them to the robot's left both, so
/// that their limits are mirrored.
Link mirrored(Link link) {
  link.name = mirrored(link.name);
  link.joint = mirrored(link.joint);
  link.offset = mirrored(link.offset);
  link.mass_center = mirrored(link.mass_center);
  for (Ball& part : link.shape) part.center = mirrored(part.center);
  const bool is_pitch = link.axis.y() != 0.0;
  if (is_pitch)
    link.axis.z() = -link.axis.z();
  else
    link.limits = {-link.limits.upper_rad, -link.limits.lower_rad, link.limits.speed_radps,
                   link.limits.torque_nm};
  return link;
}

/// What is not mirrored in the URDF.
void setRightsOwn(Link& link) {
  if (link.joint == "RHipYawPitch") link.turns_with = "LHipYawPitch";
  if (link.joint == "RAnklePitch")
    std::tie(link.limits.lower_rad, link.limits.upper_rad) = std::pair(-1.1863, 0.932006);
  if (link.joint == "RHipPitch" || link.joint == "RKneePitch" || link.joint == "RAnklePitch")
    link.limits.torque_nm = 3.0226;
  if (link.joint == "RShoulderRoll") link.limits.torque_nm = 1.783;
}

Link linkOf(const Row& row, double mass_kg) {
  return {row.link, row.joint, -1, row.offset, row.axis, row.limits, mass_kg, row.mass_center, row.shape, ""};
}

class Builder {
 public:
  explicit Builder(std::string name) { skeleton_.name = std::move(name); }

  void add(Link link, const std::string& parent) {
    if (const auto found = skeleton_.findLink(parent)) link.parent = static_cast<int>(*found);
    skeleton_.links.push_back(std::move(link));
  }
  [[nodiscard]] Skeleton skeleton() const { return skeleton_; }

 private:
  Skeleton skeleton_;
};

Skeleton build(const char* name, double Row::*mass) {
  Builder builder(name);
  for (const Row& row : middle()) builder.add(linkOf(row, row.*mass), row.parent);
  for (const Row& row : left()) builder.add(linkOf(row, row.*mass), row.parent);
  for (const Row& row : left()) {
    Link link = mirrored(linkOf(row, row.*mass));
    setRightsOwn(link);
    builder.add(std::move(link), mirrored(std::string(row.parent)));
  }
  return builder.skeleton();
}

}  // namespace

const Skeleton& nao() {
  static const Skeleton kNao = build("nao", &Row::mass_v50_kg);
  return kNao;
}

const Skeleton& naoV40() {
  static const Skeleton kNao = build("nao_v40", &Row::mass_v40_kg);
  return kNao;
}

}  // namespace underway::gait
