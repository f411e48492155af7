#include <gtest/gtest.h>

#include "server/dds.hpp"
#include "server/robot/convert_robot.hpp"
#include "server/robot/robot_end.hpp"
#include "tests/server/robot/robot_fixture.hpp"

/// Both ends of a robot's wire over real DDS.
namespace underway {
namespace {

using fixture::inTime;
using fixture::randomCommand;
using fixture::randomSenses;

struct OwnEndsTest : testing::Test {
  std::shared_ptr<const Domain> domain = fixture::openDomain();
  std::unique_ptr<RobotEnd> robot = openRobotEnd(*domain, "nao_1", test::nao()).value();
  std::unique_ptr<DriverEnd> driver = openDriverEnd(*domain, "nao_1", test::nao()).value();

  /// Tells until it is heard: an end that has just been opened is not matched yet.
  std::optional<HeardSenses> tellAndHear(const HeardSenses& told) {
    for (const auto until = inTime(); RobotEnd::Clock::now() < until;) {
      EXPECT_TRUE(robot->tell(told.tick, told.senses()));
      auto heard = driver->hear(RobotEnd::Clock::now() + std::chrono::milliseconds(100)).value();
      if (heard && heard->tick == told.tick) return heard;
    }
    return std::nullopt;
  }
  std::optional<HeardCommand> sendAndHear(std::uint64_t tick, const Command& command) {
    for (const auto until = inTime(); RobotEnd::Clock::now() < until;) {
      EXPECT_TRUE(driver->send(tick, command));
      auto heard = robot->hear(RobotEnd::Clock::now() + std::chrono::milliseconds(100)).value();
      if (heard && heard->tick == tick) return heard;
    }
    return std::nullopt;
  }
};

TEST_F(OwnEndsTest, sensesAndCommandsArriveAsTheyWereTold) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const HeardSenses told = randomSenses(seed);
    const auto heard = tellAndHear(told);
    ASSERT_TRUE(heard);
    fixture::expectSame(told, *heard, seed);
    const auto command = sendAndHear(seed, randomCommand(seed));
    ASSERT_TRUE(command);
    EXPECT_EQ(command->command, randomCommand(seed));
  }
}

TEST_F(OwnEndsTest, theNewestIsHeardAndNothingTwice) {
  ASSERT_TRUE(tellAndHear(randomSenses(1)));
  while (driver->hear(RobotEnd::Clock::now()).value()) {
  }
  for (const std::uint64_t seed : {2, 3, 4}) ASSERT_TRUE(robot->tell(seed, randomSenses(seed).senses()));
  std::uint64_t last = 0;
  for (const auto until = inTime(); last != 4 && RobotEnd::Clock::now() < until;)
    if (const auto heard = driver->hear(until).value()) {
      EXPECT_GT(heard->tick, last);
      last = heard->tick;
    }
  EXPECT_EQ(last, 4U);
  EXPECT_FALSE(driver->hear(RobotEnd::Clock::now()).value());
}

TEST_F(OwnEndsTest, robotsOfOtherNamesAreNotHeard) {
  const auto other = openRobotEnd(*domain, "nao_2", test::nao()).value();
  const auto others = openDriverEnd(*domain, "nao_2", test::nao()).value();
  HeardSenses told = randomSenses(1);
  std::optional<HeardSenses> heard;
  for (const auto until = inTime(); !heard && RobotEnd::Clock::now() < until;) {
    ASSERT_TRUE(other->tell(7, told.senses()));
    heard = others->hear(RobotEnd::Clock::now() + std::chrono::milliseconds(100)).value();
  }
  ASSERT_TRUE(heard);
  told.tick = 8;
  ASSERT_TRUE(tellAndHear(told));  // the first that this driver hears is its own robot's
}

TEST_F(OwnEndsTest, whatIsMalformedIsPassedOverToldAndDoesNotEndTheWaiting) {
  const dds::Entity participant = dds::createParticipant(*domain).value();
  const dds::Entity topic = dds::createTopic(participant, underway_Senses_desc, "underway/senses").value();
  const dds::Entity writer = dds::createWriter(participant, topic, {.partition = "nao_1"}).value();
  HeardSenses told = randomSenses(1);
  told.rest.heading_rad = 0.5;
  const WireSenses wire = toWire(3, told.senses(), *test::nao());
  wire->heading_rad = 1e9;
  for (const auto until = inTime(); driver->fault().empty() && RobotEnd::Clock::now() < until;) {
    dds_write(writer.get(), wire.get());
    const auto full = RobotEnd::Clock::now() + std::chrono::milliseconds(100);
    EXPECT_FALSE(driver->hear(full).value());
    EXPECT_GE(RobotEnd::Clock::now(), full);
  }
  EXPECT_TRUE(driver->fault().starts_with("heading_rad")) << driver->fault();
  EXPECT_TRUE(tellAndHear(told));
}

TEST_F(OwnEndsTest, twoRobotsOfOneNameAreAnError) {
  const auto other = openRobotEnd(*domain, "nao_1", test::nao()).value();
  const HeardSenses told = randomSenses(1);
  Expected<std::optional<HeardSenses>> heard;
  for (const auto until = inTime(); heard && RobotEnd::Clock::now() < until;)
    for (RobotEnd* const end : {robot.get(), other.get()}) {
      ASSERT_TRUE(end->tell(1, told.senses()));
      if (heard) heard = driver->hear(RobotEnd::Clock::now() + std::chrono::milliseconds(20));
    }
  ASSERT_FALSE(heard);
  EXPECT_EQ(heard.error().message,
            "two robots tell what they sense under the name \"nao_1\": give each its own --name");
}

TEST_F(OwnEndsTest, twoDriversOfOneRobotAreAnError) {
  const auto other = openDriverEnd(*domain, "nao_1", test::nao()).value();
  Expected<std::optional<HeardCommand>> heard;
  for (const auto until = inTime(); heard && RobotEnd::Clock::now() < until;)
    for (DriverEnd* const end : {driver.get(), other.get()}) {
      ASSERT_TRUE(end->send(1, randomCommand(1)));
      if (heard) heard = robot->hear(RobotEnd::Clock::now() + std::chrono::milliseconds(20));
    }
  ASSERT_FALSE(heard);
  EXPECT_TRUE(heard.error().message.starts_with("two drivers command the robot \"nao_1\": "));
}

TEST_F(OwnEndsTest, aRobotThatIsStartedAnewIsHeard) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    ASSERT_TRUE(tellAndHear(randomSenses(seed)));
    robot.reset();
    robot = openRobotEnd(*domain, "nao_1", test::nao()).value();
  }
  EXPECT_TRUE(tellAndHear(randomSenses(4)));
}

TEST_F(OwnEndsTest, aNameThatIsNoRobotsIsRefused) {
  for (const char* name : {"", "a b", "a.b", "a*"}) {
    EXPECT_EQ(openRobotEnd(*domain, name, test::nao()).error().code, ErrorCode::kInvalidRequest) << name;
    EXPECT_EQ(openDriverEnd(*domain, name, test::nao()).error().code, ErrorCode::kInvalidRequest) << name;
  }
}

}  // namespace
}  // namespace underway
