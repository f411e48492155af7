#include "server/robot/ros_ends.hpp"

#include <gtest/gtest.h>

#include "server/dds.hpp"
#include "server/robot/convert_ros.hpp"
#include "tests/server/robot/robot_fixture.hpp"

/// A robot's wire by ROS 2's topics, over real DDS: with each other, and with foreign readers and writers.
namespace underway {
namespace {

using Clock = RobotEnd::Clock;
using fixture::inTime;
using std::chrono::milliseconds;

struct RosEndsTest : testing::Test {
  std::shared_ptr<const Domain> domain = fixture::openDomain();
  std::unique_ptr<RobotEnd> robot = openRosRobotEnd(*domain, {}, test::nao()).value();
  std::unique_ptr<DriverEnd> driver = openRosDriverEnd(*domain, {}, test::nao()).value();
  std::uint64_t tick = 0;

  /// As a robot does: a tick later each time, until the driver has heard all that was told.
  std::optional<HeardSenses> tellAndHear(HeardSenses told) {
    for (const auto until = inTime(); Clock::now() < until;) {
      told.rest.now_s = 0.1 * static_cast<double>(++tick);
      if (told.rest.pose) told.rest.pose->stamp_s = told.rest.now_s - 0.1;
      EXPECT_TRUE(robot->tell(tick, told.senses()));
      auto heard = driver->hear(Clock::now() + milliseconds(100)).value();
      if (heard && heard->scan.has_value() == told.scan.has_value() &&
          heard->rest.pose.has_value() == told.rest.pose.has_value() &&
          heard->rest.heading_rad.has_value() == told.rest.heading_rad.has_value())
        return heard;
    }
    return std::nullopt;
  }
};

HeardSenses standing() {
  HeardSenses told;
  told.scan = Scan{0.0, Beams{}, std::vector<float>(Beams{}.count, 1.25F)};
  told.rest.pose = PoseEstimate{0.0, {1.0, 2.0, 0.5}};
  told.rest.heading_rad = 0.5;
  return told;
}

TEST_F(RosEndsTest, sensesArriveAsTheyWereTold) {
  const HeardSenses told = standing();
  const auto heard = tellAndHear(told);
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->scan->ranges_m, told.scan->ranges_m);
  EXPECT_EQ(heard->rest.pose->pose.position(), told.rest.pose->pose.position());
  EXPECT_NEAR(heard->rest.now_s - heard->rest.pose->stamp_s, 0.1, 1e-5);  // as late as it was
  EXPECT_NEAR(*heard->rest.heading_rad, 0.5, 1e-12);
  EXPECT_EQ(heard->rest.mode, 0);
}

TEST_F(RosEndsTest, whileLyingTheGaitAloneIsATick) {
  ASSERT_TRUE(tellAndHear(standing()));
  HeardSenses told;
  told.rest.mode = 2;
  told.rest.cycles = 12;
  told.rest.is_switching = true;
  told.rest.heading_rad = -0.25;
  const auto heard = tellAndHear(told);
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->rest.mode, 2);
  EXPECT_EQ(heard->rest.cycles, 12U);
  EXPECT_TRUE(heard->rest.is_switching);
  EXPECT_FALSE(heard->scan);
}

TEST_F(RosEndsTest, aCommandIsAVelocityOrAMode) {
  const auto send_and_hear = [this](const Command& command) {
    for (const auto until = inTime(); Clock::now() < until;) {
      EXPECT_TRUE(driver->send(1, command));
      const auto heard = robot->hear(Clock::now() + milliseconds(100)).value();
      if (heard && heard->command == command) return true;
    }
    return false;
  };
  EXPECT_TRUE(send_and_hear({{0.05, -0.02, 0.25}, std::nullopt}));
  EXPECT_TRUE(send_and_hear({{}, ModeId{2}}));
  EXPECT_TRUE(send_and_hear({{0.01, 0.0, 0.0}, std::nullopt}));
}

/// A ROS 2 node, as far as DDS can tell.
struct Node {
  explicit Node(const Domain& domain) : participant(dds::createParticipant(domain).value()) {}
  dds::Entity reader(const dds_topic_descriptor_t& type, const char* name) {
    topics.push_back(dds::createTopic(participant, type, name).value());
    return dds::createReader(participant, topics.back(), {.depth = 5, .is_plain_cdr = true}).value();
  }
  dds::Entity writer(const dds_topic_descriptor_t& type, const char* name) {
    topics.push_back(dds::createTopic(participant, type, name).value());
    return dds::createWriter(participant, topics.back(), {.depth = 5, .is_plain_cdr = true}).value();
  }
  dds::Entity participant;
  std::vector<dds::Entity> topics;
};

