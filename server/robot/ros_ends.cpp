#include "server/robot/ros_ends.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <utility>

#include "server/dds.hpp"
#include "server/link.hpp"
#include "server/robot/convert_ros.hpp"

namespace underway {
namespace {

constexpr std::int32_t kDepth = 10;  // as ROS 2's sensors keep

/// "/scan" and "scan" are "rt/scan" on DDS.
Expected<std::string> topicOf(const std::string& name) {
  const std::string plain = name.starts_with('/') ? name.substr(1) : name;
  const bool is_name = !plain.empty() && std::all_of(plain.begin(), plain.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '/';
  });
  if (is_name) return "rt/" + plain;
  return fail(ErrorCode::kInvalidRequest,
              "\"" + name + "\" cannot be a ROS topic: give letters, digits, _ and /");
}

/// A participant with readers and writers of ROS' topics.
class RosWire {
 public:
  static Expected<RosWire> open(const Domain& domain) {
    FirstError first;
    RosWire made;
    made.participant_ = first.unwrap(dds::createParticipant(domain));
    made.wait_set_ = first.unwrap(dds::WaitSet::create(made.participant_));
    if (first.error()) return tl::unexpected(*first.error());
    return made;
  }

  [[nodiscard]] Expected<dds::Entity> writer(const dds_topic_descriptor_t& type, const std::string& name) {
    auto topic = topicFor(type, name);
    if (!topic) return topic;
    return dds::createWriter(participant_, entities_.emplace_back(std::move(*topic)),
                             {.depth = kDepth, .is_plain_cdr = true});
  }
  [[nodiscard]] Expected<dds::Entity> reader(const dds_topic_descriptor_t& type, const std::string& name) {
    auto topic = topicFor(type, name);
    if (!topic) return topic;
    auto made = dds::createReader(participant_, entities_.emplace_back(std::move(*topic)),
                                  {.depth = kDepth, .is_best_effort = true, .is_plain_cdr = true});
    if (!made) return made;
    auto condition = dds::createReadCondition(*made);
    if (!condition) return condition;
    if (auto attached = wait_set_.attach(*condition, 1); !attached) return tl::unexpected(attached.error());
    entities_.push_back(std::move(*condition));
    return made;
  }
  [[nodiscard]] Expected<void> wait(dds::Clock::time_point until) {
    return wait_set_.wait(until).map([](const auto&) {});
  }

 private:
  [[nodiscard]] Expected<dds::Entity> topicFor(const dds_topic_descriptor_t& type, const std::string& name) {
    const auto topic = topicOf(name);
    if (!topic) return tl::unexpected(topic.error());
    return dds::createTopic(participant_, type, topic->c_str());
  }

  dds::Entity participant_;
  std::deque<dds::Entity> entities_;
  dds::WaitSet wait_set_;
};

/// Gives `use` each message that has come.
template <class Message, class Use>
Expected<void> takeAll(const dds::Entity& reader, const Use& use) {
  const auto loan = dds::Loan::take(reader);
  if (!loan) return tl::unexpected(loan.error());
  (*loan)->template forEach<Message>(use);
  return {};
}

/// Since the epoch [s].
double wallClock() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

// --- the robot's end ---------------------------------------------------------------------------------------

class RosRobotEnd final : public RobotEnd {
 public:
  RosRobotEnd(RosWire wire, std::shared_ptr<const Robot> robot)
      : wire_(std::move(wire)), robot_(std::move(robot)) {}

  Expected<void> open(const RosTopics& topics) {
    FirstError first;
    scan_ = first.unwrap(wire_.writer(sensor_msgs_msg_dds__LaserScan__desc, topics.scan));
    odom_ = first.unwrap(wire_.writer(nav_msgs_msg_dds__Odometry__desc, topics.odom));
    imu_ = first.unwrap(wire_.writer(sensor_msgs_msg_dds__Imu__desc, topics.imu));
    state_ = first.unwrap(wire_.writer(std_msgs_msg_dds__String__desc, topics.mode_state));
    cmd_vel_ = first.unwrap(wire_.reader(geometry_msgs_msg_dds__Twist__desc, topics.cmd_vel));
    mode_ = first.unwrap(wire_.reader(std_msgs_msg_dds__String__desc, topics.mode));
    if (first.error()) return tl::unexpected(*first.error());
    return {};
  }

