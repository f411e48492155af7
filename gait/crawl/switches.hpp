#pragma once

#include "gait/joint_table.hpp"

namespace underway::gait {

/// From standing to the crawl and back, for NAO, as keyframes with straight ways between them.
///
/// Down: fold at the hips over straight legs until the hands reach the floor ahead of the toes; lean on them;
/// one hand after the other steps further ahead; the elbows bend onto the floor; the knees go down, then
/// back. Up is the same backwards: from the elbows the knees come under the hips and stretch, the feet come
/// to stand flat, one hand after the other steps towards them, until they alone bear the robot; it unfolds.
///
/// Why so: bending as deep as NAO's joints let it with the feet flat, the shoulders stay higher than the arms
/// are long (.28 m against .25 m), so that no way leads through a squat; folded over straight legs they are
/// at .19 to .25 m with the centre of mass above the feet. Hands step because they do not slide on rough
/// floors. Tuned in MuJoCo for friction .4 to 1; the centre of mass stays above feet, knees, elbows and
/// hands.
///
/// `crawl` is a motion of the crawl. Down ends, and up begins, in its first row; the columns are its own.
/// Throws std::invalid_argument when it has no row or lacks one of NAO's arm, leg and HeadPitch joints.
[[nodiscard]] JointTable goDown(const JointTable& crawl);
[[nodiscard]] JointTable getUp(const JointTable& crawl);

/// How NAO stands before it goes down and after it got up: one row, in the columns of `crawl`.
[[nodiscard]] JointTable standing(const JointTable& crawl);

}  // namespace underway::gait
