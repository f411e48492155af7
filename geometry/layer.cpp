#include "geometry/layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/flatten.hpp"
#include "geometry/overlap_simd.hpp"

namespace underway {
namespace {

constexpr double kAnyHeight_m = 1e6;
constexpr std::size_t kFewChanges = 64;  // that make no tree worse

// The exact tests of shapes, for the pieces that need them.

class BodyCloser : public Closer {
 public:
  explicit BodyCloser(const Prism& body) : body_(body) {}
  bool touches(const Piece& piece) override { return areTouching(body_, piece); }

 private:
  const Prism& body_;
};

class TurningCloser : public Closer {
 public:
  explicit TurningCloser(const Turning& turning) : turning_(turning) {}
  bool touches(const Piece& piece) override {
    return withCorners(piece, [&](ConvexView corners) { return turning_.touches(corners); });
  }

 private:
  const Turning& turning_;
};

class DiscCloser : public Closer {
 public:
  DiscCloser(Point center, double radius_m) : center_(center), radius_m_(radius_m) {}
  bool touches(const Piece& piece) override {
    return withCorners(piece,
                       [&](ConvexView corners) { return !(distanceTo(corners, center_) > radius_m_); });
  }

 private:
  Point center_;
  double radius_m_;
};

/// Hands on what touches.
class VisitSieve : public Sieve {
 public:
  VisitSieve(Closer& closer, const Layer::Visit& visit) : closer_(closer), visit_(visit) {}
  bool keep(const Piece& piece, bool is_certain) override {
    return (is_certain || closer_.touches(piece)) && visit_(piece);
  }

 private:
  Closer& closer_;
  const Layer::Visit& visit_;
};

/// Takes the least room that any piece leaves.
class RoomSieve : public Sieve {
 public:
  RoomSieve(const Turning& all_round, TurningRoom& least) : all_round_(all_round), least_(least) {}
  bool keep(const Piece& piece, bool is_certain) override {
    const TurningRoom room =
        is_certain ? TurningRoom{}
                   : withCorners(piece, [&](ConvexView corners) { return all_round_.roomBeside(corners); });
    least_ = {std::min(least_.left_rad, room.left_rad), std::min(least_.right_rad, room.right_rad)};
    return least_.left_rad <= 0.0 && least_.right_rad <= 0.0;
  }

 private:
  const Turning& all_round_;
  TurningRoom& least_;
};

Ring ringOf(const Turning& turning) {
  return {turning.pivot(), turning.outerRadius(), turning.innerRadius()};
}

/// What ends flush with a slab touches it, however that rounds.
Range widened(Range slab) { return slab.grown(kFlush_m); }

/// An axis-aligned region of the map.
struct Region {
  double min_x, min_y, max_x, max_y;
};

Region regionAround(ConvexView points) {
  Region region{points[0].x, points[0].y, points[0].x, points[0].y};
  for (const Point p : points)
    region = {std::min(region.min_x, p.x), std::min(region.min_y, p.y), std::max(region.max_x, p.x),
              std::max(region.max_y, p.y)};
  return region;
}

/// No entry's pieces are nearer to a region than this, which is relative to the tree's origin too.
double leastGap(const Areas& areas, std::size_t i, const Region& region) {
  const auto apart = [](double a_min, double a_max, double b_min, double b_max) {
    return std::max({0.0, a_min - b_max, b_min - a_max});
  };
  const double x = apart(areas.min_x[i], areas.max_x[i], region.min_x, region.max_x);
  const double y = apart(areas.min_y[i], areas.max_y[i], region.min_y, region.max_y);
  return std::sqrt(x * x + y * y) - 2.0 * kContact_m;
}

/// Branch and bound over the tree, nearest entries first.
template <class GapTo>
class NearestSearch {
 public:
  NearestSearch(const Region& region, const GapTo& gap_to, double cap_m)
      : region_(region), gap_to_(gap_to), best_{nullptr, {cap_m, {}}} {}

  void visit(const Node& node) {
    std::array<std::pair<double, std::size_t>, kFan> order;
    const std::size_t count = node.count();
    for (std::size_t i = 0; i < count; ++i) order[i] = {leastGap(node.areas, i, region_), i};
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t k = 0; k < count; ++k) {
      const auto [least, i] = order[k];
      if (least > best_.gap.distance_m) return;
      if (node.isLeaf())
        consider(*static_cast<const Leaf&>(node).pieces[i]);
      else
        visit(*static_cast<const Branch&>(node).below[i]);
    }
  }

  [[nodiscard]] std::optional<Layer::Neighbour> result() const {
    return best_.piece != nullptr ? std::optional(best_) : std::nullopt;
  }

 private:
  void consider(const Piece& piece) {
    const bool is_tie_won = best_.piece != nullptr && piece.obstacle->id < best_.piece->obstacle->id;
    if (best_.gap.distance_m == 0.0 && !is_tie_won) return;  // nothing is nearer than touching
    const Gap gap = withCorners(piece, gap_to_);
    if (gap.distance_m < best_.gap.distance_m || (gap.distance_m == best_.gap.distance_m && is_tie_won))
      best_ = {&piece, gap};
  }

