#include "planner/repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "planner/certify.hpp"
#include "planner/grow.hpp"
#include "planner/search.hpp"
#include "tests/geometry/random_world.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

using test::requestFor;
using test::soon;
using WorldPointer = std::shared_ptr<const World>;

WorldPointer shared(Expected<World> world) { return std::make_shared<const World>(*std::move(world)); }

std::string anyId(test::RandomWorld& random, const World& world) {
  return world.obstacles()[static_cast<std::size_t>(random.oneOf(static_cast<int>(world.obstacles().size())))]
      .id;
}

WorldPointer withOneMore(test::RandomWorld& random, const World& world) {
  return shared(world.added({"new_" + std::to_string(world.revision()), random.box(true)}));
}

/// The next revision: an obstacle comes, goes, or moves, a little or far.
WorldPointer changed(test::RandomWorld& random, const World& world) {
  if (world.obstacles().empty() || random.oneOf(3) == 0) return withOneMore(random, world);
  const std::string id = anyId(random, world);
  if (random.oneOf(2) == 0) return shared(world.removed(id));
  OrientedBox box = world.obstacles()[*world.obstacles().find(id)].box;
  if (random.oneOf(2) == 0)
    box = random.box(true);
  else
    box.center_m.x += random.between(-0.05, 0.05);
  return shared(world.moved(id, box));
}

Roadmap grown(const std::shared_ptr<const Checker>& checker, unsigned batches) {
  Growth growth(checker, {1, 3.0});
  for (unsigned i = 0; i < batches; ++i) growth.addBatch();
  return growth.freeze();
}

void expectSame(const Roadmap& dut, const Roadmap& other) {
  ASSERT_EQ(dut.ways, other.ways);
  ASSERT_EQ(dut.node_count, other.node_count);
  ASSERT_EQ(dut.edge_count, other.edge_count);
  for (std::size_t i = 0; i < dut.places.size(); ++i)
    ASSERT_EQ(dut.places[i].turns_freely, other.places[i].turns_freely) << "place " << i;
}

TEST(Repair, FindsAsMuchAsLookingAtEverythingAgain) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    test::RandomWorld random(seed);
    WorldPointer world = random.world(10);
    auto checker = std::make_shared<const Checker>(world, seed == 3 ? test::nao() : test::smallRobot());
    auto dut = std::make_shared<const Roadmap>(grown(checker, 2));
    const LinkIndex index(*dut, checker->robot());
    for (int round = 0; round < 40; ++round) {
      WorldPointer next = world;
      for (int i = 0; i <= random.oneOf(4); ++i) next = changed(random, *next);
      const auto after = std::make_shared<const Checker>(checker->at(next));
      const Stances stances(*after, Policy::kFastest);
      Repair repair, all;
      dut = repaired(*dut, index, stances, *after, Obstacles::changes(world->obstacles(), next->obstacles()),
                     repair);
      SCOPED_TRACE(testing::Message() << "seed " << seed << " round " << round);
      expectSame(*dut, *revalidated(*dut, stances, *after, all));
      if (HasFatalFailure()) return;
      EXPECT_EQ(all.closed + all.opened, 0U);
      EXPECT_LE(repair.checked, all.checked);
      world = next;
      checker = after;
    }
  }
}

/// What the cheapest way between two places costs; Cost::most() if there is none.
Cost costBetween(const Roadmap& roadmap, const Checker& checker, Policy policy, Roadmap::PlaceId from,
                 Roadmap::PlaceId to) {
  const Draft graph(&roadmap);
  const Stances stances(checker, policy);
  LinkChecks checks(graph, checker);
  Interrupt never(soon(), {});
  const auto passage =
      search(graph, stances, checker.robot(), checks, {from, {0.3, 0}, {{to, {-1.1, 0}}}}, never);
  return passage ? passage->cost : Cost::most();
}

