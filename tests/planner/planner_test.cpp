#include "planner/planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <thread>

#include "planner/certify.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

using test::metresIn;
using test::requestFor;
using test::soon;

constexpr ModeId kFrontal = 0, kLateral = 1, kCrawl = 2;
const Pose kLeft{0.6, 2.0, 0.0};
const Pose kRight{5.4, 2.0, 0.0};
const Pose kRightOfTheBlock{3.4, 1.5, 0.0};  // in scenario 1, which is smaller

std::unique_ptr<Planner> plannerFor(const std::string& map, std::uint64_t seed = 1) {
  return std::make_unique<Planner>(test::ourWorld(map), test::nao(), GrowthSettings{seed, 3.0});
}

std::unique_ptr<Planner> plannerIn(std::vector<Obstacle> obstacles, std::uint64_t seed = 1) {
  const auto world = World::make("room", {{0, 0, 0}, 6, 4}, 0.0, std::move(obstacles));
  return std::make_unique<Planner>(std::make_shared<const World>(*world), test::nao(),
                                   GrowthSettings{seed, GrowthSettings{}.sites_per_m2});
}

/// That a plan exists and is sound, and the plan.
Plan soundPlan(Planner& dut, const Request& request) {
  const auto plan = dut.plan(request, soon());
  if (!plan) {
    ADD_FAILURE() << plan.error().message;
    return {};
  }
  for (const Flaw& flaw : certify(*plan, request, *dut.checker()))
    ADD_FAILURE() << "segment " << flaw.segment << " " << flaw.sentence;
  return *plan;
}

TEST(Planner, IsNotMadeSlowByAHardQuestion) {
  const auto dut = plannerFor("too_narrow");
  const Request easy = requestFor({0.8, 1.5, 0.0}, {1.7, 2.4, 0.0});
  const Plan before = *dut->plan(easy, soon());
  const auto hard = dut->findPlan(requestFor({0.8, 1.5, 0.0}, {4.2, 1.5, 0.0}),
                                  Planner::Clock::now() + std::chrono::milliseconds(500));
  ASSERT_FALSE(hard);
  EXPECT_EQ(hard.error().code, ErrorCode::kTimeout);
  const Plan after = *dut->plan(easy, soon());
  EXPECT_LE(after.stats.batches, 8 * std::max(1U, before.stats.batches));
  EXPECT_EQ(after.stats.batches, dut->roadmap()->batches);
  // How far it came is told.
  const auto at = hard.error().message.find("with ");
  EXPECT_GT(std::stoul(hard.error().message.substr(at + 5)), after.stats.batches);
}

TEST(Planner, CrawlsOnlyUnderTheLowPlaceAndStandsUpAfterIt) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Plan plan = soundPlan(*plannerFor("scenario3", seed), requestFor(kLeft, kRight));
    EXPECT_LT(metresIn(plan, kCrawl), 1.38) << "seed " << seed;  // 1.376 m is the shortest there is
    EXPECT_GT(metresIn(plan, kCrawl), 1.375) << "seed " << seed;
    ASSERT_FALSE(plan.segments.empty());
    EXPECT_EQ(plan.segments.back().motion.to_mode, kFrontal);
  }
}

TEST(Planner, PassesANarrowPlaceSidewaysAndABroadOneFrontally) {
  EXPECT_GT(metresIn(soundPlan(*plannerFor("scenario2a"), requestFor(kLeft, kRight)), kLateral), 0.3);
  EXPECT_GT(metresIn(soundPlan(*plannerFor("scenario2b"), requestFor(kLeft, kRight)), kLateral), 0.3);
  EXPECT_EQ(metresIn(soundPlan(*plannerFor("scenario1"), requestFor(kLeft, kRightOfTheBlock)), kLateral),
            0.0);
}

