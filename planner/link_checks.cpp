#include "planner/link_checks.hpp"

#include <algorithm>

namespace underway {

bool LinkChecks::isFree(Roadmap::LinkId id, std::size_t way, const Legs& legs) {
  const Roadmap::Link& link = graph_.link(id);
  const Roadmap::Place& from = graph_.place(link.from);
  const Roadmap::Place& to = graph_.place(link.to);
  const double keep_m = std::min(from.keep_m, to.keep_m);
  const double margin_m = checker_.robot().margin_m;
  const double clearance_m = keep_m < margin_m ? keep_m : std::max(keep_m, legs.atLeast());
  Known& known = known_[static_cast<std::uint64_t>(id) * 32 + way];
  if (clearance_m > known.free_at_m && clearance_m < known.blocked_at_m) {
    bool is_free = true;
    if (link.crossing == Roadmap::kNone) {
      is_free = legs.isLegFree(legs.ways()[way], from.at, to.at, legs.stanceOn(link.direction_rad, way).yaw,
                               keep_m);
    } else {
      for (const Motion& motion : graph_.crossing(link).motions)
        is_free = is_free && isFreeKeeping(checker_, motion, clearance_m);
    }
    (is_free ? known.free_at_m : known.blocked_at_m) = clearance_m;
  }
  return clearance_m <= known.free_at_m;
}

TurningRoom LinkChecks::roomOf(std::uint32_t state, const Roadmap::Place& place, const Stance& stance,
                               const Legs& legs) {
  Room& known = rooms_[state];
  if (known.at_least_m != legs.atLeast())
    known = {legs.atLeast(), legs.roomAt(place.at, stance, place.keep_m)};
  return known.room;
}

}  // namespace underway
