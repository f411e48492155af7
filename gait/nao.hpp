#pragma once

#include "gait/skeleton.hpp"

namespace underway::gait {

/// NAO H25 V5.0: joints, limits, torques, speeds and masses of the public URDF (ros-naoqi/nao_robot,
/// nao_V50.urdf, commit 6747646, BSD-3), the same as in robots/nao.xml. The shapes are that file's too.
///
/// 23 joints: the hands' fingers are left out, and RHipYawPitch, which has no motor of its own.
[[nodiscard]] const Skeleton& nao();

/// The same with the masses of V4.0 (nao_V40.urdf), the robot of Brooks 2017: 5.195 kg.
[[nodiscard]] const Skeleton& naoV40();

}  // namespace underway::gait
