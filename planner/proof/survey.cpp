#include "planner/proof/survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace underway::proof {
namespace {

constexpr double kSure_m = 2e-9;  // above rounding, and what the checker calls touching
constexpr double kSure_rad = 1e-9;
constexpr std::size_t kRoomForLists = std::size_t{1} << 22;
constexpr double kRevolution = 2.0 * std::numbers::pi;

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }

Units unitsDown(double value) {
  constexpr double kFar = 4.0 * kWholeAxis;
  return static_cast<Units>(std::clamp(std::floor(value) - 1.0, -kFar, kFar));
}
Units unitsUp(double value) { return -unitsDown(-value); }

/// The furthest any of the shapes is from its frame's origin [m].
double reachOf(const std::vector<Shape>& shapes) {
  double reach = 0.0;
  for (const Shape& shape : shapes) {
    const auto [x, y, margin] = shape.footprint;
    reach = std::max(reach, std::hypot(std::max(-x.min, x.max), std::max(-y.min, y.max)));
  }
  return reach;
}

template <class Visit>
void forEachPiece(const Node& node, const Visit& visit) {
  for (std::size_t i = 0; i < node.count(); ++i) {
    if (node.isLeaf())
      visit(*static_cast<const Leaf&>(node).pieces[i]);
    else
      forEachPiece(*static_cast<const Branch&>(node).below[i], visit);
  }
}

}  // namespace

Grid::Extent Grid::extentOf(const CellBox& box) const {
  const auto middle = [](UnitRange r) { return 0.5 * (static_cast<double>(r.low) + r.high); };
  const auto half = [](UnitRange r) { return 0.5 * (static_cast<double>(r.high) - r.low); };
  return {{least.x + middle(box[kX]) * x_m, least.y + middle(box[kY]) * y_m, middle(box[kYaw]) * yaw_rad},
          half(box[kX]) * x_m + kSure_m,
          half(box[kY]) * y_m + kSure_m,
          half(box[kYaw]) * yaw_rad + kSure_rad};
}

CellBox Grid::boxAround(Range x, Range y, Range yaw) const {
  const auto units = [](Range range, double from, double unit) {
    return UnitRange{unitsDown((range.min - from) / unit), unitsUp((range.max - from) / unit)};
  };
  return {units(x, least.x, x_m), units(y, least.y, y_m), units(yaw, 0.0, yaw_rad)};
}

Pose Grid::inCorner(const Pose& map) const {
  const double c = std::cos(corner.yaw);
  const double s = std::sin(corner.yaw);
  const double dx = map.x - corner.x;
  const double dy = map.y - corner.y;
  const double yaw = std::fmod(map.yaw - corner.yaw, kRevolution);
  return {c * dx + s * dy, c * dy - s * dx, yaw < 0.0 ? yaw + kRevolution : yaw};
}

Grid gridOver(const Bounds& bounds, const std::vector<Shape>& shapes) {
  const double reach = reachOf(shapes) + 0.01;
  return {bounds.corner,
          {-reach, -reach},
          (bounds.width_m + 2.0 * reach) / kWholeAxis,
          (bounds.height_m + 2.0 * reach) / kWholeAxis,
          kRevolution / kWholeAxis};
}

void Survey::Patches::add(std::size_t shape, const Outline& outline, Point center, std::size_t obstacle) {
  const auto end = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
  Patch patch{end(corners), end(outline.corners), end(normals), end(outline.normals), obstacle, center, 0.0};
  for (const Point p : outline.corners) patch.radius_m = std::max(patch.radius_m, distance(center, p));
  corners.insert(corners.end(), outline.corners.begin(), outline.corners.end());
  normals.insert(normals.end(), outline.normals.begin(), outline.normals.end());
  offsets.insert(offsets.end(), outline.offsets.begin(), outline.offsets.end());
  of_shape[shape].push_back(patch);
}

double Survey::Patches::reach(const Patch& patch, Point direction) const {
  double reach = -std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < patch.corners; ++i)
    reach = std::max(reach, dot(direction, corners[patch.first_corner + i]));
  return reach;
}

Survey::Survey(const Checker& checker, const Stances& stances, Interrupt& interrupt)
    : grid_(gridOver(checker.world().bounds(), stances.shapes)),
      width_m_(checker.world().bounds().width_m),
      height_m_(checker.world().bounds().height_m),
      is_lifted_(stances.shapes.size(), std::vector<char>(checker.world().obstacles().size(), 0)) {
  const Obstacles& obstacles = checker.world().obstacles();
  const auto patches = std::make_shared<Patches>();
  patches->of_shape.resize(stances.shapes.size());
  for (std::size_t shape = 0; shape < stances.shapes.size(); ++shape) {
    footprints_.push_back(stances.shapes[shape].footprint);
    const Tree& tree = stances.shapes[shape].seen->tree();
    if (!tree.root) continue;
    forEachPiece(*tree.root, [&](const Piece& piece) {
      if (interrupt.isDue()) return;
      std::vector<Point> corners;
      withCorners(piece, [&](ConvexView view) {
        for (const Point p : view) corners.push_back(grid_.inCorner({p.x, p.y, 0.0}).position());
      });
      const Point center = grid_.inCorner({piece.around.center.x, piece.around.center.y, 0.0}).position();
      patches->add(shape, outlineOf(std::move(corners)), center, *obstacles.find(piece.obstacle->id));
    });
  }
  patches_ = patches;
  listed_.reserve(kRoomForLists);  // costs nothing until it is used, and saves copying late in a proof
}

