#include "planner/search.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "planner/guide.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

/// A pose in a mode on a roadmap: where a link's way leads to.
struct Posed {
  Roadmap::PlaceId place;
  Stance stance;
};

/// All that can be reached and what it costs, by relaxing every way on until nothing changes: slow and
/// obvious.
class Relaxed {
 public:
  Relaxed(const Checker& checker, const Roadmap& roadmap, const Stances& stances, const Posed& start)
      : roadmap_(roadmap), stances_(stances) {
    for (Roadmap::LinkId id = 0; id < roadmap.links.size(); ++id)
      for (std::size_t way = 0; roadmap.ways[id] >> way != 0; ++way)
        if ((roadmap.ways[id] >> way & 1U) != 0) states_.push_back({id, way, Cost::most()});
    for (State& state : states_) state.cost = costFrom(start, Cost(), state);
    for (bool changed = true; changed;) {
      changed = false;
      for (const State& from : states_) {
        if (from.cost == Cost::most()) continue;
        for (State& to : states_) {
          if (roadmap.links[to.link].from != roadmap.links[from.link].to) continue;
          const Cost cost = costFrom({roadmap.links[from.link].to, exitOf(from)}, from.cost, to);
          if (cost < to.cost) to.cost = cost, changed = true;
        }
      }
    }
    static_cast<void>(checker);
  }

  [[nodiscard]] Cost costTo(const Posed& goal) const {
    Cost least = Cost::most();
    const Roadmap::Place& place = roadmap_.places[goal.place];
    for (const State& state : states_) {
      if (roadmap_.links[state.link].to != goal.place || state.cost == Cost::most()) continue;
      const Cost change =
          stances_.ofGroup(place.group).freeChangeCost(place.at, exitOf(state), goal.stance, place.keep_m);
      least = std::min(least, state.cost + change);
    }
    return least;
  }

 private:
  struct State {
    Roadmap::LinkId link;
    std::size_t way;
    Cost cost;
  };

  [[nodiscard]] Stance exitOf(const State& state) const {
    const Roadmap::Link& link = roadmap_.links[state.link];
    if (link.crossing == Roadmap::kNone)
      return stances_.ofGroup(roadmap_.places[link.from].group).stanceOn(link.direction_rad, state.way);
    const Crossing& crossing = roadmap_.crossings[link.crossing];
    return {crossing.exit().yaw, crossing.exitMode()};
  }

  [[nodiscard]] Cost costFrom(const Posed& here, Cost so_far, const State& next) const {
    const Roadmap::Link& link = roadmap_.links[next.link];
    if (link.from != here.place) return Cost::most();
    const Roadmap::Place& place = roadmap_.places[here.place];
    const Legs& legs = stances_.ofGroup(place.group);
    if (link.crossing != Roadmap::kNone) {
      const Crossing& crossing = roadmap_.crossings[link.crossing];
      const Stance entry{crossing.entry().yaw, crossing.entryMode()};
      return so_far + legs.freeChangeCost(place.at, here.stance, entry, place.keep_m) +
             crossing.cost(stances_.policy());
    }
    const Stance on_leg = legs.stanceOn(link.direction_rad, next.way);
    return so_far + legs.freeChangeCost(place.at, here.stance, on_leg, place.keep_m) +
           legs.legCost(legs.ways()[next.way], link.length_m);
  }

  const Roadmap& roadmap_;
  const Stances& stances_;
  std::vector<State> states_;
};

class SearchIn : public ::testing::TestWithParam<const char*> {
 protected:
  std::shared_ptr<const Checker> shared =
      std::make_shared<const Checker>(test::ourWorld(GetParam()), test::nao());
  const Checker& checker = *shared;
  Roadmap roadmap = test::grown(shared, 5, 2);
};

TEST_P(SearchIn, CostsWhatRelaxingEveryWayFinds) {
  const Draft graph(&roadmap);
  Interrupt never(test::soon(), {});
  for (const Policy policy : {Policy::kPriority, Policy::kFastest}) {
    const Stances stances(checker, policy);
    LinkChecks checks(graph, checker);
    const Posed start{0, {0.3, 0}};
    const Relaxed slow(checker, roadmap, stances, start);
    for (Roadmap::PlaceId place = 1; place < roadmap.places.size(); place += 7) {
      const Posed goal{place, {-1.1, 0}};
      const Target target{start.place, start.stance, {{place, goal.stance}}};
      const auto dut = search(graph, stances, *test::nao(), checks, target, never);
      const Cost least = slow.costTo(goal);
      ASSERT_EQ(dut.has_value(), least != Cost::most()) << "place " << place;
      // Turns near contact may be told apart by 1e-7 rad; the order of sums is the same.
      if (!dut) continue;
      ASSERT_EQ(dut->cost, least) << "place " << place;
    }
  }
}

