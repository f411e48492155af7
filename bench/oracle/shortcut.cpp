#include "bench/oracle/shortcut.hpp"

#include <algorithm>
#include <cmath>

namespace underway::bench {
namespace {

/// The cheapest way found to a spot by one last leg.
struct Label {
  Cost cost;
  double yaw = 0.0;        ///< it comes with
  std::size_t spot = 0;    ///< it stands for
  std::size_t before = 0;  ///< index of the label before
  Leg leg;
};

class Search {
 public:
  Search(const Terrain& terrain, const Choices& choices, Cost limit)
      : terrain_(terrain), choices_(choices), limit_(limit), into_(choices.spots.size()) {
    for (const Mode& mode : terrain.robot().modes)
      for (const double speed : mode.speed_mps) fastest_mps_ = std::max(fastest_mps_, speed);
  }

  std::optional<Way> run() {
    labels_.push_back({Cost(), choices_.start_yaw, 0, 0, {}});
    into_[0].push_back(0);
    for (std::size_t i = 0; i + 1 < choices_.spots.size(); ++i) leave(i);
    return arrive();
  }

 private:
  [[nodiscard]] const Spot& spot(std::size_t i) const { return choices_.spots[i]; }

  /// At least what is still to pay from a spot to the end.
  [[nodiscard]] Cost rest(std::size_t from) const {
    const double way_m = distance(spot(from).at, choices_.spots.back().at);
    return Cost::time(static_cast<std::uint64_t>(way_m / fastest_mps_ * 1e6));
  }

  void sortLabels(std::size_t i) {
    std::sort(into_[i].begin(), into_[i].end(),
              [&](std::size_t a, std::size_t b) { return labels_[a].cost < labels_[b].cost; });
  }

  void leave(std::size_t i) {
    if (into_[i].empty()) return;
    sortLabels(i);
    is_open_ = terrain_.gaits.all[spot(i).gait].turning &&
               terrain_.checker.isFreeAllRound(*terrain_.gaits.all[spot(i).gait].turning, spot(i).at,
                                               terrain_.keep.margin());
    for (std::size_t j = i + 1; j < choices_.spots.size(); ++j)
      if (spot(j).gait == spot(i).gait) leaveTo(i, j);
    for (const Choices::Bridge& bridge : choices_.bridges)
      if (bridge.from == i) add(i, bridge.to, bridge.leg);
  }

  void leaveTo(std::size_t i, std::size_t j) {
    const Point a = spot(i).at;
    const Point b = spot(j).at;
    if (distance(a, b) < 1e-9) return;
    const double direction = std::atan2(b.y - a.y, b.x - a.x);
    const Gait& gait = terrain_.gaits.all[spot(i).gait];
    for (const Sense sense : kSenses) {
      const auto mode = gait.mode(sense);
      if (!mode) continue;
      const double yaw = normalizedAngle(direction - angleOf(sense));
      const Motion motion = translate(*mode, sense, {a.x, a.y, yaw}, b);
      if (labels_[into_[i].front()].cost + terrain_.cost(motion) + rest(j) < limit_)
        add(i, j, {{motion}, yaw, yaw});
    }
  }

  void add(std::size_t i, std::size_t j, Leg leg) {
    Cost legs_cost;
    for (const Motion& motion : leg.motions) legs_cost = legs_cost + terrain_.cost(motion);
    const Cost after = legs_cost + rest(j);
    if (labels_[into_[i].front()].cost + after >= limit_) return;
    const auto before = turnedTo(i, leg.yaw_in, after);
    if (!before) return;
    if (!leg.isBridge() && !terrain_.keep.isFree(leg.motions.front())) return;
    into_[j].push_back(labels_.size());
    const double yaw_out = leg.yaw_out;
    labels_.push_back({before->cost + legs_cost, yaw_out, j, before->label, std::move(leg)});
  }

  struct Turned {
    Cost cost;
    std::size_t label = 0;
  };

  /// The cheapest way to stand on a spot with a heading, if with what comes `after` it stays below the limit.
  std::optional<Turned> turnedTo(std::size_t i, double yaw, Cost after) const {
    std::optional<Turned> best;
    for (const std::size_t l : into_[i]) {
      const Label& label = labels_[l];
      if ((best && label.cost >= best->cost) || label.cost + after >= limit_) break;
      const Cost cost = label.cost + turnCost(i, label.yaw, yaw);
      if ((best && cost >= best->cost) || cost + after >= limit_) continue;
      if (is_open_) {
        best = {cost, l};
        continue;
      }
      const auto turned = terrain_.freeTurn(spot(i), label.yaw, yaw);
      if (!turned) continue;
      const Cost real = turned->angle_rad == 0.0 ? label.cost : label.cost + terrain_.cost(*turned);
      if ((!best || real < best->cost) && real + after < limit_) best = {real, l};
    }
    return best;
  }

  /// Of the shorter way round.
  [[nodiscard]] Cost turnCost(std::size_t i, double from_yaw, double to_yaw) const {
    const double angle = normalizedAngle(to_yaw - from_yaw);
    const auto turning = terrain_.gaits.all[spot(i).gait].turning;
    if (std::abs(angle) < 1e-12 || !turning) return {};
    return terrain_.cost(turn(*turning, {}, angle, angle));
  }

  std::optional<Way> arrive() {
    const std::size_t last = choices_.spots.size() - 1;
    if (into_[last].empty()) return std::nullopt;
    sortLabels(last);
    is_open_ = false;
    const auto end = choices_.goal_yaw
                         ? turnedTo(last, *choices_.goal_yaw, Cost())
                         : std::optional(Turned{labels_[into_[last].front()].cost, into_[last].front()});
    if (!end || end->cost >= limit_) return std::nullopt;
    Way way{{}, {}, choices_.start_yaw, choices_.goal_yaw};
    for (std::size_t l = end->label; l != 0; l = labels_[l].before) {
      way.spots.push_back(spot(labels_[l].spot));
      way.legs.push_back(labels_[l].leg);
    }
    way.spots.push_back(spot(0));
    std::reverse(way.spots.begin(), way.spots.end());
    std::reverse(way.legs.begin(), way.legs.end());
    return way;
  }

  const Terrain& terrain_;
  const Choices& choices_;
  Cost limit_;
  double fastest_mps_ = 0.0;
  bool is_open_ = false;  // whether every turn is free at the spot that is being left
  std::vector<Label> labels_;
  std::vector<std::vector<std::size_t>> into_;  // labels by spot
};

}  // namespace

std::optional<Way> cheapest(const Terrain& terrain, const Choices& choices, Cost limit) {
  return Search(terrain, choices, limit).run();
}

}  // namespace underway::bench
