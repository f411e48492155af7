#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>

#include "planner/plan.hpp"

namespace underway {

/// What a server plans in and for. Every reply says it.
struct Served {
  Robot robot;
  std::string map_name;
  std::uint64_t revision = 0;  ///< of the world
  std::string world_hash;
  std::string robot_hash;
  std::uint64_t seed = 0;  ///< of the roadmap
};

/// Answers one request; called from several threads at once. Should return kTimeout when the deadline passes
/// and kCancelled when told to stop.
using PlanHandler = std::function<Expected<Plan>(
    const Request&, std::chrono::steady_clock::time_point deadline, std::stop_token)>;

}  // namespace underway