TEST(Repair, NeverRaisesTheCostWhenAnObstacleGoesNorLowersItWhenOneComes) {
  constexpr unsigned kSeed = 4;
  test::RandomWorld random(kSeed);
  int differing = 0;
  for (int round = 0; round < 12; ++round) {
    const WorldPointer many = random.world(9);
    const auto checker = std::make_shared<const Checker>(many, test::smallRobot());
    const Roadmap crowded = grown(checker, 2);
    const LinkIndex index(crowded, checker->robot());
    const WorldPointer few = shared(many->removed(anyId(random, *many)));
    const Checker after = checker->at(few);
    const Stances stances(after, Policy::kFastest);
    Repair repair;
    const auto emptier = repaired(crowded, index, stances, after,
                                  Obstacles::changes(many->obstacles(), few->obstacles()), repair);
    EXPECT_EQ(repair.closed, 0U);
    for (int i = 0; i < 30; ++i) {
      const auto place = [&] {
        return static_cast<Roadmap::PlaceId>(random.oneOf(static_cast<int>(crowded.places.size())));
      };
      const Policy policy = i % 2 == 0 ? Policy::kPriority : Policy::kFastest;
      const Roadmap::PlaceId from = place(), to = place();
      if (crowded.places[from].group != 0 || crowded.places[to].group != 0) continue;
      const Cost with = costBetween(crowded, *checker, policy, from, to);
      const Cost without = costBetween(*emptier, after, policy, from, to);
      ASSERT_LE(without, with) << "seed " << kSeed << " round " << round << " from " << from << " to " << to;
      differing += without < with ? 1 : 0;
    }
  }
  EXPECT_GT(differing, 0) << "the obstacles that went stood in nobody's way";
}

void expectSound(const Expected<Plan>& plan, const Request& request, const Checker& checker) {
  ASSERT_TRUE(plan.has_value()) << plan.error().message;
  EXPECT_EQ(plan->revision, checker.world().revision());
  for (const Flaw& flaw : certify(*plan, request, checker))
    ADD_FAILURE() << "segment " << flaw.segment << " " << flaw.sentence;
}

TEST(Update, GivesPlansThatAreSoundInTheNewWorldAndNameItsRevision) {
  constexpr unsigned kSeed = 5;
  test::RandomWorld random(kSeed);
  WorldPointer world = random.world(6);
  Planner dut(world, test::smallRobot());
  int plans = 0;
  for (int round = 0; round < 25; ++round) {
    world = changed(random, *world);
    dut.update(world);
    ASSERT_EQ(dut.checker()->world().revision(), world->revision());
    const Request request = requestFor(random.pose(), random.pose());
    const auto plan = dut.findPlan(request, Planner::Clock::now() + std::chrono::milliseconds(200));
    if (!plan) {
      EXPECT_NE(plan.error().code, ErrorCode::kInternal) << plan.error().message;
      continue;
    }
    ++plans;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round);
    expectSound(plan, request, *dut.checker());
  }
  EXPECT_GT(plans, 3);
}

const Request kAcross = requestFor({1, 2, 0}, {5, 2, 0});
const Obstacle kWallWithRoomBeside{"wall", {{3.0, 1.5, 0.5}, {0.2, 3.0, 1.0}, {}}};

WorldPointer room(std::vector<Obstacle> obstacles, const Bounds& bounds = {{0, 0, 0}, 6, 4}) {
  return shared(World::make("room", bounds, 0.0, std::move(obstacles)));
}

TEST(Update, GoesRoundWhatCameAndStraightOnWhenItWent) {
  WorldPointer world = room({});
  Planner dut(world, test::nao());
  const auto straight = dut.plan(kAcross, soon());
  expectSound(straight, kAcross, *dut.checker());
  dut.update(world = shared(world->added(kWallWithRoomBeside)));
  const auto round = dut.plan(kAcross, soon());
  expectSound(round, kAcross, *dut.checker());
  EXPECT_GT(round->total_time_s, straight->total_time_s + 1.0);
  dut.update(world = shared(world->removed("wall")));
  const auto again = dut.plan(kAcross, soon());
  expectSound(again, kAcross, *dut.checker());
  EXPECT_LT(again->total_time_s, round->total_time_s);
}

TEST(Update, TakesOtherBoundsAndAnotherFloor) {
  Planner dut(room({}), test::nao());
  expectSound(dut.plan(kAcross, soon()), kAcross, *dut.checker());
  dut.update(room({kWallWithRoomBeside}, {{0, 0, 0}, 6, 3}));  // the room beside the wall is gone
  const auto closed = dut.plan(kAcross, soon());
  ASSERT_FALSE(closed.has_value());
  EXPECT_EQ(closed.error().code, ErrorCode::kNoPathExists) << closed.error().message;
  dut.update(room({kWallWithRoomBeside}, {{-1, -1, 0}, 9, 7}));
  expectSound(dut.plan(kAcross, soon()), kAcross, *dut.checker());
  dut.update(shared(World::make("upstairs", {{0, 0, 0}, 6, 4}, 3.0, {kWallWithRoomBeside})));
  expectSound(dut.plan(kAcross, soon()), kAcross, *dut.checker());
}

