#include "server/robot/remote_plans.hpp"

#include <gtest/gtest.h>

#include "server/change_service.hpp"
#include "server/plan_service.hpp"
#include "tests/server/robot/robot_fixture.hpp"

/// A robot's plans from a real server over real DDS, with what it saw in the server's world.
namespace underway {
namespace {

using fixture::kPatience;

const Pose kStart{0.6, 2.0, 0.0};
const Pose kGoal{2.7, 0.8, 0.0};
Request aside() { return test::requestFor(kStart, kGoal); }

Obstacle seen(const std::string& id, double x, double y) {
  return {"seen_" + id, {{x, y, 0.3}, {0.06, 0.06, 0.6}, {}}};
}
World with(World world, const std::vector<Obstacle>& obstacles) {
  for (const Obstacle& obstacle : obstacles) world = *world.added(obstacle);
  return world;
}

struct RemotePlansTest : testing::Test {
  std::shared_ptr<const Domain> domain = fixture::openDomain();
  std::shared_ptr<const World> map = test::ourWorld("scenario3");
  std::shared_ptr<Planner> planner;
  std::optional<PlanService> plans;
  std::optional<ChangeService> changes;

  RemotePlansTest() { startServer(); }
  void startServer() {
    plans.reset();
    changes.reset();
    planner = std::make_shared<Planner>(map, test::nao());
    planner->prepare(test::soon());
    plans =
        PlanService::start(domain, {*test::nao(), map->name(), hashOf(*test::nao()), 1}, handlerFor(planner))
            .value();
    changes = ChangeService::start(domain, planner).value();
  }
  RemotePlans robot(const std::string& name) const {
    return RemotePlans::open(domain, name, map, test::nao(),
                             {std::chrono::seconds(60), {.discovery = kPatience}})
        .value();
  }
  [[nodiscard]] const Obstacles there() const { return planner->checker()->world().obstacles(); }
  [[nodiscard]] std::uint64_t revision() const { return planner->checker()->world().revision(); }
};

TEST_F(RemotePlansTest, givesThePlanThatTheServerMakes) {
  RemotePlans dut = robot("a");
  const auto plan = dut.plan(aside(), *map);
  ASSERT_TRUE(plan) << plan.error().message;
  const auto here = planner->plan(aside(), test::soon());
  ASSERT_EQ(plan->segments.size(), here->segments.size());
  EXPECT_EQ(plan->goal, here->goal);
  EXPECT_EQ(revision(), 1U);  // nothing was seen: nothing has changed
}

TEST_F(RemotePlansTest, putsWhatWasSeenIntoTheWorldUnderTheRobotsNameAndTakesBackWhatIsGone) {
  RemotePlans dut = robot("a");
  ASSERT_TRUE(dut.plan(aside(), with(*map, {seen("1", 1.3, 1.4), seen("2", 1.3, 1.5)})));
  EXPECT_TRUE(there().find("a.seen_1"));
  EXPECT_TRUE(there().find("a.seen_2"));
  const std::uint64_t before = revision();
  const auto plan = dut.plan(aside(), with(*map, {seen("2", 1.3, 1.5), seen("3", 1.3, 1.6)}));
  ASSERT_TRUE(plan);
  EXPECT_EQ(revision(), before + 2);  // one came, one went, one stayed
  EXPECT_EQ(plan->revision, revision());
  EXPECT_FALSE(there().find("a.seen_1"));
  EXPECT_TRUE(there().find("a.seen_3"));
  dut.forget();
  EXPECT_EQ(planner->checker()->world().hash(), map->hash());
}

TEST_F(RemotePlansTest, aNoIsTheServersAnswer) {
  RemotePlans dut = robot("a");
  std::vector<Obstacle> wall;
  wall.reserve(70);
  for (int i = 0; i < 70; ++i) wall.push_back(seen(std::to_string(i), 1.2, 0.03 + 0.058 * i));
  const auto plan = dut.plan(aside(), with(*map, wall));
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().code, ErrorCode::kNoPathExists) << plan.error().message;
}

TEST_F(RemotePlansTest, moreThanARequestHoldsIsToldInSeveral) {
  RemotePlans dut = robot("a");
  std::vector<Obstacle> many;
  many.reserve(1500);
  for (int i = 0; i < 1500; ++i) many.push_back(seen(std::to_string(i), 5.5 + 0.0001 * i, 3.5));
  ASSERT_TRUE(dut.plan(aside(), with(*map, many)));
  EXPECT_EQ(there().size(), map->obstacles().size() + 1500);
  ASSERT_TRUE(dut.plan(aside(), *map));
  EXPECT_EQ(there().size(), map->obstacles().size());
}

TEST_F(RemotePlansTest, whatAnEarlierRunOfItLeftIsForgotten) {
  {
    RemotePlans earlier = robot("a");  // ends without a word
    ASSERT_TRUE(earlier.plan(aside(), with(*map, {seen("1", 1.3, 1.4)})));
  }
  RemotePlans dut = robot("a");
  ASSERT_TRUE(dut.plan(aside(), with(*map, {seen("2", 1.3, 1.5)})));
  EXPECT_FALSE(there().find("a.seen_1"));
  EXPECT_TRUE(there().find("a.seen_2"));
}

TEST_F(RemotePlansTest, aServerThatStartedAnewIsToldAgain) {
  RemotePlans dut = robot("a");
  const World world = with(*map, {seen("1", 1.3, 1.4)});
  ASSERT_TRUE(dut.plan(aside(), world));
  startServer();
  EXPECT_FALSE(there().find("a.seen_1"));
  const auto plan = dut.plan(aside(), world);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_TRUE(there().find("a.seen_1"));
  EXPECT_EQ(plan->revision, revision());
}

TEST_F(RemotePlansTest, twoRobotsKeepTheirOwnApart) {
  RemotePlans a = robot("a");
  RemotePlans b = robot("ab");
  ASSERT_TRUE(a.plan(aside(), with(*map, {seen("1", 1.3, 1.4)})));
  ASSERT_TRUE(b.plan(aside(), with(*map, {seen("1", 1.3, 1.5)})));
  ASSERT_TRUE(a.plan(aside(), with(*map, {seen("2", 1.3, 1.6)})));
  EXPECT_FALSE(there().find("a.seen_1"));
  EXPECT_TRUE(there().find("a.seen_2"));
  EXPECT_TRUE(there().find("ab.seen_1"));
  a.forget();
  EXPECT_TRUE(there().find("ab.seen_1"));
  EXPECT_EQ(there().size(), map->obstacles().size() + 1);
}

TEST_F(RemotePlansTest, whoStandsInWhatAnotherSawTakesThatAwayAndNothingElse) {
  RemotePlans a = robot("a");
  RemotePlans b = robot("b");
  std::vector<Obstacle> what_a_saw{seen("aside", 5.5, 3.5)};  // and b itself, in many cells:
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      what_a_saw.push_back(seen(std::to_string(x) + "_" + std::to_string(y), 0.6 + 0.05 * x, 2.0 + 0.05 * y));
  ASSERT_TRUE(a.plan(test::requestFor(kGoal, {2.7, 1.2, 0.0}), with(*map, what_a_saw)));
  const auto plan = b.plan(aside(), *map);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_TRUE(there().find("a.seen_aside"));
  EXPECT_FALSE(there().find("a.seen_0_0"));
  // What a still sees it tells again; b again takes away only where it stands.
  ASSERT_TRUE(a.plan(test::requestFor(kGoal, {2.7, 1.2, 0.0}), with(*map, what_a_saw)));
  EXPECT_TRUE(there().find("a.seen_0_0"));
  EXPECT_TRUE(b.plan(aside(), *map));
}

TEST_F(RemotePlansTest, itsOwnSightAndTheMapAreNotTakenAway) {
  RemotePlans dut = robot("a");
  const auto own = dut.plan(aside(), with(*map, {seen("1", 0.6, 2.0)}));
  ASSERT_FALSE(own);
  EXPECT_EQ(own.error().code, ErrorCode::kStartInCollision);
  const auto mapped = dut.plan(test::requestFor({4.0, 2.0, 0.0}, kGoal), *map);
  ASSERT_FALSE(mapped);
  EXPECT_EQ(mapped.error().code, ErrorCode::kStartInCollision);
  EXPECT_EQ(there().size(), map->obstacles().size());
}

TEST_F(RemotePlansTest, anotherMapOrRobotIsRefusedInASentence) {
  const auto other_map = test::ourWorld("flat");
  RemotePlans elsewhere = RemotePlans::open(domain, "a", other_map, test::nao()).value();
  const auto in_other = elsewhere.plan(aside(), *other_map);
  ASSERT_FALSE(in_other);
  EXPECT_EQ(in_other.error().code, ErrorCode::kInvalidRequest);
  EXPECT_NE(in_other.error().message.find("--map"), std::string::npos) << in_other.error().message;

  const auto changed_map = std::make_shared<const World>(*map->removed("wall_left"));
  RemotePlans changed = RemotePlans::open(domain, "a", changed_map, test::nao()).value();
  EXPECT_EQ(changed.plan(aside(), *changed_map).error().code, ErrorCode::kInvalidRequest);

  auto fatter = *test::nao();
  fatter.margin_m += 0.01;
  RemotePlans other = RemotePlans::open(domain, "a", map, std::make_shared<const Robot>(fatter)).value();
  const auto for_other = other.plan(aside(), *map);
  ASSERT_FALSE(for_other);
  EXPECT_EQ(for_other.error().code, ErrorCode::kInvalidRequest);
  EXPECT_NE(for_other.error().message.find("robot"), std::string::npos) << for_other.error().message;
}

TEST_F(RemotePlansTest, withoutAServerSaysSo) {
  plans.reset();
  changes.reset();
  RemotePlans dut =
      RemotePlans::open(domain, "a", map, test::nao(),
                        {std::chrono::seconds(5), {.discovery = std::chrono::milliseconds(300)}})
          .value();
  EXPECT_EQ(dut.plan(aside(), *map).error().code, ErrorCode::kNoServer);
  EXPECT_FALSE(RemotePlans::open(domain, "a.b", map, test::nao()));
}

}  // namespace
}  // namespace underway
