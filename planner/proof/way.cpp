#include "planner/proof/way.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace underway::proof {
namespace {

using Place = Relaxation::Place;
using State = Outlook::State;
using Blockers = std::vector<std::size_t>;

constexpr double kClosed = std::numeric_limits<double>::infinity();

/// What passing costs: next to nothing where all is free, the more the smaller an undecided cell is. So
/// coarse cells are looked at first, and fine ones only where all coarse ones are closed.
class OpenCells {
 public:
  static constexpr bool kPassesClosedBySwitch = true;
  explicit OpenCells(const Relaxation& relaxation) : relaxation_(relaxation) {}

  double toBody(const Step& /*from*/, const Place& to) const { return cost(relaxation_.ofBody(to), to); }
  double toExit(const Place& at, std::uint32_t exit) const { return cost(relaxation_.ofExit(at, exit), at); }

 private:
  double cost(const Outlook& outlook, const Place& at) const {
    if (!outlook.isOpen()) return kClosed;
    const double extent = relaxation_.extentOf(at);
    return outlook.state == State::kFree ? 1e-3 * extent : 1.0 / (extent * extent);
  }
  const Relaxation& relaxation_;
};

/// Passing costs the obstacles that are in the way and were not in the way one cell before.
class FewestBlockers {
 public:
  static constexpr bool kPassesClosedBySwitch = false;
  FewestBlockers(Relaxation& relaxation, const Weight& weight) : relaxation_(relaxation), weight_(weight) {}

  double toBody(const Step& from, const Place& to) {
    const Outlook& outlook = relaxation_.ofBody(to);
    if (outlook.state != State::kBlocked) return cost(outlook, 0.0);
    return cost(outlook, weightOfNew(from, relaxation_.blockersOfBody(to)));
  }
  double toExit(const Place& at, std::uint32_t exit) {
    const Outlook& outlook = relaxation_.ofExit(at, exit);
    if (outlook.state != State::kBlocked) return cost(outlook, 0.0);
    const Step standing{at, std::nullopt};
    return cost(outlook, weightOfNew(standing, relaxation_.blockersOfExit(at, exit)));
  }

  Blockers blockersOf(const Step& step) {
    return step.exit ? relaxation_.blockersOfExit(step.place, *step.exit)
                     : relaxation_.blockersOfBody(step.place);
  }

 private:
  double weightOfNew(const Step& from, const Blockers& blockers) {
    const Blockers before = blockersOf(from);
    double sum = 0.0;
    for (const std::size_t b : blockers)
      if (!std::binary_search(before.begin(), before.end(), b)) sum += weight_(b);
    return sum;
  }
  static double cost(const Outlook& outlook, double blockers) {
    if (outlook.state == State::kOutside) return kClosed;
    constexpr double kFree = 1e-6, kUndecided = 1e-4, kBlocked = 1e-3;
    return blockers + (outlook.state == State::kFree        ? kFree
                       : outlook.state == State::kUndecided ? kUndecided
                                                            : kBlocked);
  }
  Relaxation& relaxation_;
  const Weight& weight_;
};

}  // namespace

template <class Costs>
class WaySearch::Run {
 public:
  Run(WaySearch& memory, const Relaxation& relaxation, Costs& costs, Interrupt& interrupt)
      : relaxation_(relaxation),
        costs_(costs),
        interrupt_(interrupt),
        known_(memory.known_),
        is_confined_(memory.is_confined_),
        is_within_(memory.is_within_),
        round_(++memory.round_) {
    known_.resize(relaxation.stances().all.size());
    for (std::size_t s = 0; s < known_.size(); ++s) known_[s].resize(relaxation.cells(s).size());
  }

  std::optional<Way> find() {
    for (const Place& start : relaxation_.starts()) reach(start, 0.0, {start, std::nullopt}, true);
    while (!open_.empty() && !interrupt_.isDue()) {
      const auto [cost, place] = open_.top();
      open_.pop();
      if (cost > costOf(place)) continue;
      if (relaxation_.isGoal(place)) return Way{wayTo(place), cost};
      expand(place, cost);
    }
    return std::nullopt;
  }

 private:
  struct Open {
    double cost;
    Place place;
    bool operator<(const Open& other) const { return cost > other.cost; }
  };

  [[nodiscard]] Known& known(const Place& place) { return known_[place.stance][place.cell]; }
  [[nodiscard]] double costOf(const Place& place) {
    return known(place).round == round_ ? known(place).cost : kClosed;
  }

