#include "server/robot/convert_ros.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/server/robot/robot_fixture.hpp"

namespace underway::ros {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint64_t kSeeds = 200;

const Robot& nao() { return *test::nao(); }

TEST(ConvertRos, typesAreNamedAsRosNamesThem) {
  EXPECT_STREQ(sensor_msgs_msg_dds__LaserScan__desc.m_typename, "sensor_msgs::msg::dds_::LaserScan_");
  EXPECT_STREQ(sensor_msgs_msg_dds__Imu__desc.m_typename, "sensor_msgs::msg::dds_::Imu_");
  EXPECT_STREQ(nav_msgs_msg_dds__Odometry__desc.m_typename, "nav_msgs::msg::dds_::Odometry_");
  EXPECT_STREQ(geometry_msgs_msg_dds__Twist__desc.m_typename, "geometry_msgs::msg::dds_::Twist_");
  EXPECT_STREQ(std_msgs_msg_dds__String__desc.m_typename, "std_msgs::msg::dds_::String_");
}

TEST(ConvertRos, scansArriveAsTheyWereSeen) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const HeardSenses told = fixture::randomSenses(seed);
    if (!told.scan) continue;
    const auto message = toRos(*told.scan, 1.7e9 + 0.25, {});
    EXPECT_STREQ(message->header.frame_id, "base_link");
    const auto heard = fromRos(*message, {});
    ASSERT_TRUE(heard) << heard.error().message;
    EXPECT_DOUBLE_EQ(heard->stamp_s, 1.7e9 + 0.25);
    std::size_t same = 0;
    for (std::size_t i = 0; i < Beams{}.count; ++i)
      same += heard->ranges_m[i] == told.scan->ranges_m[i] ? 1 : 0;
    // Angles in single precision: a beam may fall to its neighbour now and then.
    EXPECT_GE(same, Beams{}.count - 20) << "seed " << seed;
  }
}

TEST(ConvertRos, scansAreRefusedByField) {
  const Scan scan{0.0, Beams{}, std::vector<float>(Beams{}.count, 1.0F)};
  const std::pair<const char*, void (*)(LaserScan&)> cases[] = {
      {"angle_min", [](auto& message) { message.angle_min = kNan; }},
      {"angle_min", [](auto& message) { message.angle_increment = 0.0F; }},
      {"angle_min", [](auto& message) { message.angle_increment = 0.5F; }},
      {"ranges are 683", [](auto& message) { message.angle_max = 0.0F; }},
      {"ranges are 683", [](auto& message) { message.angle_max = kNan; }},
      {"ranges are 500", [](auto& message) { message.ranges._length = 500; }},
      {"ranges must", [](auto& message) { message.ranges._length = 3'000'000'000U; }},
      {"range_min", [](auto& message) { message.range_min = kNan; }},
      {"range_min", [](auto& message) { message.range_max = -1.0F; }},
  };
  for (const auto& [field, spoil] : cases) {
    const auto message = toRos(scan, 0.0, {});
    spoil(*message);
    const auto heard = fromRos(*message, {});
    ASSERT_FALSE(heard) << field;
    EXPECT_TRUE(heard.error().message.starts_with(field)) << heard.error().message;
    message->ranges._length = Beams{}.count;  // to be freed as it was made
  }
}

TEST(ConvertRos, whatIsNoMeasurementTellsNothing) {
  Scan scan{0.0, Beams{}, std::vector<float>(Beams{}.count, 2.0F)};
  const auto message = toRos(scan, 0.0, {});
  message->range_min = 0.05F;
  message->range_max = 5.0F;
  for (const float no_range : {kNan, 0.0F, -1.0F, 0.04F, 5.1F, Scan::kNothing}) {
    message->ranges._buffer[340] = message->ranges._buffer[341] = message->ranges._buffer[342] = no_range;
    const auto heard = fromRos(*message, {});
    ASSERT_TRUE(heard);
    const bool met_nothing = no_range > message->range_max;
    EXPECT_EQ(heard->ranges_m[341], met_nothing ? Scan::kNothing : Scan::kNotLooked) << no_range;
    EXPECT_EQ(heard->ranges_m[100], 2.0F) << no_range;
  }
}

TEST(ConvertRos, driversThatCountTheEndBehindTheLastBeamAreUnderstood) {
  const auto message = toRos({0.0, Beams{}, std::vector<float>(Beams{}.count, 1.0F)}, 0.0, {});
  message->angle_max += message->angle_increment;
  EXPECT_TRUE(fromRos(*message, {}));
  message->angle_max += message->angle_increment;
  EXPECT_FALSE(fromRos(*message, {}));
}

TEST(ConvertRos, posesAndHeadingsArriveAsTheyWereTold) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto told = fixture::randomSenses(seed).rest.pose;
    if (!told) continue;
    const auto message = toRos(*told, {});
    EXPECT_STREQ(message->header.frame_id, "map");
    EXPECT_STREQ(message->child_frame_id, "base_link");
    const auto pose = fromRos(*message);
    ASSERT_TRUE(pose) << pose.error().message;
    EXPECT_EQ(pose->pose.position(), told->pose.position());
    EXPECT_NEAR(pose->pose.yaw, told->pose.yaw, 1e-12);
    EXPECT_NEAR(pose->stamp_s, told->stamp_s, 2e-9);
    const auto heading = headingOf(*imuOf(told->pose.yaw, 1.0, {}));
    ASSERT_TRUE(heading && *heading);
    EXPECT_NEAR(**heading, told->pose.yaw, 1e-12);
  }
}