TEST(Update, LetsTheRoadmapGrowOnInTheNewWorld) {
  WorldPointer world = room({});
  Planner dut(world, test::nao());
  expectSound(dut.plan(kAcross, soon()), kAcross, *dut.checker());
  const auto before = dut.roadmap();
  // A wall with a gap that few sampled ways pass: more is grown for it.
  std::vector<Obstacle> wall{{"south", {{3.0, 0.8, 0.5}, {0.6, 1.6, 1.0}, {}}},
                             {"north", {{3.0, 2.985, 0.5}, {0.6, 2.03, 1.0}, {}}}};
  for (const Obstacle& part : wall) world = shared(world->added(part));
  dut.update(world);
  expectSound(dut.plan(kAcross, soon()), kAcross, *dut.checker());
  EXPECT_EQ(before->batches > 0, true);
  EXPECT_GE(dut.roadmap()->batches, before->batches);
  const Checker& checker = *dut.checker();
  Repair repair;
  expectSame(*dut.roadmap(),
             *revalidated(*dut.roadmap(), Stances(checker, Policy::kFastest), checker, repair));
}

TEST(Update, LeavesBehindWhatHadGrownForAHardQuestion) {
  const WorldPointer open = room({});
  const WorldPointer closed = shared(open->added({"closed", {{3.0, 2.0, 0.5}, {0.6, 4.0, 1.0}, {}}}));
  WorldPointer with_gap = shared(closed->removed("closed"));
  with_gap = shared(with_gap->added({"south", {{3.0, 0.8, 0.5}, {0.6, 1.6, 1.0}, {}}}));
  with_gap = shared(with_gap->added({"north", {{3.0, 2.985, 0.5}, {0.6, 2.03, 1.0}, {}}}));
  const auto planIn = [&](bool asks_while_closed) {
    Planner dut(open, test::nao());
    expectSound(dut.plan(kAcross, soon()), kAcross, *dut.checker());
    dut.update(closed);
    if (asks_while_closed) {
      EXPECT_FALSE(dut.findPlan(kAcross, Planner::Clock::now() + std::chrono::milliseconds(300)));
    }
    const std::uint32_t first = dut.roadmap()->batches;
    dut.update(with_gap);
    auto plan = dut.plan(kAcross, soon());
    expectSound(plan, kAcross, *dut.checker());
    EXPECT_GT(plan->stats.batches, first) << "this question is too easy to tell anything";
    return *std::move(plan);
  };
  const Plan plan = planIn(true);
  const Plan same = planIn(false);
  EXPECT_EQ(plan.stats.batches, same.stats.batches);
  ASSERT_EQ(plan.segments.size(), same.segments.size());
  for (std::size_t i = 0; i < plan.segments.size(); ++i)
    EXPECT_EQ(plan.segments[i].motion, same.segments[i].motion);
}

TEST(Update, LeavesQueriesFromOtherThreadsInAWorldOfTheirOwn) {
  std::vector<WorldPointer> worlds{room({})};
  for (int i = 0; i < 6; ++i)
    worlds.push_back(i % 2 == 0 ? shared(worlds.back()->added(kWallWithRoomBeside))
                                : shared(worlds.back()->removed("wall")));
  Planner dut(worlds[0], test::nao());
  std::atomic<bool> is_over = false;
  const auto ask = [&] {
    while (!is_over) {
      const auto plan = dut.findPlan(kAcross, soon());
      ASSERT_TRUE(plan.has_value()) << plan.error().message;
      ASSERT_GE(plan->revision, 1U);
      ASSERT_LE(plan->revision, worlds.size());
      const Checker checker(worlds[plan->revision - 1], test::nao());
      EXPECT_TRUE(certify(*plan, kAcross, checker).empty()) << "revision " << plan->revision;
    }
  };
  std::jthread one(ask), two(ask);
  for (std::size_t i = 1; i < worlds.size(); ++i) {
    dut.update(worlds[i]);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  is_over = true;
}

}  // namespace
}  // namespace underway