  void reach(const Place& place, double cost, const Step& before, bool is_start = false) {
    if (!(cost < costOf(place)) || !mayPass(place)) return;
    known(place) = {cost, before, round_, is_start};
    open_.push({cost, place});
  }

  [[nodiscard]] bool mayPass(const Place& place) const {
    return !is_confined_ || is_within_[place.stance][place.cell] != 0;
  }

  void expand(const Place& place, double cost) {
    if (!Costs::kPassesClosedBySwitch || relaxation_.ofBody(place).isOpen()) walkFrom(place, cost);
    for (std::uint32_t exit = 0; exit < relaxation_.stance(place).exits.size(); ++exit) {
      const double through = cost + costs_.toExit(place, exit);
      if (through < kClosed) switchBy(place, exit, through);
    }
  }

  void walkFrom(const Place& place, double cost) {
    const Step walking{place, std::nullopt};
    for (const CellId next : relaxation_.cells(place.stance).neighbours(place.cell)) {
      const Place to{place.stance, next};
      if (!mayPass(to) || costOf(to) <= cost || !relaxation_.leadsTo(place, next)) continue;
      reach(to, cost + costs_.toBody(walking, to), walking);
    }
  }

  void switchBy(const Place& place, std::uint32_t exit, double cost) {
    const Step switching{place, exit};
    found_.clear();
    relaxation_.findBeyond(place, exit, found_);
    for (const CellId cell : found_) {
      const Place to{relaxation_.stance(place).exits[exit].to, cell};
      if (!mayPass(to) || costOf(to) <= cost) continue;
      const double more = costs_.toBody(switching, to);
      // A switch may lead on from where the body as it stands would touch.
      const bool leads_on = Costs::kPassesClosedBySwitch && more == kClosed;
      reach(to, leads_on ? cost : cost + more, switching);
    }
  }

  std::vector<Step> wayTo(const Place& goal) {
    std::vector<Step> way{{goal, std::nullopt}};
    for (Place at = goal; !known(at).is_start; at = way.back().place) way.push_back(known(at).before);
    std::reverse(way.begin(), way.end());
    return way;
  }

  const Relaxation& relaxation_;
  Costs& costs_;
  Interrupt& interrupt_;
  std::vector<std::vector<Known>>& known_;
  bool is_confined_;
  const std::vector<std::vector<char>>& is_within_;
  std::uint32_t round_;
  std::priority_queue<Open> open_;
  std::vector<CellId> found_;
};

void WaySearch::confineTo(const Relaxation& relaxation, const Way& way) {
  is_confined_ = true;
  is_within_.resize(relaxation.stances().all.size());
  for (std::size_t s = 0; s < is_within_.size(); ++s) is_within_[s].assign(relaxation.cells(s).size(), 0);
  for (const Step& step : way.steps) is_within_[step.place.stance][step.place.cell] = 1;
}

void WaySearch::letBeside(const Relaxation& relaxation, const Way& way) {
  for (const Step& step : way.steps) {
    const auto& [stance, cell] = step.place;
    if (relaxation.ofBody(step.place).state != State::kUndecided) continue;
    for (const CellId next : relaxation.cells(stance).neighbours(cell)) is_within_[stance][next] = 1;
  }
}

void WaySearch::noteHalves(const Relaxation::Place& lower, CellId upper) {
  std::vector<char>& is_within = is_within_[lower.stance];
  is_within.resize(upper + 1, 0);
  is_within[upper] = is_within[lower.cell];
}

std::optional<Way> WaySearch::throughOpenCells(const Relaxation& relaxation, Interrupt& interrupt) {
  OpenCells costs(relaxation);
  return Run<OpenCells>(*this, relaxation, costs, interrupt).find();
}

std::optional<std::vector<std::size_t>> WaySearch::fewestBlockers(Relaxation& relaxation,
                                                                  const Weight& weight,
                                                                  Interrupt& interrupt) {
  FewestBlockers costs(relaxation, weight);
  const auto way = Run<FewestBlockers>(*this, relaxation, costs, interrupt).find();
  if (!way) return std::nullopt;
  Blockers all;
  const auto add = [&](const Blockers& some) { all.insert(all.end(), some.begin(), some.end()); };
  for (const Step& step : way->steps) {
    add(relaxation.blockersOfBody(step.place));
    if (step.exit) add(relaxation.blockersOfExit(step.place, *step.exit));
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace underway::proof
