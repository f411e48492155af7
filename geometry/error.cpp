#include "geometry/error.hpp"

#include <array>

namespace underway {

std::string_view name(ErrorCode code) {
  static constexpr std::array<std::string_view, kErrorCodeCount> kNames{
      "start_in_collision", "goal_in_collision", "start_out_of_bounds", "goal_out_of_bounds",
      "no_path_exists",     "timeout",           "cancelled",           "busy",
      "invalid_request",    "invalid_map",       "invalid_robot",       "stale_revision",
      "no_server",          "internal"};
  return kNames.at(static_cast<std::size_t>(code));
}

}  // namespace underway