TEST_P(SearchIn, IsGuidedByABoundThatIsConsistentOnEveryLink) {
  const Draft graph(&roadmap);
  for (const Policy policy : {Policy::kPriority, Policy::kFastest}) {
    const Stances stances(checker, policy);
    Interrupt never(test::soon(), {});
    const std::vector<Roadmap::PlaceId> goals{1, static_cast<Roadmap::PlaceId>(roadmap.places.size() / 2)};
    Guide guide(graph, stances, 0, goals, never);
    for (const Roadmap::PlaceId goal : goals) ASSERT_EQ(guide.from(goal), Cost());
    for (Roadmap::LinkId id = 0; id < roadmap.links.size(); ++id) {
      const Roadmap::Link& link = roadmap.links[id];
      const Legs& legs = stances.ofGroup(roadmap.places[link.from].group);
      for (std::size_t way = 0; roadmap.ways[id] >> way != 0; ++way) {
        if ((roadmap.ways[id] >> way & 1U) == 0) continue;
        const Cost step = link.crossing == Roadmap::kNone ? legs.legCost(legs.ways()[way], link.length_m)
                                                          : roadmap.crossings[link.crossing].cost(policy);
        ASSERT_LE(guide.from(link.from), step + guide.from(link.to));
      }
    }
  }
}

TEST_P(SearchIn, IsGuidedByABoundThatIsNeverTooHighHoweverLittleOfItIsWorkedOut) {
  std::mt19937 random(5);
  const Draft graph(&roadmap);
  Interrupt never(test::soon(), {});
  for (const Policy policy : {Policy::kPriority, Policy::kFastest}) {
    const Stances stances(checker, policy);
    const std::vector<Roadmap::PlaceId> goals{static_cast<Roadmap::PlaceId>(roadmap.places.size() / 2)};
    Guide all(graph, stances, 0, goals, never);
    Guide dut(graph, stances, 0, goals, never);
    for (int i = 0; i < 300; ++i) {
      const auto place = static_cast<Roadmap::PlaceId>(random() % roadmap.places.size());
      const Cost exact = all.from(place);
      ASSERT_LE(dut.atLeastFrom(place), exact);
      const Cost enough = Cost::time(random() % 100'000'000);
      const Cost told = dut.from(place, enough);
      ASSERT_LE(told, exact);
      ASSERT_TRUE(told == exact || told > enough) << "case " << i;
    }
  }
}

/// Each search with and without a bound: with one it leads to what costs less, or to nothing.
TEST_P(SearchIn, CostsWhatRelaxingEveryWayFindsFromRandomStartsAndUnderABound) {
  constexpr unsigned kSeed = 17;
  std::mt19937 random(kSeed);
  const auto place = [&] { return static_cast<Roadmap::PlaceId>(random() % roadmap.places.size()); };
  const auto stance = [&] { return Stance{0.1 * static_cast<double>(random() % 63) - 3.1, 0}; };
  const Draft graph(&roadmap);
  Interrupt never(test::soon(), {});
  for (int i = 0; i < 6; ++i) {
    const Stances stances(checker, i % 2 == 0 ? Policy::kPriority : Policy::kFastest);
    const Posed start{place(), stance()};
    const Relaxed slow(checker, roadmap, stances, start);
    LinkChecks checks(graph, checker);
    for (int j = 0; j < 60; ++j) {
      const Posed goal{place(), stance()};
      if (goal.place == start.place) continue;
      const Target target{start.place, start.stance, {{goal.place, goal.stance}}};
      const auto cost = [&](Cost below) {
        const auto dut = search(graph, stances, *test::nao(), checks, target, never, nullptr, below);
        return dut ? dut->cost : Cost::most();
      };
      const Cost least = slow.costTo(goal);
      ASSERT_EQ(cost(Cost::most()), least) << "seed " << kSeed << " start " << i << " goal " << j;
      ASSERT_EQ(cost(least), Cost::most()) << "seed " << kSeed << " start " << i << " goal " << j;
      ASSERT_EQ(cost(least + Cost::time(1)), least) << "seed " << kSeed << " start " << i << " goal " << j;
    }
  }
}

