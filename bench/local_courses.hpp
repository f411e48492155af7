#pragma once

#include <filesystem>

#include "bench/local_loop.hpp"

namespace underway::bench {

/// The queries of maps/ that can be answered, of one map.
[[nodiscard]] Expected<std::vector<Course>> coursesOf(const std::filesystem::path& map, const Robot& robot);

/// The course with one to three boxes in its world that the map does not have. They cross the lidar's plane,
/// stand on or near the way of a plan, and leave start, goal and the lying stretch, which a lidar at the
/// waist cannot see, .15 m.
[[nodiscard]] Course withUnmappedBoxes(const Course& course, const Plan& plan,
                                       const std::shared_ptr<const Robot>& robot, std::uint64_t seed);
/// The same with one or two tables whose tops a standing robot does not fit under and the lidar's plane does
/// not meet.
[[nodiscard]] Course withUnmappedTables(const Course& course, const Plan& plan,
                                        const std::shared_ptr<const Robot>& robot, std::uint64_t seed);

/// A room halved by a wall with one gap, as wide as a mode's body and 6 cm (and twice what its drift widens
/// the sweep by); for a mode that is lower than standing a lintel hangs in it.
[[nodiscard]] Expected<Course> narrowCourse(const Robot& robot, ModeId mode);

}  // namespace underway::bench
