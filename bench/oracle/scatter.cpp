#include "bench/oracle/scatter.hpp"

#include <algorithm>
#include <cmath>

#include "bench/oracle/bridge_shifts.hpp"

namespace underway::bench {
namespace {

constexpr int kClones = 2;   // of each point
constexpr int kCorners = 4;  // of each leg
constexpr int kShiftedBridges = 8;

Point between(Point a, Point b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// Where a body of one heading turns from one of its axes to the other on the way from a to b.
Point corner(Point a, Point b, double yaw) {
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  const double ahead = c * (b.x - a.x) + s * (b.y - a.y);
  return {a.x + ahead * c, a.y + ahead * s};
}

class Scatter {
 public:
  Scatter(const Terrain& terrain, const Way& way, double shift_m, std::mt19937_64& random)
      : terrain_(terrain), way_(way), shift_m_(shift_m), random_(random) {
    choices_.start_yaw = way.start_yaw;
    choices_.goal_yaw = way.goal_yaw;
  }

  Choices run() {
    for (std::size_t i = 0; i < way_.spots.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == way_.spots.size();
      if (!is_end) addClones(way_.spots[i]);
      choices_.spots.push_back(way_.spots[i]);
      if (i == way_.legs.size()) break;
      if (way_.legs[i].isBridge())
        addBridges(i);
      else
        addBetween(i);
    }
    return std::move(choices_);
  }

 private:
  double normal(double deviation) { return std::normal_distribution<double>(0.0, deviation)(random_); }
  double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  bool coin() { return uniform() < 0.5; }

  Point shifted(Point at) { return {at.x + normal(shift_m_), at.y + normal(shift_m_)}; }

  void addClones(const Spot& spot) {
    for (int k = 0; k < kClones; ++k) choices_.spots.push_back({shifted(spot.at), spot.gait});
  }

  void addBetween(std::size_t i) {
    const Spot& a = way_.spots[i];
    const Spot& b = way_.spots[i + 1];
    const Point middle = between(a.at, b.at, uniform());
    choices_.spots.push_back({middle, a.gait});
    choices_.spots.push_back({shifted(middle), a.gait});
    for (int k = 0; k < kCorners; ++k) addCorner(i);
  }

  /// A corner of the next one or two legs at a heading of a leg nearby, now and then turned a little.
  void addCorner(std::size_t i) {
    const Spot& a = way_.spots[i];
    const std::size_t last = std::min(i + (coin() ? 1 : 2), way_.spots.size() - 1);
    const Spot& b = way_.spots[last];
    if (a.gait != b.gait) return;
    double yaw = coin() ? way_.yawBefore(i) : way_.yawAfter(last).value_or(way_.yawBefore(last));
    if (uniform() < 0.2) yaw = way_.legs[i].yaw_in;
    if (uniform() < 0.3) yaw += normal(shift_m_);
    const Point from = coin() ? a.at : shifted(a.at);
    const Point to = coin() ? b.at : shifted(b.at);
    choices_.spots.push_back({coin() ? corner(from, to, yaw) : corner(to, from, yaw), a.gait});
  }

  /// The bridge itself and others like it. Their ends are places of their own.
  void addBridges(std::size_t i) {
    const bool is_first = i == 0;
    const bool is_last = i + 1 == way_.legs.size();
    const bool starts_on_rail = !terrain_.gaits.all[way_.spots[i].gait].turning;
    const bool ends_on_rail = !terrain_.gaits.all[way_.spots[i + 1].gait].turning;
    std::vector<Leg> legs;
    const BridgeShifts shifts(terrain_, is_first && starts_on_rail, is_last && ends_on_rail);
    for (int k = 0; k < kShiftedBridges; ++k) {
      std::optional<double> yaw;
      if (uniform() < 0.3) yaw = way_.yawBefore(i);
      if (uniform() < 0.3) yaw = way_.yawAfter(i + 1);
      if (auto leg = shifts.shifted(way_.legs[i], yaw, shift_m_, random_)) legs.push_back(std::move(*leg));
    }
    const std::size_t own = choices_.spots.size() - 1;
    const std::size_t first_entry = choices_.spots.size();
    if (!starts_on_rail)
      for (const Leg& leg : legs)
        choices_.spots.push_back({leg.motions.front().from.position(), way_.spots[i].gait});
    const std::size_t first_exit = choices_.spots.size();
    if (!ends_on_rail)
      for (const Leg& leg : legs)
        choices_.spots.push_back({leg.motions.back().to.position(), way_.spots[i + 1].gait});
    // The clones of the next spot come before it, so that its own index is known here.
    const std::size_t next = choices_.spots.size() + (is_last ? 0 : kClones);
    choices_.bridges.push_back({own, next, way_.legs[i]});
    for (std::size_t k = 0; k < legs.size(); ++k)
      choices_.bridges.push_back(
          {starts_on_rail ? own : first_entry + k, ends_on_rail ? next : first_exit + k, legs[k]});
  }

  const Terrain& terrain_;
  const Way& way_;
  double shift_m_;
  std::mt19937_64& random_;
  Choices choices_;
};

}  // namespace

Choices scattered(const Terrain& terrain, const Way& way, double shift_m, std::mt19937_64& random) {
  return Scatter(terrain, way, shift_m, random).run();
}

Choices ownPoints(const Way& way, double apart_m) {
  Choices choices{{}, {}, way.start_yaw, way.goal_yaw};
  for (std::size_t i = 0; i < way.spots.size(); ++i) {
    const Spot& a = way.spots[i];
    choices.spots.push_back(a);
    if (i == way.legs.size()) break;
    if (way.legs[i].isBridge()) {
      choices.bridges.push_back({choices.spots.size() - 1, choices.spots.size(), way.legs[i]});
      continue;
    }
    const Spot& b = way.spots[i + 1];
    const int pieces = 1 + static_cast<int>(distance(a.at, b.at) / apart_m);
    for (int k = 1; k < pieces; ++k)
      choices.spots.push_back({between(a.at, b.at, static_cast<double>(k) / pieces), a.gait});
  }
  return choices;
}

}  // namespace underway::bench
