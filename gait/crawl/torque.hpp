#pragma once

#include <array>

#include "gait/crawl/chain.hpp"
#include "gait/skeleton.hpp"

namespace underway::gait {

/// Torques that hold the closed chain still (pseudo-static: gravity alone; Brooks 2017, 4.3.1). Seen from the
/// side, toes and elbows are pins that share the weight by the lever's law. A robot on four pins may also
/// press them apart or together along the floor: that internal force is free, and only the servos know it.

/// What one link of the chain weighs, both sides together, and where: its centre of mass.
struct LinkMass {
  double kg = 0.0;
  double along = 0.0;     ///< from the link's toe end, as a share of the link's length
  double across_m = 0.0;  ///< counter-clockwise of the link [m]
};
/// Foot, shin, thigh, trunk with head, upper arms. Forearms lie on the floor and are left out.
using ChainMasses = std::array<LinkMass, 5>;

/// NAO's. `nao`: a skeleton with NAO's links; throws std::invalid_argument when one is missing.
[[nodiscard]] ChainMasses chainMassesOf(const Skeleton& nao);

/// What the pins do along the floor [N].
struct InternalForce {
  enum class Kind {
    kNone,      ///< 0
    kConstant,  ///< given
    kServo,     ///< what equal servos settle at: the least sum of squared torques
  } kind = Kind::kServo;
  double constant_n = 0.0;  ///< at the toes, along x
};

/// Torques of ankle, knee, hip and shoulder, of one side [Nm].
using ChainTorques = std::array<double, 4>;

struct ChainLoad {
  ChainTorques torques_nm{};
  double toe_n = 0.0;       ///< weight on both toes
  double elbow_n = 0.0;     ///< weight on both elbows
  double internal_n = 0.0;  ///< the internal force taken
};

/// Toe at the origin, elbow on the floor. Each side bears half.
[[nodiscard]] ChainLoad loadOf(const ChainMasses& masses, const ChainPoints& points,
                               const InternalForce& force);

}  // namespace underway::gait