  /// What the gait does comes last: a tick begins with it.
  Expected<void> tell(std::uint64_t, const Senses& senses) override {
    const double now_s = began_s_ + senses.now_s;
    if (senses.scan != nullptr) send(scan_, ros::toRos(*senses.scan, now_s, frames_));
    if (senses.pose)
      send(odom_, ros::toRos(PoseEstimate{began_s_ + senses.pose->stamp_s, senses.pose->pose}, frames_));
    if (senses.heading_rad) send(imu_, ros::imuOf(*senses.heading_rad, now_s, frames_));
    const ros::GaitState state{senses.mode, senses.is_switching, senses.has_fallen, senses.cycles};
    send(state_, ros::stringOf(ros::textOf(state, *robot_)));
    return {};
  }

  /// A velocity, and with it the mode that was asked for before it.
  Expected<std::optional<HeardCommand>> hear(Clock::time_point until) override {
    if (const auto woken = wire_.wait(until); !woken) return tl::unexpected(woken.error());
    const auto modes = takeAll<ros::String>(mode_, [this](const ros::String& message) {
      if (const auto text = ros::textOf(message)) wanted_ = robot_->findMode(*text);
    });
    if (!modes) return tl::unexpected(modes.error());
    std::optional<HeardCommand> newest;
    const auto velocities = takeAll<ros::Twist>(cmd_vel_, [&](const ros::Twist& message) {
      if (const auto velocity = ros::fromRos(message)) newest = HeardCommand{0, {*velocity, wanted_}};
    });
    if (!velocities) return tl::unexpected(velocities.error());
    if (newest) wanted_.reset();
    return newest;
  }

 private:
  template <class Message>
  static void send(const dds::Entity& writer, const ros::Owned<Message>& message) {
    dds_write(writer.get(), message.get());
  }

  RosWire wire_;
  std::shared_ptr<const Robot> robot_;
  ros::Frames frames_;
  double began_s_ = wallClock();
  std::optional<ModeId> wanted_;
  dds::Entity scan_;
  dds::Entity odom_;
  dds::Entity imu_;
  dds::Entity state_;
  dds::Entity cmd_vel_;
  dds::Entity mode_;
};

// --- the driver's end --------------------------------------------------------------------------------------

class RosDriverEnd final : public DriverEnd {
 public:
  RosDriverEnd(RosWire wire, std::shared_ptr<const Robot> robot, const Pose& lidar)
      : wire_(std::move(wire)), robot_(std::move(robot)), lidar_(lidar) {}

  Expected<void> open(const RosTopics& topics) {
    FirstError first;
    scan_ = first.unwrap(wire_.reader(sensor_msgs_msg_dds__LaserScan__desc, topics.scan));
    odom_ = first.unwrap(wire_.reader(nav_msgs_msg_dds__Odometry__desc, topics.odom));
    imu_ = first.unwrap(wire_.reader(sensor_msgs_msg_dds__Imu__desc, topics.imu));
    state_ = first.unwrap(wire_.reader(std_msgs_msg_dds__String__desc, topics.mode_state));
    cmd_vel_ = first.unwrap(wire_.writer(geometry_msgs_msg_dds__Twist__desc, topics.cmd_vel));
    mode_ = first.unwrap(wire_.writer(std_msgs_msg_dds__String__desc, topics.mode));
    if (first.error()) return tl::unexpected(*first.error());
    return {};
  }

  Expected<std::optional<HeardSenses>> hear(Clock::time_point until) override {
    while (true) {
      if (const auto woken = wire_.wait(until); !woken) return tl::unexpected(woken.error());
      if (const auto taken = takeNew(); !taken) return tl::unexpected(taken.error());
      if (isTick()) return tick();
      if (Clock::now() >= until) return std::optional<HeardSenses>();
    }
  }

  Expected<void> send(std::uint64_t, const Command& command) override {
    if (command.change_to) {
      const auto mode = ros::stringOf(robot_->modes.at(*command.change_to).name);
      dds_write(mode_.get(), mode.get());
    }
    const ros::Twist twist = ros::toRos(command.velocity);
    dds_write(cmd_vel_.get(), &twist);
    return {};
  }

  void flush() override { dds_wait_for_acks(cmd_vel_.get(), DDS_MSECS(200)); }
  const std::string& fault() const override { return fault_; }

