#include "planner/sites.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace underway {
namespace {

// A neighbour hidden behind a connected nearer one adds little: one connection in each cone of this
// half-angle.
constexpr double kCone_rad = 0.35;
// Where places crowd on the far side of a wall, the nearest ones lead nowhere: those after these are tried as
// well, if they belong to another part of the roadmap.
constexpr std::size_t kNeighbours = 14;
constexpr double kSamePlace_m = 1e-6;

}  // namespace

Sites::Sites(const Stances& stances, Draft& draft, Check check)
    : stances_(stances), draft_(draft), check_(check) {}

Sites::PlaceId Sites::add(ModeId mode, Point at, double keep_m) {
  return draft_.addPlace(stances_.groupOf(mode), at, keep_m);
}

Roadmap::Ways freeWays(const Legs& legs, Point from, Point to, double keep_m, const Roadmap::Ways* back) {
  const double direction = std::atan2(to.y - from.y, to.x - from.x);
  Roadmap::Ways known = 0;  // sweeps that have been looked at
  Roadmap::Ways free = 0;
  for (std::size_t w = 0; w < legs.ways().size(); ++w) {
    const std::size_t sweep = legs.sameSweep(w);
    bool is_free = false;
    if (back && legs.opposite(w))
      is_free = (*back >> *legs.opposite(w) & 1U) != 0;
    else if (back && legs.isSymmetric(w))
      is_free = (*back >> w & 1U) != 0;
    else if ((known >> sweep & 1U) != 0)
      is_free = (free >> sweep & 1U) != 0;
    else
      is_free = legs.isLegFree(legs.ways()[w], from, to, legs.stanceOn(direction, w).yaw, keep_m);
    known |= 1U << w;
    if (is_free) free |= 1U << w;
  }
  return free;
}

bool Sites::connect(PlaceId a, PlaceId b) {
  const Roadmap::Place& from = draft_.place(a);
  const Roadmap::Place& to = draft_.place(b);
  const Legs& legs = stances_.ofGroup(from.group);
  if (from.group != to.group || legs.ways().empty() || distance(from.at, to.at) < kSamePlace_m) return false;
  const Roadmap::Ways all = (1U << legs.ways().size()) - 1U;
  if (check_ == Check::kWhenUsed) {
    draft_.addLegs(a, b, {all, all}, {all, all}, false);
    return true;
  }
  const double keep_m = std::min(from.keep_m, to.keep_m);
  const Roadmap::Ways there = underway::freeWays(legs, from.at, to.at, keep_m, nullptr);
  const Roadmap::Ways back = underway::freeWays(legs, to.at, from.at, keep_m, &there);
  draft_.addLegs(a, b, {all, there}, {all, back}, true);
  return there != 0 || back != 0;
}

void Sites::connectAround(PlaceId place, std::span<const PlaceId> neighbours) {
  std::array<double, kNeighbours> taken{};
  std::size_t count = 0;
  std::size_t tried = 0;
  const Point from = draft_.place(place).at;
  for (const PlaceId neighbour : neighbours) {
    const Point to = draft_.place(neighbour).at;
    const double direction = std::atan2(to.y - from.y, to.x - from.x);
    const bool is_hidden =
        std::any_of(taken.begin(), taken.begin() + static_cast<std::ptrdiff_t>(count),
                    [&](double other) { return std::abs(normalizedAngle(other - direction)) < kCone_rad; });
    const bool is_needless = is_hidden || tried >= kNeighbours;
    if (is_needless && draft_.areJoined(place, neighbour)) continue;
    ++tried;
    if (connect(place, neighbour) && count < kNeighbours) taken[count++] = direction;
  }
}

}  // namespace underway
