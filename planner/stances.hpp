#pragma once

#include <span>
#include <vector>

#include "planner/groups.hpp"
#include "planner/legs.hpp"

namespace underway {

/// The legs of all groups under one policy.
class Stances {
 public:
  Stances(const Checker& checker, Policy policy, double at_least_m = 0.0);

  [[nodiscard]] const Groups& groups() const { return groups_; }
  [[nodiscard]] GroupId groupOf(ModeId mode) const { return groups_.of_mode[mode]; }
  [[nodiscard]] const Legs& ofGroup(GroupId group) const { return legs_[group]; }
  [[nodiscard]] const Legs& ofMode(ModeId mode) const { return legs_[groupOf(mode)]; }
  [[nodiscard]] std::span<const Legs> all() const { return legs_; }
  [[nodiscard]] Policy policy() const { return policy_; }
  [[nodiscard]] double atLeast() const { return at_least_m_; }
  /// The most that the robot moves in a second, in any mode or switch [m/s]; infinite if a switch moves it in
  /// no time.
  [[nodiscard]] double highestSpeed() const { return highest_mps_; }
  /// The most ways that any group has; at least 1.
  [[nodiscard]] std::size_t mostWays() const;

 private:
  Groups groups_;
  Policy policy_;
  double at_least_m_;
  double highest_mps_;
  std::vector<Legs> legs_;  // by group
};

}  // namespace underway