TEST(Planner, LeavesASlotWhoseMouthIsNarrowedOnEitherSide) {
  // 50 cm wide, faced to its end. Past the post that narrows the mouth to 44 cm the body and its margins have
  // a centimetre to spare, 3 cm beside the slot's middle; between corners, no two faces stand opposite.
  for (const double side : {1.0, -1.0})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto dut = plannerIn({{"left", {{1.4, 2.0 + 0.28, 0.5}, {0.8, 0.06, 1.0}, {}}},
                                  {"right", {{1.4, 2.0 - 0.28, 0.5}, {0.8, 0.06, 1.0}, {}}},
                                  {"end", {{0.97, 2.0, 0.5}, {0.06, 0.62, 1.0}, {}}},
                                  {"post", {{1.85, 2.0 + side * 0.25, 0.5}, {0.1, 0.12, 1.0}, {}}}},
                                 seed);
      Request request = requestFor({1.3, 2.0, -std::numbers::pi}, {4.0, 2.0, 0.0});
      request.goal_yaw.reset();
      soundPlan(*dut, request);
    }
}

TEST(Planner, GoesNoLongWayRoundToSpareAStepSidewaysThatItNeedNotTake) {
  const auto dut = plannerFor("flat");
  const Request by_priority =
      requestFor({9.053716578, 2.079847485, 1.159552988}, {7.668776843, 1.170866059, 0.447467752});
  Request fastest = by_priority;
  fastest.policy = Policy::kFastest;
  const Plan plan = soundPlan(*dut, by_priority);
  EXPECT_EQ(metresIn(plan, kLateral), 0.0);
  EXPECT_LT(plan.total_time_s, 1.2 * soundPlan(*dut, fastest).total_time_s);
}

TEST(Planner, GivesTheSamePlanForTheSameSeedAlsoFromTwoThreads) {
  const Request request = requestFor(kLeft, kRight);
  const Plan once = soundPlan(*plannerFor("scenario3", 7), request);
  const auto shared = plannerFor("scenario3", 7);
  Plan first, second;
  {
    std::jthread one([&] { first = soundPlan(*shared, request); });
    std::jthread two([&] { second = soundPlan(*shared, request); });
  }
  for (const Plan* plan : {&first, &second}) {
    ASSERT_EQ(plan->segments.size(), once.segments.size());
    for (std::size_t i = 0; i < once.segments.size(); ++i)
      EXPECT_EQ(plan->segments[i].motion, once.segments[i].motion);
  }
}

TEST(Planner, KeepsTheLawsOfThePolicies) {
  for (const char* map : {"scenario2a", "scenario2b", "scenario3"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto dut = plannerFor(map, seed);
      Request request = requestFor(kLeft, kRight);
      request.max_detour = 1e9;
      const Plan priority = soundPlan(*dut, request);
      request.policy = Policy::kFastest;
      const Plan fastest = soundPlan(*dut, request);
      request.policy = Policy::kSafest;
      const Plan safest = soundPlan(*dut, request);
      EXPECT_LE(metresIn(priority, kCrawl), metresIn(fastest, kCrawl)) << map << " seed " << seed;
      EXPECT_GE(leastClearance(safest), leastClearance(fastest)) << map << " seed " << seed;
      EXPECT_LE(fastest.total_time_s, priority.total_time_s + 1e-9) << map << " seed " << seed;
    }
  }
}

TEST(Planner, KeepsToTheMiddleOfACorridorForSafety) {
  // Just wide enough to keep the enough: few places of a roadmap do.
  const double half_m = 0.195 + kEnoughClearance_m + 0.01;
  const auto block = [](const char* id, double from_y, double to_y) {
    return Obstacle{id, {{3.0, 0.5 * (from_y + to_y), 0.5}, {3.0, to_y - from_y, 1.0}, {}}};
  };
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto dut = plannerIn({block("south", 0.0, 2.0 - half_m), block("north", 2.0 + half_m, 4.0)}, seed);
    const Plan plan = soundPlan(*dut, requestFor({0.6, 0.8, 1.0}, {5.4, 3.2, 1.0}, Policy::kSafest));
    EXPECT_GE(leastClearance(plan), kEnoughClearance_m - 1e-3) << "seed " << seed;
  }
}