const Core& Survey::coreFor(std::size_t shape, UnitRange yaw, const Extent& extent) {
  const std::uint64_t key = (static_cast<std::uint64_t>(shape) << 50) |
                            (static_cast<std::uint64_t>(yaw.low) << 25) |
                            static_cast<std::uint64_t>(yaw.high);
  const auto [at, is_new] = core_at_.try_emplace(key, static_cast<std::uint32_t>(cores_.size()));
  if (is_new) cores_.push_back(coreOf(footprints_[shape], extent.middle.yaw, extent.yaw_rad));
  return cores_[at->second];
}

/// Some line parts them, at every pose of the cell.
bool Survey::areApart(const Core& core, const Extent& extent, const Patch& patch) const {
  const Point to{patch.center.x - extent.middle.x, patch.center.y - extent.middle.y};
  const double reach = patch.radius_m + core.radius_m + extent.x_m + extent.y_m + kSure_m;
  if (dot(to, to) > reach * reach) return true;
  const Point at = extent.middle.position();
  const auto extent_along = [&](Point u) {
    return std::abs(u.x) * extent.x_m + std::abs(u.y) * extent.y_m + kSure_m;
  };
  const auto reach_of = [](const std::vector<Point>& points, Point u) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Point p : points) most = std::max(most, dot(p, u));
    return most;
  };
  for (std::uint32_t i = patch.first_edge; i < patch.first_edge + patch.edges; ++i) {
    const Point n = patches_->normals[i];
    const Point back{-n.x, -n.y};
    if (dot(n, at) - extent_along(n) - reach_of(core.all, back) > patches_->offsets[i]) return true;
  }
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = extent.middle.yaw + 0.5 * std::numbers::pi * quarter;
    const Point n{std::cos(angle), std::sin(angle)};
    const Point back{-n.x, -n.y};
    if (dot(n, at) + extent_along(n) + reach_of(core.all, n) < -patches_->reach(patch, back)) return true;
  }
  return false;
}

/// The poses at which what is common to all headings touches a patch are a convex set: patch minus core, in
/// the sense of Minkowski. Its edges are those of the two; the cell is in it if no edge cuts the cell.
Survey::Fit Survey::fitOf(const Core& core, const Extent& extent, const Patch& patch) const {
  if (core.common.corners.empty()) return {-std::numeric_limits<double>::infinity(), {1.0, 0.0}};
  Fit fit{std::numeric_limits<double>::infinity(), {1.0, 0.0}};
  const Point at = extent.middle.position();
  const auto consider = [&](Point u, double reach) {
    const double slack =
        reach - dot(u, at) - std::abs(u.x) * extent.x_m - std::abs(u.y) * extent.y_m - kSure_m;
    if (slack < fit.slack_m) fit = {slack, u};
  };
  for (std::uint32_t i = patch.first_edge; i < patch.first_edge + patch.edges; ++i) {
    const Point n = patches_->normals[i];
    consider(n, patches_->offsets[i] + core.common.reach({-n.x, -n.y}));
  }
  for (std::size_t i = 0; i < core.common.normals.size(); ++i) {
    const Point n = core.common.normals[i];
    const Point back{-n.x, -n.y};
    consider(back, core.common.offsets[i] + patches_->reach(patch, back));
  }
  return fit;
}

/// What a cell's extents, and its headings, cost of the fit in a direction.
std::array<double, 3> Survey::costs(const Core& core, const Extent& extent, Point direction) {
  const Point back{-direction.x, -direction.y};
  double whole = 0.0;
  for (const Point p : core.middle) whole = std::max(whole, dot(p, back));
  // Where nothing is common to all headings, they are to blame.
  const double of_yaw = core.common.corners.empty() ? whole : whole - core.common.reach(back);
  return {std::abs(direction.x) * extent.x_m, std::abs(direction.y) * extent.y_m, of_yaw};
}

