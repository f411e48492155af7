#include "server/robot/follower.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "apps/stand_in.hpp"
#include "server/change_service.hpp"
#include "server/plan_service.hpp"
#include "server/robot/remote_plans.hpp"
#include "tests/server/robot/robot_fixture.hpp"

/// A simulated robot driven over real DDS.
namespace underway {
namespace {

using Outcome = Mission::Outcome;
using std::chrono::milliseconds;

const Pose kStart{0.6, 0.6, 0.0};
const Pose kGoal{2.4, 0.6, 0.0};
const Obstacle kBox{"box", {{1.5, 0.6, 0.4}, {0.2, 0.3, 0.8}, {}}};

std::shared_ptr<const World> roomWith(std::vector<Obstacle> obstacles) {
  return std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 3, 3}, 0.0, std::move(obstacles)));
}

/// A robot that lives on a thread of its own.
class LivingRobot {
 public:
  LivingRobot(const std::shared_ptr<const Domain>& domain, std::shared_ptr<const World> truth,
              const StandInSettings& settings)
      : body(std::move(truth), test::nao(), kStart, 0, 1),
        thread_([this, domain, settings](const std::stop_token& stop) {
          StandIn dut(body, openRobotEnd(*domain, "nao", test::nao()).value(), settings);
          EXPECT_TRUE(dut.live(stop));
        }) {}
  void end() { thread_ = {}; }
  sim::SimulatedRobot body;  // to be looked at after end()

 private:
  std::jthread thread_;
};

struct FollowerTest : testing::Test {
  std::shared_ptr<const Domain> domain = fixture::openDomain();
  std::shared_ptr<const World> map = roomWith({});
  std::stop_source stop;

  [[nodiscard]] Follower follower(FollowerSettings settings) const {
    settings.robot_timeout = fixture::kPatience;
    return {openDriverEnd(*domain, "nao", test::nao()).value(), settings};
  }
  static PlanSource planner() {
    return [](const Request& request, const std::shared_ptr<const World>& world) {
      return Planner(world, test::nao()).findPlan(request, Planner::Clock::now() + std::chrono::seconds(2));
    };
  }
  static PlanSource refusing(ErrorCode code) {
    return [code](const Request&, const std::shared_ptr<const World>&) -> Expected<Plan> {
      return fail(code, "refused");
    };
  }
};

TEST_F(FollowerTest, inStepItArrivesByAServersPlansRoundWhatIsNotInTheMapAndTheSameWayTwice) {
  const auto service = std::make_shared<Planner>(map, test::nao());
  const auto plans =
      PlanService::start(domain, {*test::nao(), map->name(), hashOf(*test::nao()), 1}, handlerFor(service))
          .value();
  const auto changes = ChangeService::start(domain, service).value();
  std::vector<Pose> ends;
  for (int run = 0; run < 2; ++run) {
    RemotePlans remote = RemotePlans::open(domain, "nao", map, test::nao()).value();
    LivingRobot robot(domain, roomWith({kBox}), {true, 0.0});
    int ticks = 0;
    const auto end = follower({.is_in_step = true})
                         .drive(
                             map, test::nao(), test::requestFor(kStart, kGoal),
                             [&](const Request& request, const std::shared_ptr<const World>& world) {
                               return remote.plan(request, *world);
                             },
                             stop.get_token(),
                             [&](const Mission&, const Tick&, const HeardSenses& heard) {
                               ++ticks;
                               EXPECT_EQ(heard.tick, static_cast<std::uint64_t>(ticks));  // none is missed
                             });
    robot.end();
    ASSERT_TRUE(end) << end.error().message;
    EXPECT_EQ(end->outcome, Outcome::kArrived) << end->why;
    EXPECT_FALSE(robot.body.truth().has_collided) << robot.body.truth().with;
    EXPECT_LT(distance(robot.body.truth().pose.position(), kGoal.position()), 0.05);
    ends.push_back(robot.body.truth().pose);
    remote.forget();
    EXPECT_EQ(service->checker()->world().hash(), map->hash());
  }
  EXPECT_EQ(ends[0], ends[1]);
}

TEST_F(FollowerTest, withTheClockItMeetsTheRobotAndArrives) {
  LivingRobot robot(domain, map, {false, 25.0});
  FollowerSettings settings;
  settings.robot_silent = fixture::kPatience;
  Follower dut = follower(settings);
  const auto met = dut.meet(stop.get_token());
  ASSERT_TRUE(met) << met.error().message;
  ASSERT_TRUE(met->pose);
  EXPECT_LT(distance(met->pose->position(), kStart.position()), 0.04);  // the mean of ten, each 15 mm off
  EXPECT_EQ(met->mode, 0);
  const auto end =
      dut.drive(map, test::nao(), test::requestFor(*met->pose, kGoal), planner(), stop.get_token());
  robot.end();
  ASSERT_TRUE(end) << end.error().message;
  EXPECT_EQ(end->outcome, Outcome::kArrived) << end->why;
  EXPECT_FALSE(robot.body.truth().has_collided) << robot.body.truth().with;
}

