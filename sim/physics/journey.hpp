#pragma once

#include <filesystem>
#include <vector>

#include "gait/crawl/gait.hpp"
#include "sim/physics/conditions.hpp"
#include "sim/physics/crawl_line.hpp"

namespace underway::physics {

/// A table with four legs, across the way of a robot that stands at the origin and looks along x.
struct Table {
  double from_m = 0.75;   ///< where its front edge is [m]
  double depth_m = 1.0;   ///< along the way [m]
  double width_m = 0.8;   ///< between the legs [m]
  double clear_m = 0.22;  ///< below the top [m]
};

/// Top and legs.
[[nodiscard]] std::vector<OrientedBox> boxesOf(const Table& table);

/// From standing before a table to standing behind it.
struct Journey {
  Recording down;
  CrawledLine crawl;
  Recording up;
  Pose lying_after_down;          ///< in the frame of the standing robot
  Pose standing_after_up;         ///< in the frame of the robot as it lay
  Pose end;                       ///< standing, in the frame of the start
  bool stands = false;            ///< upright and at rest in the end
  std::set<std::string> touches;  ///< what touched the table
};

/// Goes down, crawls below the table with its heading kept from the IMU until the table is behind by what
/// getting up needs, and gets up. Errors: as of Simulation::make. Throws as crawlLine.
[[nodiscard]] Expected<Journey> crawlUnder(const std::filesystem::path& robot, const Table& table,
                                           const gait::CrawlGait& gait, const Conditions& conditions);

}  // namespace underway::physics
