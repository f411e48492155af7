#pragma once

#include <string>

#include "gait/crawl/gait.hpp"

namespace underway {

/// The thesis' figures of a gait as one SVG file: the free angles over the push beside the nominal ones (its
/// figure 67), the chain on its way (68), the joints over some cycles (73), the torques of the push in the
/// pseudo-static model beside the nominal ones, and how high and how stable the robot is.
[[nodiscard]] std::string drawGait(const gait::CrawlGait& gait, const gait::JointTable& cycles);

/// NAO crawling, seen from its side, as an HTML page that needs nothing else: it plays, pauses, and can be
/// dragged through time. The robot lies where gravity lays it (gait/rest.hpp).
[[nodiscard]] std::string animateGait(const std::string& title, const gait::JointTable& cycles);

}  // namespace underway
