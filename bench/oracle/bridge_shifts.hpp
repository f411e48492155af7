#pragma once

#include <optional>
#include <random>

#include "bench/oracle/way.hpp"

namespace underway::bench {

/// Bridges like a given one: shifted, turned, longer and shorter.
class BridgeShifts {
 public:
  /// Whether the bridge begins at the start or ends at the goal itself, and so cannot move there.
  BridgeShifts(const Terrain& terrain, bool is_start_fixed, bool is_end_fixed)
      : terrain_(terrain), is_start_fixed_(is_start_fixed), is_end_fixed_(is_end_fixed) {}

  /// One of them, free; with a given heading if there is one. By about `shift_m`, and then in half of the
  /// cases with its rail made as short as is free. Empty if it is not free.
  [[nodiscard]] std::optional<Leg> shifted(const Leg& leg, std::optional<double> yaw, double shift_m,
                                           std::mt19937_64& random) const;

 private:
  struct Form;
  [[nodiscard]] Leg legOf(const Leg& like, const Form& form) const;
  [[nodiscard]] bool isFree(const Leg& leg) const;
  void tighten(const Leg& like, Form& form) const;

  const Terrain& terrain_;
  bool is_start_fixed_;
  bool is_end_fixed_;
};

}  // namespace underway::bench
