#include "local/seen_floor.hpp"

#include <algorithm>

namespace underway {

SeenFloor::SeenFloor() : is_seen_(Grid::kCount) {}

void SeenFloor::slideTo(Point at) {
  grid_.slideTo(at, [this](std::size_t i) { is_seen_[i] = 0; });
}

void SeenFloor::pass(Point from, Point to) {
  const double far_m = std::min({distance(from, to) - kShort_m, kFar_m, grid_.toEdge(from)});
  Grid::visitAlong(from, to, far_m, [cells = is_seen_.data()](std::size_t i) { cells[i] = 1; });
}

void SeenFloor::mark(Point at) {
  if (const Grid::Place place = Grid::placeOf(at); grid_.isInside(place)) is_seen_[Grid::indexOf(place)] = 1;
}

}  // namespace underway
