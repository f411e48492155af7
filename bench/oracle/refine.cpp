#include "bench/oracle/refine.hpp"

#include <algorithm>
#include <cmath>

#include "bench/oracle/scatter.hpp"

namespace underway::bench {
namespace {

constexpr double kPointsApart_m = 0.2;    // in the first, unshifted pass
constexpr std::size_t kMostPoints = 160;  // looked at together in that pass
constexpr int kIdleRounds = 12;  // without gain that matters, after which the shifts get smaller at once

/// Legs [first, last) of a way, as a way of its own.
Way stretchOf(const Way& way, std::size_t first, std::size_t last) {
  return {{way.spots.begin() + static_cast<std::ptrdiff_t>(first),
           way.spots.begin() + static_cast<std::ptrdiff_t>(last) + 1},
          {way.legs.begin() + static_cast<std::ptrdiff_t>(first),
           way.legs.begin() + static_cast<std::ptrdiff_t>(last)},
          way.yawBefore(first),
          way.yawAfter(last)};
}

/// Puts a better stretch in the place of legs [first, last).
void replace(Way& way, std::size_t first, std::size_t last, const Way& better) {
  const auto spots = way.spots.begin();
  way.spots.erase(spots + static_cast<std::ptrdiff_t>(first), spots + static_cast<std::ptrdiff_t>(last) + 1);
  way.spots.insert(way.spots.begin() + static_cast<std::ptrdiff_t>(first), better.spots.begin(),
                   better.spots.end());
  const auto legs = way.legs.begin();
  way.legs.erase(legs + static_cast<std::ptrdiff_t>(first), legs + static_cast<std::ptrdiff_t>(last));
  way.legs.insert(way.legs.begin() + static_cast<std::ptrdiff_t>(first), better.legs.begin(),
                  better.legs.end());
}

class Refiner {
 public:
  Refiner(const Terrain& terrain, const RefineSettings& settings, Way way)
      : terrain_(terrain), settings_(settings), random_(settings.seed), way_(std::move(way)) {}

  Way run() {
    shortenByOwnPoints();
    const double decay =
        std::pow(settings_.last_shift_m / settings_.first_shift_m, 1.0 / std::max(1, settings_.rounds - 1));
    double shift_m = settings_.first_shift_m;
    for (int round = 0; round < settings_.rounds; ++round, shift_m *= decay)
      improveBy([&](const Way& stretch) { return scattered(terrain_, stretch, shift_m, random_); },
                settings_.window, round % 2 == 0 ? 0 : settings_.window / 2);
    return way_;
  }

 private:
  /// All of the way's points at once, or as many as may be.
  void shortenByOwnPoints() {
    std::size_t points = 0;
    for (const Leg& leg : way_.legs)
      points += 1 + static_cast<std::size_t>(length(leg.motions.front()) / kPointsApart_m);
    const std::size_t window =
        std::max<std::size_t>(2, way_.legs.size() * kMostPoints / std::max(kMostPoints, points));
    for (const std::size_t offset : {std::size_t{0}, window / 2})
      improveBy([&](const Way& stretch) { return ownPoints(stretch, kPointsApart_m); }, window, offset);
  }

  template <class ChoicesOf>
  void improveBy(const ChoicesOf& choices_of, std::size_t window, std::size_t offset) {
    // The first window is shorter by the offset, so that windows of the next round overlap these.
    for (std::size_t first = 0, size = offset > 0 ? offset : window; first < way_.legs.size();
         size = window) {
      const std::size_t last = std::min(first + size, way_.legs.size());
      const Way stretch = stretchOf(way_, first, last);
      const auto better = cheapest(terrain_, choices_of(stretch), costOf(terrain_, stretch));
      if (better) replace(way_, first, last, *better);
      first += better ? better->legs.size() : last - first;
    }
  }

  const Terrain& terrain_;
  const RefineSettings& settings_;
  std::mt19937_64 random_;
  Way way_;
};

}  // namespace

Route refined(const Terrain& terrain, const Request& request, const Route& route,
              const RefineSettings& settings) {
  const auto whole = [&](const Route& loose) {
    return chained(terrain.checker, terrain.keep, terrain.gaits, loose, request);
  };
  const Route own = whole(route);
  const auto way = wayOf(terrain.gaits, own, request);
  if (!way || way->legs.empty()) return own;
  const auto better = routeOf(terrain, Refiner(terrain, settings, *way).run());
  if (!better) return own;
  Route result = whole(*better);
  const bool is_cheaper =
      totalCost(terrain.robot(), terrain.policy, result) < totalCost(terrain.robot(), terrain.policy, own);
  return is_cheaper ? result : own;
}

}  // namespace underway::bench