/// The one to halve: where the middle of the cell is blocked, that which costs most of being blocked all
/// over, unless one costs ten times as much of being blocked by something else; where it is free, that which
/// costs most of all.
std::uint8_t Survey::axisToHalve(const Core& core, const Extent& extent, std::span<const Fit> fits) {
  constexpr double kOfOthers = 0.1;
  std::array<double, 3> score{};
  for (const Fit& fit : fits) {
    const auto cost = costs(core, extent, fit.worst);
    for (std::size_t axis = 0; axis < 3; ++axis) score[axis] = std::max(score[axis], kOfOthers * cost[axis]);
  }
  const Fit& best = *std::max_element(fits.begin(), fits.end(),
                                      [](const Fit& a, const Fit& b) { return a.slack_m < b.slack_m; });
  const auto cost = costs(core, extent, best.worst);
  if (best.slack_m + cost[kX] + cost[kY] + cost[kYaw] > 0.0)
    for (std::size_t axis = 0; axis < 3; ++axis) score[axis] += cost[axis];
  return static_cast<std::uint8_t>(std::max_element(score.begin(), score.end()) - score.begin());
}

/// The same for what is beyond the bounds: by each side that some pose of the cell may stick out of.
void Survey::addFitsOfBounds(const Core& core, const Extent& extent, std::vector<Fit>& fits) const {
  static constexpr std::array<Point, 4> kInwards{Point{-1, 0}, Point{0, -1}, Point{1, 0}, Point{0, 1}};
  const auto [x, y] = extent.middle.position();
  const std::array<double, 4> beyond{x - width_m_, y - height_m_, -x, -y};  // the origin, at the middle
  const std::array<double, 4> reach{extent.x_m, extent.y_m, extent.x_m, extent.y_m};
  for (std::size_t side = 0; side < 4; ++side)
    if (beyond[side] + reach[side] + core.most[side] > 0.0)
      fits.push_back({beyond[side] - reach[side] + core.least[side], kInwards[side]});
}

template <class Candidates>
Outlook Survey::lookAmong(std::size_t shape, const CellBox& box, std::size_t count,
                          const Candidates& candidate, Interrupt& interrupt) {
  Outlook outlook;
  if (interrupt.isDue()) return outlook;
  const Extent extent = grid_.extentOf(box);
  const Core& core = coreFor(shape, box[kYaw], extent);
  outlook.first = static_cast<std::uint32_t>(listed_.size());
  std::vector<Fit>& fits = fits_;
  fits.clear();
  addFitsOfBounds(core, extent, fits);
  const auto is_sure = [](const Fit& fit) { return fit.slack_m > kSure_m; };
  if (std::any_of(fits.begin(), fits.end(), is_sure)) {
    outlook.state = Outlook::State::kOutside;
    return outlook;
  }
  bool is_blocked = false;
  for (std::size_t i = 0; i < count && !interrupt.isDue(); ++i) {
    const std::uint32_t index = candidate(i);
    const Patch& patch = patches_->of_shape[shape][index];
    if (isLifted(shape, patch) || areApart(core, extent, patch)) continue;
    listed_.push_back(index);
    fits.push_back(fitOf(core, extent, patch));
    is_blocked = is_blocked || fits.back().slack_m > 0.0;
  }
  outlook.count = static_cast<std::uint32_t>(listed_.size()) - outlook.first;
  if (is_blocked)
    outlook.state = Outlook::State::kBlocked;
  else if (!fits.empty())
    outlook.axis = axisToHalve(core, extent, fits);
  else if (!interrupt.isDue())
    outlook.state = Outlook::State::kFree;
  return outlook;
}

Outlook Survey::look(std::size_t shape, const CellBox& box, Interrupt& interrupt) {
  return lookAmong(
      shape, box, patches_->of_shape[shape].size(),
      [](std::size_t i) { return static_cast<std::uint32_t>(i); }, interrupt);
}

Outlook Survey::lookAgain(std::size_t shape, const CellBox& box, const Outlook& before,
                          Interrupt& interrupt) {
  return lookAmong(
      shape, box, before.count, [&](std::size_t i) { return listed_[before.first + i]; }, interrupt);
}

bool Survey::mayTouchLifted(std::size_t shape, const Outlook& outlook) const {
  const auto begin = listed_.begin() + outlook.first;
  return std::any_of(begin, begin + outlook.count,
                     [&](std::uint32_t index) { return isLifted(shape, patches_->of_shape[shape][index]); });
}

std::vector<std::size_t> Survey::blockersOf(std::size_t shape, const CellBox& box, const Outlook& outlook) {
  std::vector<std::size_t> blockers;
  const Extent extent = grid_.extentOf(box);
  const Core& core = coreFor(shape, box[kYaw], extent);
  for (std::uint32_t i = 0; i < outlook.count; ++i) {
    const Patch& patch = patches_->of_shape[shape][listed_[outlook.first + i]];
    if (!isLifted(shape, patch) && fitOf(core, extent, patch).slack_m > 0.0)
      blockers.push_back(patch.obstacle);
  }
  std::sort(blockers.begin(), blockers.end());
  blockers.erase(std::unique(blockers.begin(), blockers.end()), blockers.end());
  return blockers;
}

}  // namespace underway::proof