TEST(Planner, TakesTheFastestPlanWhenPriorityWouldGoTooFarRound) {
  // A table across the room with a way round its far end: the crawl is short, the way round is long.
  const Obstacle table{"table", {{3.0, 1.6, 0.45}, {0.4, 3.2, 0.4}, {}}};
  const auto dut = plannerIn({table});
  Request request = requestFor({2.0, 0.5, 0.0}, {4.2, 0.5, 0.0});
  EXPECT_EQ(metresIn(soundPlan(*dut, request), kCrawl), 0.0);
  request.max_detour = 1.0;
  const Plan hurried = soundPlan(*dut, request);
  request.policy = Policy::kFastest;
  EXPECT_EQ(hurried.total_time_s, soundPlan(*dut, request).total_time_s);
}

TEST(Planner, StartsAndEndsUnderATable) {
  const auto dut = plannerFor("scenario3");
  Request out = requestFor({4.0, 2.0, 0.0}, kRight);
  out.start_mode = kCrawl;
  EXPECT_GT(metresIn(soundPlan(*dut, out), kCrawl), 0.1);
  Request in = requestFor(kLeft, {4.0, 2.0, 0.0});
  in.goal_mode = kCrawl;
  const Plan plan = soundPlan(*dut, in);
  ASSERT_FALSE(plan.segments.empty());
  EXPECT_EQ(plan.segments.back().motion.to_mode, kCrawl);
}

TEST(Planner, LeavesTheGoalsHeadingOpenWhenItIsNotGiven) {
  const auto dut = plannerFor("scenario1");
  Request request = requestFor(kLeft, kRightOfTheBlock);
  const double with_heading = soundPlan(*dut, request).total_time_s;
  request.goal_yaw.reset();
  EXPECT_LE(soundPlan(*dut, request).total_time_s, with_heading + 1e-9);
}

TEST(Planner, NeedsNoMotionToStayAndOnlyATurnToTurn) {
  const auto dut = plannerFor("scenario1");
  EXPECT_TRUE(soundPlan(*dut, requestFor(kLeft, kLeft)).segments.empty());
  const Plan turning = soundPlan(*dut, requestFor(kLeft, {kLeft.x, kLeft.y, 1.0}));
  ASSERT_EQ(turning.segments.size(), 1U);
  EXPECT_NEAR(turning.segments[0].motion.angle_rad, 1.0, 1e-12);
}

TEST(Planner, LeavesAPoseThatIsCloserToAWallThanTheMargin) {
  // 5 mm from the wall in front; the margin is 20 mm.
  const auto dut = plannerIn({{"wall", {{3.0, 2.0, 0.5}, {0.2, 4.0, 1.0}, {}}}});
  const Plan plan = soundPlan(*dut, requestFor({2.765, 2.0, 0.0}, {1.0, 1.0, 0.0}));
  ASSERT_FALSE(plan.segments.empty());
  EXPECT_NEAR(plan.segments[0].closeness.clearance_m, 0.005, 1e-5);
  for (std::size_t i = 1; i < plan.segments.size(); ++i)
    EXPECT_GE(plan.segments[i].closeness.clearance_m, 0.0194);
}

TEST(Planner, SaysWhatTheStartTouchesAndInWhichMode) {
  const auto dut = plannerFor("scenario3");
  const auto plan = dut->plan(requestFor({4.0, 2.0, 0.0}, kRight), soon());
  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().code, ErrorCode::kStartInCollision);
  EXPECT_NE(plan.error().message.find("table_top"), std::string::npos);
  EXPECT_NE(plan.error().message.find("frontal"), std::string::npos);
  ASSERT_EQ(plan.error().blocking.size(), 1U);
  EXPECT_EQ(plan.error().blocking[0].obstacle, "table_top");
  EXPECT_NEAR(plan.error().blocking[0].has_m, 0.30, 1e-9);
}