TEST(ConvertRos, posesThatAreNoneAreRefused) {
  const auto good = toRos(PoseEstimate{1.0, {1.0, 2.0, 0.5}}, {});
  const std::pair<const char*, void (*)(Odometry&)> cases[] = {
      {"pose.position", [](auto& message) { message.pose.pose.position.x = kNan; }},
      {"pose.position", [](auto& message) { message.pose.pose.position.y = 2e5; }},
      {"pose.orientation", [](auto& message) { message.pose.pose.orientation.w = kNan; }},
      {"pose.orientation",
       [](auto& message) {
         message.pose.pose.orientation = {0, 0, 0, 0};
       }},
      {"pose.orientation",
       [](auto& message) {
         message.pose.pose.orientation = {0, 0, 1, 1};
       }},
  };
  for (const auto& [field, spoil] : cases) {
    Odometry message = *good;  // shares its texts
    spoil(message);
    const auto pose = fromRos(message);
    ASSERT_FALSE(pose) << field;
    EXPECT_TRUE(pose.error().message.starts_with(field)) << pose.error().message;
  }
  const auto imu = imuOf(0.5, 1.0, {});
  imu->orientation_covariance[0] = -1.0;  // it says that it has none
  EXPECT_FALSE(headingOf(*imu).value());
  imu->orientation_covariance[0] = 0.0;
  imu->orientation.z = kNan;
  EXPECT_FALSE(headingOf(*imu));
}

TEST(ConvertRos, velocitiesArriveAndAreRefusedOutOfRange) {
  const Velocity velocity{0.05, -0.02, 0.3};
  EXPECT_EQ(fromRos(toRos(velocity)).value(), velocity);
  for (const double bad : {static_cast<double>(kNan), 11.0, -1e300}) {
    EXPECT_FALSE(fromRos(toRos({bad, 0.0, 0.0})));
    EXPECT_FALSE(fromRos(toRos({0.0, bad, 0.0})));
    EXPECT_FALSE(fromRos(toRos({0.0, 0.0, bad})));
  }
}

TEST(ConvertRos, theGaitsWordArrivesAsItWasTold) {
  for (const GaitState& state : {GaitState{0, false, false, 0}, GaitState{2, true, false, 17},
                                 GaitState{1, false, true, 0}, GaitState{2, true, true, ~0ULL}})
    EXPECT_EQ(gaitStateOf(textOf(state, nao()), nao()).value(), state) << textOf(state, nao());
  EXPECT_EQ(textOf(GaitState{2, true, false, 17}, nao()), "crawl changing cycles=17");
  EXPECT_EQ(gaitStateOf("crawl  cycles=3 ", nao()).value(), (GaitState{2, false, false, 3}));
}

TEST(ConvertRos, whatNoGaitSaysIsRefused) {
  for (const char* text : {"", " ", "fly", "crawl flying", "crawl cycles=", "crawl cycles=-1",
                           "crawl cycles=1x", "changing crawl", "crawl cycles=99999999999999999999"})
    EXPECT_FALSE(gaitStateOf(text, nao())) << text;
  String none{};
  EXPECT_FALSE(textOf(none));
  EXPECT_EQ(textOf(*stringOf("crawl")).value(), "crawl");
}

}  // namespace
}  // namespace underway::ros
