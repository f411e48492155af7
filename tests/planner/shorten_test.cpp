#include "planner/shorten.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "planner/attach.hpp"
#include "planner/certify.hpp"
#include "planner/grow.hpp"
#include "planner/search.hpp"
#include "tests/geometry/random_world.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

using test::requestFor;
using test::soon;

constexpr ModeId kCrawl = 2;

/// A request on a roadmap, searched and shortened step by step, as an answer is.
class Shortening {
 public:
  Shortening(const std::shared_ptr<const World>& world, const std::shared_ptr<const Robot>& robot,
             unsigned batches)
      : checker_(std::make_shared<const Checker>(world, robot)), fastest_(*checker_, Policy::kFastest) {
    Growth growth(checker_, {1, 3.0});
    for (unsigned i = 0; i < batches; ++i) growth.addBatch();
    roadmap_ = growth.freeze();
  }

  [[nodiscard]] const Checker& checker() const { return *checker_; }

  struct Result {
    Passage before;
    Passage after;
    Keeping keeping;
  };
  std::optional<Result> of(const Request& request, const Stances& stances, Interrupt& interrupt) const {
    Interrupt never(soon(), {});
    const auto attached = attach(*checker_, fastest_, roadmap_, request, Effort::kNearest, never);
    LinkChecks checks(attached->graph, *checker_);
    auto passage = search(attached->graph, stances, checker_->robot(), checks, attached->target, never);
    if (!passage) return std::nullopt;
    const Keeping keeping{attached->graph.place(attached->target.start).keep_m,
                          attached->graph.place(attached->target.goals.front().place).keep_m};
    return Result{*passage, shortened(*checker_, stances, *passage, keeping, interrupt), keeping};
  }

  /// That a request is answered, no dearer than it was found, with a plan that passes its certificate.
  void expectGood(const Request& request, Policy policy, double at_least_m,
                  bool must_be_solved = true) const {
    const Stances stances(*checker_, policy, at_least_m);
    Interrupt never(soon(), {});
    const auto result = of(request, stances, never);
    ASSERT_TRUE(result.has_value() || !must_be_solved);
    if (!result) return;
    EXPECT_LE(result->after.cost, result->before.cost);
    const Route route = joined(*checker_, routeOf(result->after));
    std::vector<Segment> segments;
    for (const Motion& motion : route)
      segments.push_back(
          {motion, duration(checker_->robot(), motion), checker_->closeness(motion, kClearanceCap_m)});
    const Plan plan = timedPlan(std::move(segments), request.start);
    for (const Flaw& flaw : certify(plan, request, *checker_))
      ADD_FAILURE() << "segment " << flaw.segment << " " << flaw.sentence;
    expectKept(plan, request, at_least_m);
  }

  /// That a passage widened to a clearance keeps it; whether there is one.
  bool expectWidened(const Request& request, double at_least_m) const {
    Interrupt never(soon(), {});
    const auto found = of(request, Stances(*checker_, Policy::kPriority), never);
    if (!found) return false;
    const Stances stances(*checker_, Policy::kFastest, at_least_m);
    const auto wider = widened(*checker_, stances, found->after, found->keeping, never);
    if (!wider) return false;
    const Route route = joined(*checker_, routeOf(*wider));
    EXPECT_EQ(route.front().from, request.start);
    for (const Motion& motion : route)
      EXPECT_GE(checker_->closeness(motion, kClearanceCap_m).clearance_m, at_least_m - 1e-5);
    return true;
  }

 private:
  /// Clearance that is asked for is kept, but where the start or the goal has less itself.
  void expectKept(const Plan& plan, const Request& request, double at_least_m) const {
    if (clearanceToKeep(*checker_, request.start_mode, request.start) < checker_->robot().margin_m) return;
    if (request.goal_yaw &&
        clearanceToKeep(*checker_, request.goal_mode, {request.goal.x, request.goal.y, *request.goal_yaw}) <
            checker_->robot().margin_m)
      return;
    for (const Segment& segment : plan.segments) EXPECT_GE(segment.closeness.clearance_m, at_least_m - 1e-5);
  }

  std::shared_ptr<const Checker> checker_;
  Stances fastest_;
  Roadmap roadmap_;
};

TEST(Shortened, CostsNoMoreAndIsCertifiedInRandomWorlds) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    test::RandomWorld random(seed);
    const Shortening dut(random.world(7), seed % 2 == 0 ? test::nao() : test::smallRobot(), 4);
    for (int i = 0; i < 12; ++i) {
      Request request = requestFor(random.pose(), random.pose());
      request.start_mode = static_cast<ModeId>(random.oneOf(3));
      request.goal_mode = static_cast<ModeId>(random.oneOf(3));
      if (random.oneOf(3) == 0) request.goal_yaw.reset();
      if (!dut.checker().isFree(stay(request.start_mode, request.start), 1e-6)) continue;
      const Pose goal{request.goal.x, request.goal.y, request.goal_yaw.value_or(0.0)};
      if (!dut.checker().isFree(stay(request.goal_mode, goal), 1e-6)) continue;
      SCOPED_TRACE(testing::Message() << "seed " << seed << " case " << i);
      dut.expectGood(request, i % 2 == 0 ? Policy::kPriority : Policy::kFastest, 0.0, false);
    }
  }
}

