#pragma once

#include "apps/exit_code.hpp"
#include "local/mission.hpp"
#include "server/robot/follower.hpp"

namespace underway {

/// What is noted of a journey as it goes, for its last words.
class Journal {
 public:
  /// Notes a tick; returns the time since the first [s].
  double tick(const Mission& mission) {
    plans_ = mission.plans();
    return 0.1 * static_cast<double>(ticks_++);
  }
  /// Of all ticks [s].
  [[nodiscard]] double time() const { return 0.1 * static_cast<double>(ticks_); }
  [[nodiscard]] int plans() const { return plans_; }

 private:
  unsigned long ticks_ = 0;
  int plans_ = 0;
};

/// "arrived after 63.2 s and 2 plans", "there is no way after ...: why".
[[nodiscard]] std::string describe(const JourneyEnd& end, const Journal& journal);
[[nodiscard]] ExitCode exitCodeOf(const JourneyEnd& end);
/// Tells how it ended on standard output; an error on standard error.
[[nodiscard]] ExitCode deliverJourney(const Expected<JourneyEnd>& end, const Journal& journal);

}  // namespace underway
