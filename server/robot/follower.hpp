#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "local/mission.hpp"
#include "server/robot/robot_end.hpp"

namespace underway {

struct FollowerSettings {
  /// Waits for each senses for as long as it takes, and for each plan: the robot waits for the commands too,
  /// so that time stands still meanwhile. Else the clock goes on: silence is a tick without senses.
  bool is_in_step = false;
  std::chrono::milliseconds period{100};          ///< of the robot's senses
  std::chrono::milliseconds robot_timeout{5000};  ///< how long to look for a robot
  std::chrono::seconds robot_silent{30};          ///< when a robot that was heard is given up
  std::chrono::seconds server_silent{30};         ///< when a server that a plan is needed from is given up
};

/// Where a robot was met.
struct Met {
  std::optional<Pose> pose;  ///< the mean of a few fixes; empty if it tells none
  ModeId mode = 0;
};

/// How a journey ended.
struct JourneyEnd {
  Mission::Outcome outcome = Mission::Outcome::kUnderway;  ///< kUnderway: it was stopped
  std::string why;
};

/// Drives a robot over its wire: hears its senses, runs a mission on them, sends its commands. The last thing
/// it sends is to stand still. Thread safety: none; one thread.
class Follower {
 public:
  /// Called after each tick, with the senses that were heard last.
  using Watch = std::function<void(const Mission&, const Tick&, const HeardSenses&)>;

  Follower(std::unique_ptr<DriverEnd> end, const FollowerSettings& settings)
      : end_(std::move(end)), settings_(settings) {}

  /// Listens until it knows where the robot is, which it leaves standing still. Errors: kInternal if no robot
  /// is heard in time or DDS fails, kCancelled when told to stop.
  [[nodiscard]] Expected<Met> meet(const std::stop_token& stop);

  /// Drives to the goal. Errors: those of the source that are no answers, like kNoServer (at once if there is
  /// no plan yet, else when it stays away), kInvalidRequest; kInternal if the robot is not heard any
  /// more or DDS fails.
  [[nodiscard]] Expected<JourneyEnd> drive(const std::shared_ptr<const World>& map,
                                           const std::shared_ptr<const Robot>& robot, const Request& request,
                                           PlanSource source, const std::stop_token& stop,
                                           const Watch& watch = {});

 private:
  [[nodiscard]] Expected<bool> listen(const std::stop_token& stop);
  [[nodiscard]] Senses sensesNow();
  [[nodiscard]] Expected<void> answer(const Command& command);
  [[nodiscard]] std::optional<Error> giveUp(const Mission& mission) const;
  [[nodiscard]] Error unheard() const;

  using Clock = DriverEnd::Clock;
  std::unique_ptr<DriverEnd> end_;
  FollowerSettings settings_;
  HeardSenses heard_;
  bool has_heard_ = false;  // ever
  bool is_fresh_ = false;   // the newest has not been acted upon
  Command last_;            // what was sent
  double now_s_ = 0.0;      // our own clock: ticks
  Clock::time_point heard_at_ = Clock::now();
  std::optional<Error> refused_;  // by the source, the last time it was asked
  Clock::time_point served_at_ = Clock::now();
};

}  // namespace underway