TEST_P(SearchIn, LeadsToTheCheapestOfSeveralGoals) {
  std::mt19937 random(11);
  const Draft graph(&roadmap);
  Interrupt never(test::soon(), {});
  for (const Policy policy : {Policy::kPriority, Policy::kFastest}) {
    const Stances stances(checker, policy);
    LinkChecks checks(graph, checker);
    for (int i = 0; i < 60; ++i) {
      Target target{0, {0.3, 0}, {}};
      for (auto left = 1 + random() % 6; left > 0; --left) {
        const auto place = static_cast<Roadmap::PlaceId>(random() % roadmap.places.size());
        target.goals.push_back({place, {0.1 * static_cast<double>(random() % 63), 0}, random() % 3 == 0});
      }
      Cost least = Cost::most();
      for (const Target::Goal& goal : target.goals)
        if (const auto alone = search(graph, stances, *test::nao(), checks,
                                      {target.start, target.start_stance, {goal}}, never))
          least = std::min(least, alone->cost);
      const auto dut = search(graph, stances, *test::nao(), checks, target, never);
      ASSERT_EQ(dut ? dut->cost : Cost::most(), least) << "case " << i;
      if (!dut) continue;
      const Target::Goal& goal = target.goals.at(dut->goal);
      const Passage::Step& last = dut->steps.back();
      ASSERT_EQ(last.option.in.position(), roadmap.places[goal.place].at);
      ASSERT_TRUE(goal.any_heading || last.option.in.yaw == goal.stance.yaw);
    }
  }
}

TEST_P(SearchIn, CostsNoLessWithLinksClosedAndNoMoreWithThemOpenAgain) {
  std::mt19937 random(3);
  const Stances stances(checker, Policy::kFastest);
  Interrupt never(test::soon(), {});
  Roadmap closed = roadmap;
  for (Roadmap::LinkId id = 0; id < closed.links.size(); ++id)
    if (random() % 6 == 0) closed.ways[id] = 0;
  const Draft before(&roadmap);
  const Draft after(&closed);
  LinkChecks checks_before(before, checker);
  LinkChecks checks_after(after, checker);
  for (Roadmap::PlaceId place = 1; place < roadmap.places.size(); place += 5) {
    const Target target{0, {0.0, 0}, {{place, {1.0, 0}}}};
    const auto open = search(before, stances, *test::nao(), checks_before, target, never);
    const auto dut = search(after, stances, *test::nao(), checks_after, target, never);
    if (dut) {
      ASSERT_TRUE(open.has_value());
      ASSERT_LE(open->cost, dut->cost);
    }
  }
}

/// Turning on does not help such a robot where it cannot switch: what one arrival can reach another cannot,
/// even if it can turn there.
TEST(Search, LosesNoWayOfARobotWhoseSwitchesNeedRoom) {
  Robot robot = *test::nao();
  for (Switch& change : robot.switches)
    if (change.displacement == Pose{}) change.body_m = {{-0.3, 0.5}, {-0.2, 0.2}, {0.0, 0.585}};
  const auto shared =
      std::make_shared<const Checker>(test::ourWorld("scenario2a"), std::make_shared<const Robot>(robot));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Roadmap roadmap = test::grown(shared, seed, 2);
    const Draft graph(&roadmap);
    Interrupt never(test::soon(), {});
    const Stances stances(*shared, Policy::kFastest);
    LinkChecks checks(graph, *shared);
    const Relaxed slow(*shared, roadmap, stances, {0, {0.3, 0}});
    for (Roadmap::PlaceId place = 1; place < roadmap.places.size(); place += 3) {
      const Target target{0, {0.3, 0}, {{place, {-1.1, 1}}}};
      const auto dut = search(graph, stances, robot, checks, target, never);
      const Cost least = slow.costTo({place, {-1.1, 1}});
      ASSERT_EQ(dut ? dut->cost : Cost::most(), least) << "seed " << seed << " place " << place;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OurMaps, SearchIn, ::testing::Values("scenario1", "scenario2a", "scenario3"));

}  // namespace
}  // namespace underway
