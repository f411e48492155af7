#pragma once

#include <cstdint>
#include <memory_resource>
#include <unordered_map>

#include "planner/draft.hpp"
#include "planner/legs.hpp"

namespace underway {

/// Remembers which links are free, over all searches on one draft: those that are not checked yet, and all
/// where more clearance is asked for than they were checked with; and how far what comes by them can turn.
/// For one thread.
class LinkChecks {
 public:
  LinkChecks(const Draft& graph, const Checker& checker) : graph_(graph), checker_(checker) {}
  /// Whether a link is free by a way, keeping what `legs` asks for.
  [[nodiscard]] bool isFree(Roadmap::LinkId link, std::size_t way, const Legs& legs);
  /// How far the stance of a state can be turned where it stands; all searches give the state one number.
  [[nodiscard]] TurningRoom roomOf(std::uint32_t state, const Roadmap::Place& place, const Stance& stance,
                                   const Legs& legs);

 private:
  /// What is free with a clearance is free with less, what is blocked is blocked with more.
  struct Known {
    double free_at_m = -1.0;
    double blocked_at_m = 1e300;
  };
  struct Room {
    double at_least_m = -1.0;  // of clearance
    TurningRoom room;
  };
  const Draft& graph_;
  const Checker& checker_;
  std::pmr::monotonic_buffer_resource memory_;  // given back at once: there are thousands
  std::pmr::unordered_map<std::uint64_t, Known> known_{&memory_};
  std::pmr::unordered_map<std::uint32_t, Room> rooms_{&memory_};
};

}  // namespace underway
