#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "geometry/world.hpp"
#include "planner/plan.hpp"

namespace underway::bench {

/// What the one passage of a room asks of NAO (robots/nao.yaml).
enum class Need : std::uint8_t {
  kFrontalWidth,  ///< out of a slot too narrow to turn in, through its mouth
  kLateralWidth,  ///< sideways through a gap in a wall
  kCrawlHeight,   ///< under a beam
  kRunIn,         ///< room to lie down in front of a table
  kSwitchBox,     ///< room to get up behind a table
};
inline constexpr std::array kNeeds{Need::kFrontalWidth, Need::kLateralWidth, Need::kCrawlHeight, Need::kRunIn,
                                   Need::kSwitchBox};
/// "frontal width", "lateral width", "crawl height", "run-in", "switch box".
[[nodiscard]] std::string_view name(Need need);

/// A world and a query in it.
struct Room {
  std::shared_ptr<const World> world;
  Request request;
};

/// Two rooms with one passage between them, that leaves `slack_m` more than it needs: below 0 there is no way
/// from start to goal. Some clutter stands elsewhere; all is turned and moved at random. The same seed gives
/// the same room but for the slack. That a room can be passed at all is for a planner to say: clutter may be
/// in the way.
[[nodiscard]] Room roomWith(Need need, double slack_m, std::uint64_t seed);

/// Obstacles at random, start and goal among them, in any of NAO's modes; whether there is a way is open.
[[nodiscard]] Room clutteredRoom(std::uint64_t seed);

}  // namespace underway::bench
