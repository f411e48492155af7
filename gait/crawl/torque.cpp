#include "gait/crawl/torque.hpp"

#include <stdexcept>
#include <string>

namespace underway::gait {
namespace {

constexpr double kGravity_mps2 = 9.81;

const Link& linkOf(const Skeleton& skeleton, const char* name) {
  const auto index = skeleton.findLink(name);
  if (!index) throw std::invalid_argument(std::string("the chain's masses need a link ") + name);
  return skeleton.links[*index];
}

double dot(PlanePoint a, PlanePoint b) { return a.x * b.x + a.z * b.z; }
double cross(PlanePoint a, PlanePoint b) { return a.x * b.z - a.z * b.x; }

/// Gathers the masses of one link of the chain: of a standing robot seen from the side, x ahead, z up, all
/// told from the same joint.
class LinkSum {
 public:
  LinkSum(PlanePoint from, PlanePoint to) : from_(from), way_(to - from) {}

  void add(const Skeleton& nao, const char* name, PlanePoint joint) {
    const Link& link = linkOf(nao, name);
    const PlanePoint at = joint + PlanePoint{link.mass_center.x(), link.mass_center.z()} - from_;
    sum_.kg += link.mass_kg;
    sum_.along += link.mass_kg * dot(way_, at) / dot(way_, way_);
    sum_.across_m += link.mass_kg * cross(way_, at) / length(way_);
  }
  [[nodiscard]] LinkMass mean() const { return {sum_.kg, sum_.along / sum_.kg, sum_.across_m / sum_.kg}; }

 private:
  PlanePoint from_;
  PlanePoint way_;
  LinkMass sum_;
};

LinkMass trunkOf(const Skeleton& nao) {
  const PlanePoint hip{0.0, -0.085};  // of the torso
  LinkSum trunk(hip, {0.0, 0.1});
  trunk.add(nao, "torso", {});
  for (const char* name : {"Neck", "Head"}) trunk.add(nao, name, {0.0, 0.1265});
  for (const char* name : {"LPelvis", "RPelvis", "LHip", "RHip"}) trunk.add(nao, name, hip);
  return trunk.mean();
}

/// An upper arm is seen foreshortened: what matters is the share of the way from shoulder to elbow.
LinkMass armsOf(const Skeleton& nao) {
  const Eigen::Vector3d elbow = linkOf(nao, "LElbow").offset;
  LinkMass sum;
  const auto add = [&](const char* name, const Eigen::Vector3d& joint) {
    const Link& link = linkOf(nao, name);
    sum.kg += link.mass_kg;
    sum.along += link.mass_kg * (joint + link.mass_center).dot(elbow) / elbow.squaredNorm();
  };
  add("LShoulder", Eigen::Vector3d::Zero());
  add("LBicep", Eigen::Vector3d::Zero());
  add("LElbow", elbow);
  return {2.0 * sum.kg, sum.along / sum.kg, 0.0};
}

/// How far ahead a link's mass is.
double massAhead(const LinkMass& mass, PlanePoint from, PlanePoint to) {
  const PlanePoint way = to - from;
  return from.x + mass.along * way.x - mass.across_m * way.z / length(way);
}

double internalForce(const InternalForce& force, const ChainPoints& points, const ChainTorques& gravity_nm) {
  if (force.kind == InternalForce::Kind::kNone) return 0.0;
  if (force.kind == InternalForce::Kind::kConstant) return force.constant_n;
  double lifted = 0.0;
  double squares = 0.0;
  for (std::size_t j = 0; j < 4; ++j) {
    lifted += points[j + 1].z * gravity_nm[j];
    squares += points[j + 1].z * points[j + 1].z;
  }
  return squares > 0.0 ? -lifted / squares : 0.0;
}

}  // namespace

ChainMasses chainMassesOf(const Skeleton& nao) {
  LinkSum foot({0.0935, -0.04519}, {});  // toe and ankle, of the ankle
  for (const char* name : {"LAnklePitch", "RAnklePitch", "l_ankle", "r_ankle"}) foot.add(nao, name, {});
  LinkSum shin({0.0, -0.1029}, {});
  for (const char* name : {"LTibia", "RTibia"}) shin.add(nao, name, {});
  LinkSum thigh({0.0, -0.1}, {});
  for (const char* name : {"LThigh", "RThigh"}) thigh.add(nao, name, {});
  return {foot.mean(), shin.mean(), thigh.mean(), trunkOf(nao), armsOf(nao)};
}

ChainLoad loadOf(const ChainMasses& masses, const ChainPoints& points, const InternalForce& force) {
  std::array<double, 5> link_n{};
  std::array<double, 5> link_nm{};
  double weight_n = 0.0;
  double moment_nm = 0.0;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    link_n[i] = kGravity_mps2 * masses[i].kg;
    link_nm[i] = link_n[i] * massAhead(masses[i], points[i], points[i + 1]);
    weight_n += link_n[i];
    moment_nm += link_nm[i];
  }
  ChainLoad load;
  load.elbow_n = moment_nm / points[5].x;
  load.toe_n = weight_n - load.elbow_n;
  ChainTorques both_nm{};  // of both sides together, without the internal force
  double below_n = 0.0;
  double below_nm = 0.0;
  for (std::size_t j = 0; j < 4; ++j) {
    below_n += link_n[j];
    below_nm += link_nm[j];
    const double x = points[j + 1].x;
    both_nm[j] = -x * load.toe_n - (below_nm - x * below_n);
  }
  load.internal_n = internalForce(force, points, both_nm);
  for (std::size_t j = 0; j < 4; ++j)
    load.torques_nm[j] = 0.5 * (both_nm[j] + points[j + 1].z * load.internal_n);
  return load;
}

}  // namespace underway::gait