TEST_F(FollowerTest, withoutAServerForTheFirstPlanItEndsAtOnce) {
  LivingRobot robot(domain, map, {true, 0.0});
  const auto end = follower({.is_in_step = true})
                       .drive(map, test::nao(), test::requestFor(kStart, kGoal),
                              refusing(ErrorCode::kNoServer), stop.get_token());
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().code, ErrorCode::kNoServer);
}

TEST_F(FollowerTest, aFaultOfTheQuestionEndsItAndANoIsAnOutcome) {
  for (const ErrorCode code : {ErrorCode::kInvalidRequest, ErrorCode::kNoPathExists}) {
    LivingRobot robot(domain, map, {true, 0.0});
    const auto end =
        follower({.is_in_step = true})
            .drive(map, test::nao(), test::requestFor(kStart, kGoal), refusing(code), stop.get_token());
    ASSERT_EQ(end.has_value(), code == ErrorCode::kNoPathExists);
    if (end) {
      EXPECT_EQ(end->outcome, Outcome::kNoWay);
    }
    if (!end) {
      EXPECT_EQ(end.error().code, code);
    }
  }
}

TEST_F(FollowerTest, whenItIsStoppedTheLastCommandIsToStandStill) {
  LivingRobot robot(domain, map, {true, 0.0});
  const auto end = follower({.is_in_step = true})
                       .drive(map, test::nao(), test::requestFor(kStart, kGoal), planner(), stop.get_token(),
                              [&](const Mission&, const Tick& tick, const HeardSenses&) {
                                if (tick.command.velocity.x_mps > 0.0) stop.request_stop();
                              });
  robot.end();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->outcome, Outcome::kUnderway);
  // The same with an end of our own: the wire itself has to say it.
  stop = {};
  const auto own = openRobotEnd(*domain, "nao", test::nao()).value();
  std::optional<HeardCommand> last;
  std::jthread driver([&] {
    (void)follower({.is_in_step = true})
        .drive(map, test::nao(), test::requestFor(kStart, kGoal), planner(), stop.get_token());
  });
  sim::SimulatedRobot body(map, test::nao(), kStart, 0, 1);
  const auto until = fixture::inTime();
  for (std::uint64_t tick = 1; RobotEnd::Clock::now() < until;) {
    const Senses& senses = body.sense();
    ASSERT_TRUE(own->tell(tick, senses));
    const auto heard = own->hear(RobotEnd::Clock::now() + milliseconds(50)).value();
    if (heard && heard->tick == tick) ++tick, body.step(heard->command), last = heard;
    if (last && last->command.velocity.x_mps > 0.0) break;
  }
  ASSERT_GT(last->command.velocity.x_mps, 0.0);
  stop.request_stop();
  for (; last->tick != 0 && RobotEnd::Clock::now() < until;)
    if (const auto heard = own->hear(RobotEnd::Clock::now() + milliseconds(50)).value()) last = heard;
  EXPECT_EQ(last->tick, 0U);
  EXPECT_EQ(last->command, Command{});
}

TEST_F(FollowerTest, aRobotThatIsNotHeardIsSaidInASentence) {
  FollowerSettings settings;
  settings.robot_timeout = milliseconds(300);
  Follower dut(openDriverEnd(*domain, "nao", test::nao()).value(), settings);
  const auto met = dut.meet(stop.get_token());
  ASSERT_FALSE(met);
  EXPECT_NE(met.error().message.find("no robot was heard"), std::string::npos) << met.error().message;
}

TEST_F(FollowerTest, aRobotThatFallsSilentIsToldToStandAndGivenUp) {
  auto robot = std::make_unique<LivingRobot>(domain, map, StandInSettings{false, 10.0});
  FollowerSettings settings;
  settings.robot_silent = std::chrono::seconds(3);
  Follower dut = follower(settings);
  ASSERT_TRUE(dut.meet(stop.get_token()));
  bool was_lost = false;
  Command last;
  const auto end = dut.drive(map, test::nao(), test::requestFor(kStart, kGoal), planner(), stop.get_token(),
                             [&](const Mission&, const Tick& tick, const HeardSenses&) {
                               if (tick.state == State::kWalking && robot) robot.reset();
                               was_lost |= tick.state == State::kLost;
                               last = tick.command;
                             });
  ASSERT_FALSE(end);
  EXPECT_NE(end.error().message.find("not heard any more"), std::string::npos) << end.error().message;
  EXPECT_TRUE(was_lost);
  EXPECT_EQ(last, Command{});
}

}  // namespace
}  // namespace underway
