#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "planner/interrupt.hpp"
#include "planner/proof/cell_tree.hpp"
#include "planner/proof/core.hpp"
#include "planner/proof/stances.hpp"

namespace underway::proof {

/// From a cell's whole numbers to poses in the frame of the bounds' corner, and back.
struct Grid {
  Pose corner;       ///< of the bounds, in the map frame
  Point least;       ///< where the axes begin, in the corner's frame [m]
  double x_m = 0.0;  ///< a unit [m]
  double y_m = 0.0;  ///< a unit [m]
  double yaw_rad = 0.0;

  /// A cell as a middle and what it reaches to either side, a hair more than it does.
  struct Extent {
    Pose middle;
    double x_m;
    double y_m;
    double yaw_rad;
  };
  [[nodiscard]] Extent extentOf(const CellBox& box) const;
  /// The cells' box round some poses of the corner's frame, at least a unit more to all sides.
  [[nodiscard]] CellBox boxAround(Range x, Range y, Range yaw) const;
  /// A pose of the map frame in the corner's.
  [[nodiscard]] Pose inCorner(const Pose& map) const;
};
/// Holds every pose at which one of the shapes is inside the bounds.
[[nodiscard]] Grid gridOver(const Bounds& bounds, const std::vector<Shape>& shapes);

/// What is known about a shape at all poses of a cell.
struct Outlook {
  enum class State : std::uint8_t {
    kUndecided,
    kFree,     ///< it touches nothing at any of them
    kBlocked,  ///< one obstacle touches it at all of them
    kOutside,  ///< it sticks out of the bounds at all of them
  };
  State state = State::kUndecided;
  std::uint8_t axis = 0;    ///< the one to halve, if undecided: that which costs most
  std::uint32_t first = 0;  ///< of the pieces that may touch it, in the survey's list
  std::uint32_t count = 0;
  [[nodiscard]] bool isOpen() const { return state == State::kUndecided || state == State::kFree; }
};

/// Tells how shapes and cells lie to what the robot's modes see. Answers are certain; what is nearer to being
/// otherwise than 2 nm counts as undecided.
class Survey {
 public:
  Survey(const Checker& checker, const Stances& stances, Interrupt& interrupt);

  [[nodiscard]] const Grid& grid() const { return grid_; }

  /// Of a shape in a cell, among all pieces.
  [[nodiscard]] Outlook look(std::size_t shape, const CellBox& box, Interrupt& interrupt);
  /// Of a part of a cell, or of a cell anew.
  [[nodiscard]] Outlook lookAgain(std::size_t shape, const CellBox& box, const Outlook& before,
                                  Interrupt& interrupt);

  /// From now on as if an obstacle were not there for a shape. What has been looked at must be looked at
  /// again.
  void lift(std::size_t shape, std::size_t obstacle) { is_lifted_[shape][obstacle] = 1; }
  [[nodiscard]] bool mayTouchLifted(std::size_t shape, const Outlook& outlook) const;

  /// The obstacles, as indices into the world's, of which each alone blocks a shape in a cell.
  [[nodiscard]] std::vector<std::size_t> blockersOf(std::size_t shape, const CellBox& box,
                                                    const Outlook& outlook);

 private:
  /// A piece of floor that a shape must not touch, in the corner's frame.
  struct Patch {
    std::uint32_t first_corner;  // in Patches' lists
    std::uint32_t corners;
    std::uint32_t first_edge;
    std::uint32_t edges;
    std::size_t obstacle;
    Point center;
    double radius_m;
  };
  /// All of them, in few lists, and shared by copies: so that it is quick to copy and to destroy.
  struct Patches {
    std::vector<std::vector<Patch>> of_shape;
    std::vector<Point> corners;
    std::vector<Point> normals;   // of the edges
    std::vector<double> offsets;  // of the edges

    void add(std::size_t shape, const Outline& outline, Point center, std::size_t obstacle);
    [[nodiscard]] double reach(const Patch& patch, Point direction) const;
  };
  struct Fit {  // how far a cell is from being blocked by a patch: blocked if slack_m > 0
    double slack_m;
    Point worst;  // the direction in which it is furthest from it
  };
  using Extent = Grid::Extent;

  [[nodiscard]] bool isLifted(std::size_t shape, const Patch& patch) const {
    return is_lifted_[shape][patch.obstacle] != 0;
  }

  [[nodiscard]] const Core& coreFor(std::size_t shape, UnitRange yaw, const Extent& extent);
  [[nodiscard]] bool areApart(const Core& core, const Extent& extent, const Patch& patch) const;
  [[nodiscard]] Fit fitOf(const Core& core, const Extent& extent, const Patch& patch) const;
  [[nodiscard]] static std::array<double, 3> costs(const Core& core, const Extent& extent, Point direction);
  [[nodiscard]] static std::uint8_t axisToHalve(const Core& core, const Extent& extent,
                                                std::span<const Fit> fits);
  void addFitsOfBounds(const Core& core, const Extent& extent, std::vector<Fit>& fits) const;
  template <class Candidates>
  Outlook lookAmong(std::size_t shape, const CellBox& box, std::size_t count, const Candidates& candidate,
                    Interrupt& interrupt);

  Grid grid_;
  double width_m_;  // of the bounds
  double height_m_;
  std::vector<Footprint> footprints_;  // by shape
  std::shared_ptr<const Patches> patches_;
  std::vector<std::vector<char>> is_lifted_;  // by obstacle
  std::vector<std::uint32_t> listed_;         // candidates of all outlooks: indices into patches_[shape]
  std::vector<Fit> fits_;                     // of one look; kept, so that looking allocates little
  std::deque<Core> cores_;
  std::unordered_map<std::uint64_t, std::uint32_t> core_at_;
};

}  // namespace underway::proof
