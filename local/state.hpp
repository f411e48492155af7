#pragma once

#include <cstdint>
#include <string_view>

namespace underway {

/// What the executor is doing.
enum class State : std::uint8_t {
  kIdle,       ///< stands (or lies) still: no plan
  kSettling,   ///< stands still until it knows where it is
  kWalking,    ///< goes along a standing segment, or turns
  kAligning,   ///< stands before a low passage and brings position and heading into its slack
  kGoingDown,  ///< changes to a lower mode
  kCrawling,   ///< goes along a lying segment, cycle by cycle
  kGettingUp,  ///< changes to a higher mode
  kArrived,    ///< stands at the goal
  kBlocked,    ///< stands still; wants a new plan, from here, in a world with what it saw
  kLost,       ///< stands still; localisation is silent
  kFallen,     ///< sends no motion; wants help, then a new plan
  kStalled,    ///< lies still; the crawl does not progress, or there is no room to get up; wants help
};
[[nodiscard]] std::string_view name(State state);

/// Which kind of segment comes next.
enum class Next : std::uint8_t { kNothing, kMove, kDown, kCrawl, kUp };

/// All that the next state depends on.
struct Situation {
  bool has_plan = false;
  bool has_fallen = false;
  bool is_settled = false;  ///< enough fixes of localisation in a row
  bool is_lost = false;     ///< standing, and localisation is silent for too long
  bool is_blocked =
      false;  ///< something unmapped in the way and no room round it, no progress, or far from the plan
  bool is_switching = false;  ///< the gait is between two modes
  bool is_aligned = false;    ///< within the next passage's slack
  bool has_room_up = false;   ///< the standing body is free here, by the map
  bool is_stalled =
      false;  ///< no crawl cycle or change of mode ends, or nothing is left to crawl and no room
  Next next = Next::kNothing;
};

/// The state machine: every transition there is, on one screen. What each state waits for and sends is the
/// executor's; what each reports, docs/local.md's.
[[nodiscard]] State transition(State now, const Situation& is);

}  // namespace underway