TEST_F(RosEndsTest, aForeignNodeHearsTheSensesAndTheCommands) {
  Node node(*domain);
  const dds::Entity scans = node.reader(sensor_msgs_msg_dds__LaserScan__desc, "rt/scan");
  const dds::Entity poses = node.reader(nav_msgs_msg_dds__Odometry__desc, "rt/odom");
  const dds::Entity states = node.reader(std_msgs_msg_dds__String__desc, "rt/underway/mode_state");
  const dds::Entity velocities = node.reader(geometry_msgs_msg_dds__Twist__desc, "rt/cmd_vel");
  const dds::Entity modes = node.reader(std_msgs_msg_dds__String__desc, "rt/underway/mode");
  std::size_t beams = 0;
  double x = 0.0;
  double forward = 0.0;
  std::string state;
  std::string mode;
  for (const auto until = inTime(); Clock::now() < until;) {
    ASSERT_TRUE(robot->tell(++tick, standing().senses()));
    ASSERT_TRUE(driver->send(1, {{0.05, 0.0, 0.0}, ModeId{2}}));
    dds_sleepfor(DDS_MSECS(20));
    dds::Loan::take(scans).value()->forEach<ros::LaserScan>([&](const auto& m) { beams = m.ranges._length; });
    dds::Loan::take(poses).value()->forEach<ros::Odometry>(
        [&](const auto& m) { x = m.pose.pose.position.x; });
    dds::Loan::take(velocities).value()->forEach<ros::Twist>([&](const auto& m) { forward = m.linear.x; });
    dds::Loan::take(states).value()->forEach<ros::String>([&](const auto& m) { state = m.data; });
    dds::Loan::take(modes).value()->forEach<ros::String>([&](const auto& m) { mode = m.data; });
    if (beams > 0 && x > 0.0 && forward > 0.0 && !state.empty() && !mode.empty()) break;
  }
  EXPECT_EQ(beams, 683U);
  EXPECT_EQ(x, 1.0);
  EXPECT_EQ(forward, 0.05);
  EXPECT_EQ(state, "frontal");
  EXPECT_EQ(mode, "crawl");
}

TEST_F(RosEndsTest, aRobotThatTellsNoModesTicksWithItsScansAndSpoiltOnesArePassedOver) {
  Node node(*domain);
  const dds::Entity scans = node.writer(sensor_msgs_msg_dds__LaserScan__desc, "rt/scan");
  const auto message =
      ros::toRos(Scan{0.0, {360, -3.14, 6.28 / 359.0}, std::vector<float>(360, 2.0F)}, 5.0, {});
  std::optional<HeardSenses> heard;
  for (const auto until = inTime(); !heard && Clock::now() < until;) {
    message->header.stamp.sec += 1;
    dds_write(scans.get(), message.get());
    heard = driver->hear(Clock::now() + milliseconds(100)).value();
  }
  ASSERT_TRUE(heard && heard->scan);
  EXPECT_EQ(heard->scan->beams, Beams{});
  EXPECT_FLOAT_EQ(heard->scan->ranges_m[341], 2.0F);
  message->angle_increment = 0.0F;
  for (const auto until = inTime(); driver->fault().empty() && Clock::now() < until;) {
    dds_write(scans.get(), message.get());
    ASSERT_TRUE(driver->hear(Clock::now() + milliseconds(100)));
  }
  EXPECT_TRUE(driver->fault().starts_with("scan: angle_min")) << driver->fault();
}

TEST_F(RosEndsTest, aNameThatIsNoTopicsIsRefused) {
  RosTopics topics;
  for (const char* name : {"", "/", "my scan", "scan?"}) {
    topics.scan = name;
    const auto end = openRosDriverEnd(*domain, topics, test::nao());
    ASSERT_FALSE(end) << name;
    EXPECT_EQ(end.error().code, ErrorCode::kInvalidRequest);
  }
  topics.scan = "/front/scan_2";
  EXPECT_TRUE(openRosDriverEnd(*domain, topics, test::nao()));
}

}  // namespace
}  // namespace underway
