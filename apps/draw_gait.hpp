#pragma once

#include <string>

#include "gait/crawl/gait.hpp"

namespace underway {

/// The thesis' figures of a gait as one SVG file: the free angles over the push beside the nominal ones (its
/// figure 67), the chain on its way (68), the joints over the motion (73), and the torques of the push in the
/// pseudo-static model beside the nominal ones.
[[nodiscard]] std::string drawGait(const gait::CrawlGait& gait, const gait::JointTable& motion);

/// NAO going the motion, seen from its side, as an HTML page that needs nothing else: it plays, pauses, and
/// can be dragged through time. The robot lies where gravity lays it (gait/rest.hpp), starting at a pitch
/// [rad]: pi/2 is face down, 0 upright.
[[nodiscard]] std::string animateGait(const std::string& title, const gait::JointTable& motion,
                                      double pitch_rad);

}  // namespace underway