  Region region_;
  const GapTo& gap_to_;
  Layer::Neighbour best_;
};

template <class GapTo>
std::optional<Layer::Neighbour> nearestIn(const Tree& tree, const Region& region, const GapTo& gap_to,
                                          double cap_m) {
  if (!tree.root) return std::nullopt;
  const auto [x, y] = tree.origin;
  NearestSearch search({region.min_x - x, region.min_y - y, region.max_x - x, region.max_y - y}, gap_to,
                       cap_m);
  search.visit(*tree.root);
  return search.result();
}

}  // namespace

Layer::Layer(Question question, Range slab, const Obstacles& obstacles) : question_(question), slab_(slab) {
  std::vector<Piece> pieces;
  pieces.reserve(obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    if (auto piece = pieceFor(obstacles.pointer(i))) pieces.push_back(std::move(*piece));
  tree_ = treeOf(std::move(pieces));
}

Layer Layer::seenIn(Range slab, const Obstacles& obstacles) {
  return {Question::kSeen, widened(slab), obstacles};
}

Layer Layer::askedIn(Range slab) const { return {question_, widened(slab), tree_}; }

bool Layer::looksAlike(Range a, Range b, const Obstacles& obstacles) {
  return std::all_of(obstacles.begin(), obstacles.end(), [&](const Obstacle& obstacle) {
    const OrientedBox& box = obstacle.box;
    return isUpright(box) && reachesInto(box, widened(a)) == reachesInto(box, widened(b));
  });
}

Layer Layer::hangingAbove(double height_m, const Obstacles& obstacles) {
  return {Question::kHanging, {height_m, kAnyHeight_m}, obstacles};
}

std::optional<Piece> Layer::pieceFor(const Obstacles::Pointer& obstacle) const {
  const OrientedBox& box = obstacle->box;
  if (!isUpright(box)) {
    std::vector<Point> polygon = flattened(box, slab_);
    if (polygon.empty()) return std::nullopt;
    const Rectangle around = rectangleAround(polygon);
    return Piece{obstacle, around, std::move(polygon)};
  }
  const bool is_seen_already =
      question_ == Question::kHanging && box.center_m.z - 0.5 * box.size_m.z <= slab_.min + kFlush_m;
  if (is_seen_already || !reachesInto(box, slab_)) return std::nullopt;
  return Piece{obstacle, footprintOf(box), {}};
}

Layer Layer::changed(std::span<const Obstacles::Change> changes) const {
  Layer result = *this;
  for (const auto& [before, after] : changes) {
    if (before)
      if (const auto piece = pieceFor(before)) result.tree_ = without(result.tree_, *piece);
    if (after)
      if (auto piece = pieceFor(after))
        result.tree_ = with(result.tree_, std::make_shared<const Piece>(std::move(*piece)));
  }
  // Now and then the tree is loaded anew: the changes until then have paid for it.
  if (result.tree_.changes > result.tree_.pieces / 2 + kFewChanges) result.tree_ = renewed(result.tree_);
  return result;
}

bool Layer::touches(const Prism& body) const { return underway::touches(tree_, body); }

void Layer::touchEach(std::span<const Prism> bodies, std::span<char> touched) const {
  underway::touchEach(tree_, bodies, touched);
}

bool Layer::touches(const Turning& turning) const {
  TurningCloser closer(turning);
  return underway::touches(tree_, ringOf(turning), closer);
}

bool Layer::touches(Point center, double radius_m) const {
  DiscCloser closer(center, radius_m);
  return underway::touches(tree_, Ring{center, radius_m, radius_m}, closer);
}

TurningRoom Layer::turningRoom(const Prism& body) const {
  TurningRoom room{2.0 * std::numbers::pi, 2.0 * std::numbers::pi};
  const Turning all_round(body, 2.0 * std::numbers::pi);
  RoomSieve sieve(all_round, room);
  sift(tree_, ringOf(all_round), sieve);
  return room;
}

void Layer::visitTouched(const Prism& body, const Visit& visit) const {
  BodyCloser closer(body);
  VisitSieve sieve(closer, visit);
  sift(tree_, body, sieve);
}

void Layer::visitTouched(const Turning& turning, const Visit& visit) const {
  TurningCloser closer(turning);
  VisitSieve sieve(closer, visit);
  sift(tree_, ringOf(turning), sieve);
}

std::optional<Layer::Neighbour> Layer::nearest(const Prism& body, double cap_m) const {
  const auto footprint = body.footprint();
  return nearestIn(
      tree_, regionAround(footprint), [&](ConvexView piece) { return gapBetween(footprint, piece); }, cap_m);
}

std::optional<Layer::Neighbour> Layer::nearest(const Turning& turning, double cap_m) const {
  const Point pivot = turning.pivot();
  const double reach = turning.outerRadius();
  return nearestIn(
      tree_, Region{pivot.x - reach, pivot.y - reach, pivot.x + reach, pivot.y + reach},
      [&](ConvexView piece) { return turning.gapTo(piece); }, cap_m);
}

}  // namespace underway
