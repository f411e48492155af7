#include "planner/concurrent_proof.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

const Request kAcross = test::requestFor({0.8, 1.5, 0.0}, {4.2, 1.5, 0.0});
constexpr auto kNever = Interrupt::Clock::time_point::max();

std::shared_ptr<const Checker> checkerOf(const std::string& map) {
  return std::make_shared<const Checker>(test::ourWorld(map), test::nao());
}

TEST(ConcurrentProof, StopsWhoeverSearchesWhenItIsFound) {
  const auto checker = checkerOf("too_narrow");
  std::stop_source search;
  ConcurrentProof proof(checker, kAcross, {}, kNever, search);
  while (!search.stop_requested()) std::this_thread::yield();
  const auto no = proof.end();
  ASSERT_TRUE(no);
  EXPECT_EQ(no->code, ErrorCode::kNoPathExists);
  EXPECT_EQ(proof.checker(), checker);
}

TEST(ConcurrentProof, OfWhatIsPossibleIsNoneAndStopsNobody) {
  std::stop_source search;
  ConcurrentProof proof(checkerOf("scenario3"), test::requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}), {},
                        kNever, search);
  while (!proof.isOver()) std::this_thread::yield();
  EXPECT_FALSE(search.stop_requested());
  EXPECT_FALSE(proof.end());
}

TEST(ConcurrentProof, GivesUpWhenItsEndIsAskedForOrItIsLeftAlone) {
  std::stop_source search;
  for (int i = 0; i < 100; ++i) {
    ConcurrentProof proof(checkerOf("walled_in"), test::requestFor({0.8, 2.0, 0.0}, {3.0, 2.0, 0.0}), {},
                          kNever, search);
    if (i % 2 == 0) (void)proof.end();
  }
}

TEST(Planner, SaysThatThereIsNoWayOfAClosedWorldOnlyWhileItIsOpenedAndClosed) {
  const auto closed = test::ourWorld("too_narrow");
  const auto open = std::make_shared<const World>(*closed->removed("narrow_north"));
  Planner planner(closed, test::nao());
  planner.prepare(test::soon());
  std::jthread changing([&](const std::stop_token& stop) {
    for (int i = 0; !stop.stop_requested(); ++i) {
      planner.update(i % 2 == 0 ? open : closed);
      std::this_thread::sleep_for(std::chrono::milliseconds(i % 40));
    }
  });
  for (int i = 0; i < 40; ++i) {
    const auto plan = planner.plan(kAcross, test::soon());
    if (plan) {
      EXPECT_EQ(plan->world_hash, open->hash());
      continue;
    }
    EXPECT_EQ(plan.error().code, ErrorCode::kNoPathExists) << plan.error().message;
    EXPECT_EQ(plan.error().world_hash, closed->hash());
  }
}

TEST(Planner, ProvesThatThereIsNoWayWhileTheWorldChangesElsewhereAllTheTime) {
  const auto closed = test::ourWorld("too_narrow");
  Planner planner(closed, test::nao());
  planner.prepare(test::soon());
  std::jthread changing([&](const std::stop_token& stop) {
    World world = *closed->added({"changing", {{0.3, 2.7, 0.1}, {0.01, 0.01, 0.2}, {}}});
    for (int i = 0; !stop.stop_requested(); ++i) {
      world = *world.moved("changing", {{0.3, 2.7, 0.1}, {0.01 + 0.001 * (i % 50), 0.01, 0.2}, {}});
      planner.update(std::make_shared<const World>(world));
    }
  });
  const auto plan = planner.plan(kAcross, test::soon());
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().code, ErrorCode::kNoPathExists) << plan.error().message;
}

}  // namespace
}  // namespace underway