TEST(Shortened, KeepsTheClearanceThatIsAskedFor) {
  const Shortening dut(test::ourWorld("scenario3"), test::nao(), 8);
  const Request request = requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0});
  for (const double at_least_m : {0.0, 0.03, 0.05}) dut.expectGood(request, Policy::kFastest, at_least_m);
}

TEST(Shortened, LeavesAndReachesLowPlacesAsItsEndsDemand) {
  const Shortening dut(test::ourWorld("scenario3"), test::nao(), 8);
  Request request = requestFor({4.0, 2.0, 0.0}, {5.4, 2.0, 0.0});
  request.start_mode = kCrawl;
  dut.expectGood(request, Policy::kPriority, 0.0);
  request = requestFor({0.6, 2.0, 0.0}, {4.0, 2.0, 0.0});
  request.goal_mode = kCrawl;
  dut.expectGood(request, Policy::kPriority, 0.0);
  request.goal_yaw.reset();
  dut.expectGood(request, Policy::kFastest, 0.0);
}

TEST(Shortened, KeepsWhatATightStartAndGoalHave) {
  const Obstacle wall{"wall", {{3.0, 2.0, 0.5}, {0.2, 4.0, 1.0}, {}}};
  const auto world = std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 6, 4}, 0.0, {wall}));
  const Shortening dut(world, test::nao(), 4);
  dut.expectGood(requestFor({2.765, 2.0, 0.0}, {1.0, 1.0, 0.0}), Policy::kFastest, 0.0);
  dut.expectGood(requestFor({1.0, 1.0, 0.0}, {2.765, 2.0, 0.0}), Policy::kFastest, 0.0);
  dut.expectGood(requestFor({2.765, 2.0, 0.0}, {2.765, 1.0, 0.0}), Policy::kFastest, 0.0);
}

TEST(Widened, KeepsWhatIsAskedForOrGivesNothing) {
  int found = 0;
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    test::RandomWorld random(seed);
    const Shortening dut(random.world(7), test::smallRobot(), 4);
    for (int i = 0; i < 20; ++i) {
      const Request request = requestFor(random.pose(), random.pose());
      const Pose goal{request.goal.x, request.goal.y, *request.goal_yaw};
      const double most_m = std::min(dut.checker().clearance(stay(0, request.start), 0.1),
                                     dut.checker().clearance(stay(0, goal), 0.1));
      if (most_m < 0.03) continue;
      SCOPED_TRACE(testing::Message() << "seed " << seed << " case " << i);
      for (const double at_least_m : {0.3 * most_m, 0.6 * most_m, 0.9 * most_m})
        found += dut.expectWidened(request, at_least_m) ? 1 : 0;
    }
  }
  EXPECT_GT(found, 50);
}

TEST(Shortened, StaysAsItWasWhenItIsInterruptedAtOnce) {
  const Shortening dut(test::ourWorld("scenario3"), test::nao(), 8);
  const Stances stances(dut.checker(), Policy::kFastest);
  Interrupt now(Interrupt::Clock::now(), {});
  const auto result = dut.of(requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}), stances, now);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->after.cost, result->before.cost);
  EXPECT_EQ(routeOf(result->after), routeOf(result->before));
  std::stop_source stop;
  stop.request_stop();
  Interrupt stopped(soon(), stop.get_token());
  EXPECT_EQ(dut.of(requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}), stances, stopped)->after.cost,
            result->before.cost);
}

TEST(Shortened, EndsWithinMillisecondsOfItsDeadline) {
  const Shortening dut(test::ourWorld("office"), test::nao(), 6);
  const Stances stances(dut.checker(), Policy::kPriority);
  test::RandomWorld random(1);
  const auto& bounds = dut.checker().world().bounds();
  for (int i = 0; i < 20; ++i) {
    const auto any = [&] {
      return Pose{random.between(0, bounds.width_m), random.between(0, bounds.height_m), random.angle()};
    };
    const Request request = requestFor(any(), any());
    if (!dut.checker().isFree(stay(0, request.start)) ||
        !dut.checker().isFree(stay(0, {request.goal.x, request.goal.y, *request.goal_yaw})))
      continue;
    Interrupt deadline(Interrupt::Clock::now(), {});
    const auto result = dut.of(request, stances, deadline);
    if (result) {
      EXPECT_EQ(result->after.cost, result->before.cost);
    }
  }
}

}  // namespace
}  // namespace underway