 private:
  /// What came since the last tick; of each the newest.
  Expected<void> takeNew() {
    FirstError first;
    first.check(takeAll<ros::LaserScan>(scan_, [this](const ros::LaserScan& message) {
      if (keep(ros::fromRos(message, lidar_), new_.scan, "scan")) see(new_.scan->stamp_s), has_scan_ = true;
    }));
    first.check(takeAll<ros::Odometry>(odom_, [this](const ros::Odometry& message) {
      if (keep(ros::fromRos(message), new_.rest.pose, "odom")) see(new_.rest.pose->stamp_s);
    }));
    first.check(takeAll<ros::Imu>(imu_, [this](const ros::Imu& message) {
      std::optional<std::optional<double>> heading;
      if (!keep(ros::headingOf(message), heading, "imu")) return;
      new_.rest.heading_rad = *heading;
      see(ros::secondsOf(message.header.stamp));
    }));
    first.check(takeAll<ros::String>(state_, [this](const ros::String& message) {
      const auto state = ros::textOf(message).and_then(
          [this](const std::string& text) { return ros::gaitStateOf(text, *robot_); });
      has_state_ = keep(state, gait_, "mode_state") || has_state_;
      tells_state_ = tells_state_ || has_state_;
    }));
    if (first.error()) return tl::unexpected(*first.error());
    return {};
  }

  template <class Value>
  bool keep(const Expected<Value>& read, std::optional<Value>& kept, const char* topic) {
    if (read)
      kept = *read;
    else
      fault_ = std::string(topic) + ": " + read.error().message;
    return read.has_value();
  }
  /// A clock that has gone back a lot is that of a robot that started anew.
  void see(double stamp_s) {
    constexpr double kAnew_s = 5.0;
    if (stamp_s < newest_s_ - kAnew_s) newest_s_ = ticked_s_ = stamp_s;
    newest_s_ = std::max(newest_s_, stamp_s);
  }

  /// With each word of the gait, or from a robot that tells none with each scan; but not more often than the
  /// local layer ticks.
  [[nodiscard]] bool isTick() const {
    constexpr double kLeast_s = 0.09;
    if (!(tells_state_ ? has_state_ : has_scan_)) return false;
    return newest_s_ == ticked_s_ || newest_s_ - ticked_s_ >= kLeast_s;
  }

  std::optional<HeardSenses> tick() {
    HeardSenses heard = std::exchange(new_, {});
    const ros::GaitState gait = gait_.value_or(ros::GaitState{});
    heard.tick = ++ticks_;
    heard.rest.now_s = newest_s_;
    heard.rest.mode = gait.mode;
    heard.rest.is_switching = gait.is_switching;
    heard.rest.has_fallen = gait.has_fallen;
    heard.rest.cycles = gait.cycles;
    ticked_s_ = newest_s_;
    has_state_ = has_scan_ = false;
    return heard;
  }

  RosWire wire_;
  std::shared_ptr<const Robot> robot_;
  Pose lidar_;
  HeardSenses new_;
  std::optional<ros::GaitState> gait_;
  bool tells_state_ = false;  // ever
  bool has_state_ = false;    // since the last tick
  bool has_scan_ = false;
  double newest_s_ = 0.0;  // stamp of all that was heard
  double ticked_s_ = -1.0;
  std::uint64_t ticks_ = 0;
  std::string fault_;
  dds::Entity scan_;
  dds::Entity odom_;
  dds::Entity imu_;
  dds::Entity state_;
  dds::Entity cmd_vel_;
  dds::Entity mode_;
};

}  // namespace

Expected<std::unique_ptr<RobotEnd>> openRosRobotEnd(const Domain& domain, const RosTopics& topics,
                                                    std::shared_ptr<const Robot> robot) {
  auto wire = RosWire::open(domain);
  if (!wire) return tl::unexpected(wire.error());
  auto end = std::make_unique<RosRobotEnd>(std::move(*wire), std::move(robot));
  if (const auto opened = end->open(topics); !opened) return tl::unexpected(opened.error());
  return end;
}

Expected<std::unique_ptr<DriverEnd>> openRosDriverEnd(const Domain& domain, const RosTopics& topics,
                                                      std::shared_ptr<const Robot> robot) {
  auto wire = RosWire::open(domain);
  if (!wire) return tl::unexpected(wire.error());
  auto end =
      std::make_unique<RosDriverEnd>(std::move(*wire), std::move(robot), topics.lidar.value_or(Pose{}));
  if (const auto opened = end->open(topics); !opened) return tl::unexpected(opened.error());
  return end;
}

}  // namespace underway
