#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "geometry/robot.hpp"
#include "server/domain.hpp"
#include "server/robot/heard.hpp"

namespace underway {

/// The robot's end of its wire, whatever it is made of: tells senses, takes commands. Errors are those of DDS
/// (kInternal), and kInvalidRequest when several drivers command one robot, or several robots have one name,
/// over our own topics. Thread safety: none; one thread at a time.
class RobotEnd {
 public:
  using Clock = std::chrono::steady_clock;
  virtual ~RobotEnd() = default;

  /// Publishes what the senses tell now; `tick` rises by one with each.
  [[nodiscard]] virtual Expected<void> tell(std::uint64_t tick, const Senses& senses) = 0;
  /// Waits for a command; empty when the time comes first. Malformed ones are passed over.
  [[nodiscard]] virtual Expected<std::optional<HeardCommand>> hear(Clock::time_point until) = 0;
};

/// The end of what drives a robot: hears senses, sends commands.
class DriverEnd {
 public:
  using Clock = std::chrono::steady_clock;
  virtual ~DriverEnd() = default;

  /// Waits for what the senses tell, the newest if there is more; empty when the time comes first.
  [[nodiscard]] virtual Expected<std::optional<HeardSenses>> hear(Clock::time_point until) = 0;
  /// `tick` is that of the senses it answers, 0 for none.
  [[nodiscard]] virtual Expected<void> send(std::uint64_t tick, const Command& command) = 0;
  /// Waits, for a moment at most, until what was sent has arrived: for a last command.
  virtual void flush() = 0;
  /// What was wrong with the last message that was passed over because it was malformed; empty if none was.
  [[nodiscard]] virtual const std::string& fault() const = 0;
};

/// Over our own topics (idl/underway.idl), in the partition of the robot's name. Errors: kInvalidRequest for
/// a name that cannot be a robot's, kInternal when DDS refuses.
[[nodiscard]] Expected<std::unique_ptr<RobotEnd>> openRobotEnd(const Domain& domain, const std::string& name,
                                                               std::shared_ptr<const Robot> robot);
[[nodiscard]] Expected<std::unique_ptr<DriverEnd>> openDriverEnd(const Domain& domain,
                                                                 const std::string& name,
                                                                 std::shared_ptr<const Robot> robot);

}  // namespace underway
