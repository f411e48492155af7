#include <algorithm>
#include <utility>
#include <vector>

#include "server/dds.hpp"
#include "server/link.hpp"
#include "server/question.hpp"
#include "server/robot/convert_robot.hpp"
#include "server/robot/robot_end.hpp"

namespace underway {
namespace {

constexpr const char* kSensesTopic = "underway/senses";
constexpr const char* kCommandTopic = "underway/command";

/// Whom the samples come from. A writer may follow another for good, as one that was started anew does; one
/// that comes again after another is alive beside it.
class Writers {
 public:
  void hear(dds_instance_handle_t writer) {
    if (writer == current_) return;
    if (current_ != 0) former_.push_back(current_);
    current_ = writer;
    are_several_ = are_several_ || std::ranges::find(former_, writer) != former_.end();
  }
  [[nodiscard]] bool areSeveral() const { return are_several_; }

 private:
  dds_instance_handle_t current_ = 0;  // none yet
  std::vector<dds_instance_handle_t> former_;
  bool are_several_ = false;
};

/// A topic that is written and one that is read, in the partition of a robot's name. Keeps the newest alone.
class Channel {
 public:
  struct Topic {
    const dds_topic_descriptor_t& type;
    const char* name;
  };
  /// `others`: what several who write `in` are told by, up to the name.
  static Expected<Channel> open(const Domain& domain, const std::string& robot, Topic out, Topic in,
                                const std::string& others) {
    if (!isRobotName(robot))
      return fail(ErrorCode::kInvalidRequest, "the robot's name must be 1 to 64 of A-Z a-z 0-9 _ -");
    Channel made;
    made.several_ = others + " \"" + robot + "\": give each its own --name";
    FirstError first;
    made.participant_ = first.unwrap(dds::createParticipant(domain));
    made.out_ = first.unwrap(dds::createTopic(made.participant_, out.type, out.name));
    made.in_ = first.unwrap(dds::createTopic(made.participant_, in.type, in.name));
    made.writer_ = first.unwrap(dds::createWriter(made.participant_, made.out_, {.partition = robot}));
    made.reader_ = first.unwrap(dds::createReader(made.participant_, made.in_, {.partition = robot}));
    made.has_data_ = first.unwrap(dds::createReadCondition(made.reader_));
    made.wait_set_ = first.unwrap(dds::WaitSet::create(made.participant_));
    first.check(made.wait_set_.attach(made.has_data_, 1));
    if (first.error()) return tl::unexpected(*first.error());
    return made;
  }

  /// A reader that does not keep up misses some; it wants the newest.
  void write(const void* sample) const { dds_write(writer_.get(), sample); }
  void flush() const { dds_wait_for_acks(writer_.get(), DDS_MSECS(200)); }

  /// Waits for a sample that can be read, and gives the newest; empty when the time comes first. `refuse`
  /// gets the errors of the others. Errors: kInvalidRequest if several write.
  template <class Heard, class Wire, class Refuse>
  Expected<std::optional<Heard>> hear(dds::Clock::time_point until, const Robot& robot,
                                      const Refuse& refuse) {
    std::optional<Heard> newest;
    while (true) {
      const auto woken = wait_set_.wait(until);
      if (!woken) return tl::unexpected(woken.error());
      const auto loan = dds::Loan::take(reader_);
      if (!loan) return tl::unexpected(loan.error());
      (*loan)->template forEachFrom<Wire>([&](const Wire& wire, dds_instance_handle_t writer) {
        writers_.hear(writer);
        if (auto heard = fromWire(wire, robot))
          newest = std::move(*heard);
        else
          refuse(heard.error());
      });
      if (writers_.areSeveral()) return fail(ErrorCode::kInvalidRequest, several_);
      if (newest || dds::Clock::now() >= until) return newest;
    }
  }

 private:
  std::string several_;  // the sentence for several writers
  Writers writers_;
  dds::Entity participant_;
  dds::Entity out_;
  dds::Entity in_;
  dds::Entity writer_;
  dds::Entity reader_;
  dds::Entity has_data_;
  dds::WaitSet wait_set_;
};

class OwnRobotEnd final : public RobotEnd {
 public:
  OwnRobotEnd(Channel channel, std::shared_ptr<const Robot> robot)
      : channel_(std::move(channel)), robot_(std::move(robot)) {}

  Expected<void> tell(std::uint64_t tick, const Senses& senses) override {
    channel_.write(toWire(tick, senses, *robot_).get());
    return {};
  }

  Expected<std::optional<HeardCommand>> hear(Clock::time_point until) override {
    return channel_.hear<HeardCommand, underway_Command>(until, *robot_, [](const Error&) {});
  }

 private:
  Channel channel_;
  std::shared_ptr<const Robot> robot_;
};

class OwnDriverEnd final : public DriverEnd {
 public:
  OwnDriverEnd(Channel channel, std::shared_ptr<const Robot> robot)
      : channel_(std::move(channel)), robot_(std::move(robot)) {}

  Expected<std::optional<HeardSenses>> hear(Clock::time_point until) override {
    return channel_.hear<HeardSenses, underway_Senses>(
        until, *robot_, [this](const Error& error) { fault_ = error.message; });
  }

  Expected<void> send(std::uint64_t tick, const Command& command) override {
    const underway_Command wire = toWire(tick, command, *robot_);
    channel_.write(&wire);
    return {};
  }

  void flush() override { channel_.flush(); }
  const std::string& fault() const override { return fault_; }

 private:
  Channel channel_;
  std::shared_ptr<const Robot> robot_;
  std::string fault_;
};

}  // namespace

Expected<std::unique_ptr<RobotEnd>> openRobotEnd(const Domain& domain, const std::string& name,
                                                 std::shared_ptr<const Robot> robot) {
  auto channel = Channel::open(domain, name, {underway_Senses_desc, kSensesTopic},
                               {underway_Command_desc, kCommandTopic}, "two drivers command the robot");
  if (!channel) return tl::unexpected(channel.error());
  return std::make_unique<OwnRobotEnd>(std::move(*channel), std::move(robot));
}

Expected<std::unique_ptr<DriverEnd>> openDriverEnd(const Domain& domain, const std::string& name,
                                                   std::shared_ptr<const Robot> robot) {
  auto channel =
      Channel::open(domain, name, {underway_Command_desc, kCommandTopic},
                    {underway_Senses_desc, kSensesTopic}, "two robots tell what they sense under the name");
  if (!channel) return tl::unexpected(channel.error());
  return std::make_unique<OwnDriverEnd>(std::move(*channel), std::move(robot));
}

}  // namespace underway
