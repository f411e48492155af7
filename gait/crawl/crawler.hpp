#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gait/crawl/arm.hpp"
#include "gait/crawl/chain.hpp"
#include "gait/skeleton.hpp"

namespace underway::gait {

/// The joints one side of a robot crawls with, from the floor up.
enum CrawlJoint : std::size_t {
  kAnkle,          ///< theta2 of the chain
  kKnee,           ///< theta3
  kHip,            ///< theta4
  kShoulderPitch,  ///< the arm's joints as in arm.hpp
  kShoulderRoll,
  kElbowYaw,
  kElbowRoll,
};
inline constexpr std::size_t kCrawlJoints = 7;
/// "ankle", "knee" and so on.
[[nodiscard]] std::string_view name(CrawlJoint joint);

/// One side's angles by CrawlJoint [rad], told as if every side were a left one.
using SideAngles = std::array<double, kCrawlJoints>;

/// A joint of the robot that does what a joint of the crawl asks: angle = sign * crawl's angle + offset.
struct MappedJoint {
  std::string name;  ///< the robot's own
  double sign = 1.0;
  double offset_rad = 0.0;
  JointLimits limits;  ///< the robot's own

  [[nodiscard]] double toRobot(double crawl_rad) const { return sign * crawl_rad + offset_rad; }
  [[nodiscard]] double toCrawl(double robot_rad) const { return (robot_rad - offset_rad) / sign; }
  [[nodiscard]] double lower() const;  ///< of the crawl's angle [rad]
  [[nodiscard]] double upper() const;
};

/// A joint that the crawl needs still.
struct HeldJoint {
  std::string name;
  double angle_rad = 0.0;
};

/// What the crawl must know of a robot: any whose side view has feet, legs, a back and arms that bend, so
/// that toe, shoulder and elbow can make a parallelogram (Brooks 2015, section IV).
struct Crawler {
  std::string name;
  std::array<double, 4> links_m{};  ///< toe to ankle, ankle to knee, knee to hip, hip to shoulder
  ArmLengths arm;
  double shoulder_half_width_m = 0.0;  ///< from the middle to the shoulder joint
  double hip_half_width_m = 0.0;
  std::array<std::array<MappedJoint, kCrawlJoints>, 2> sides;  ///< left, right
  std::optional<MappedJoint> head;  ///< pitch of the head, towards the chest positive
  std::vector<HeldJoint> held;

  /// The chain's lengths when the elbows are `spread_m` outside of the shoulders [m].
  [[nodiscard]] LinkLengths lengths(double spread_m) const;
  /// The most the elbow bends, on the side that bends less [rad].
  [[nodiscard]] double mostBend() const;
  /// All names: left, right, head, held.
  [[nodiscard]] std::vector<std::string> joints() const;
};

/// One side seen from the side: the leg's joints, and where the upper arm points [rad].
struct SideShape {
  double ankle = 0.0;     ///< theta2
  double knee = 0.0;      ///< theta3
  double hip = 0.0;       ///< theta4
  double back = 0.0;      ///< the back against the floor
  double alpha = 0.0;     ///< the upper arm against the floor, projected
  double spread_m = 0.0;  ///< of the elbow, outside of the shoulder
  double rise = 0.0;      ///< of the forearm, which points ahead
  bool operator==(const SideShape&) const = default;
};

/// The closed chain's.
[[nodiscard]] SideShape shapeOf(const ChainAngles& chain, double spread_m);

/// As joint angles. The elbow bends as far as it can (pointForearm). Infeasible when the spread is wider than
/// the humerus is long.
[[nodiscard]] Feasible<SideAngles> anglesOf(const Crawler& crawler, const SideShape& shape);

/// NAO. Lengths: nao_V50.urdf; the toe is 93.5 mm ahead of the ankle and 45.19 mm below (Brooks 2017).
[[nodiscard]] const Crawler& naoCrawler();

/// Poppy Humanoid: another robot of the same make, 84 cm tall. Lengths and limits of its public URDF
/// (poppy-project/poppy-humanoid, hardware/URDF/robots/Poppy_Humanoid.URDF). The foot, whose shape that file
/// leaves to a mesh, is taken to reach 110 mm ahead of the ankle and 35 mm below; 9 mm by which the elbow
/// lies beside the upper arm's axis are left out.
[[nodiscard]] const Crawler& poppyCrawler();

}  // namespace underway::gait