TEST(Planner, RefusesWhatItCannotBeAsked) {
  const auto dut = plannerFor("scenario2a");
  const auto code = [&](const Request& request) { return dut->plan(request, soon()).error().code; };
  EXPECT_EQ(code(requestFor({9.0, 2.0, 0.0}, kRight)), ErrorCode::kStartOutOfBounds);
  EXPECT_EQ(code(requestFor(kLeft, {5.95, 2.0, 0.0})), ErrorCode::kGoalOutOfBounds);
  EXPECT_EQ(code(requestFor({std::nan(""), 2.0, 0.0}, kRight)), ErrorCode::kInvalidRequest);
  EXPECT_EQ(code(requestFor(kLeft, {5.0, 2.0, INFINITY})), ErrorCode::kInvalidRequest);
  Request request = requestFor(kLeft, kRight);
  request.start_mode = 7;
  EXPECT_EQ(code(request), ErrorCode::kInvalidRequest);
}

/// That no path exists, and that a person is told what is to blame.
void expectNoPath(const char* map, const Request& request, const std::vector<const char*>& culprits) {
  const auto plan = plannerFor(map)->plan(request, soon());
  ASSERT_FALSE(plan.has_value()) << map;
  EXPECT_EQ(plan.error().code, ErrorCode::kNoPathExists) << map << ": " << plan.error().message;
  EXPECT_FALSE(plan.error().blocking.empty()) << map;
  const bool is_named = std::any_of(culprits.begin(), culprits.end(), [&](const char* culprit) {
    return plan.error().message.find(culprit) != std::string::npos;
  });
  EXPECT_TRUE(is_named) << map << ": " << plan.error().message;
}

TEST(Planner, SaysThatNoPathExistsAndWhatIsToBlame) {
  const Request across = requestFor({0.8, 1.5, 0.0}, {4.2, 1.5, 0.0});
  expectNoPath("too_low", across, {"beam"});
  Request crawling = across;
  crawling.start_mode = crawling.goal_mode = kCrawl;
  expectNoPath("too_low", crawling, {"beam"});
  expectNoPath("too_narrow", across, {"narrow_south"});
  Request any_heading = across;
  any_heading.goal_yaw.reset();
  expectNoPath("too_narrow", any_heading, {"narrow_south"});
  const std::vector<const char*> pen{"pen_south", "pen_north", "pen_west", "pen_east"};
  expectNoPath("walled_in", requestFor({0.8, 2.0, 0.0}, {3.0, 2.0, 0.0}), pen);
  expectNoPath("walled_in", requestFor({3.0, 2.0, 0.0}, {0.8, 2.0, 3.1416}), pen);
}

TEST(Planner, GivesUpAtADeadlineThatIsFarTooShort) {
  for (const bool has_roadmap : {false, true}) {
    const auto dut = plannerFor("too_low");
    if (has_roadmap) dut->prepare(soon());
    for (const auto given : {-1000, 0, 100, 300}) {  // [us]
      const auto begin = Planner::Clock::now();
      const auto late =
          dut->plan(requestFor({0.8, 1.5, 0.0}, {4.2, 1.5, 0.0}), begin + std::chrono::microseconds(given));
      ASSERT_FALSE(late.has_value());
      EXPECT_EQ(late.error().code, ErrorCode::kTimeout) << given << " us: " << late.error().message;
      EXPECT_LT(Planner::Clock::now() - begin, std::chrono::seconds(2)) << given << " us";
    }
  }
}

TEST(Planner, EndsWhenCancelled) {
  std::stop_source stop;
  stop.request_stop();
  const auto plan =
      plannerFor("too_low")->plan(requestFor({0.8, 1.5, 0.0}, {4.2, 1.5, 0.0}), soon(), stop.get_token());
  EXPECT_EQ(plan.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace underway
