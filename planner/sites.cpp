#include "planner/sites.hpp"

#include <algorithm>
#include <cmath>

namespace underway {
namespace {

// A neighbour hidden behind a connected nearer one adds little: one connection in each cone of this
// half-angle.
constexpr double kCone_rad = 0.35;
// Where places crowd on the far side of a wall, the nearest ones lead nowhere: those after these are tried as
// well, if they belong to another part of the roadmap.
constexpr std::size_t kNeighbours = 14;
// Off the axis by less than this, a place counts as straight ahead (formats: 'along the sense's axis to
// 1e-9').
constexpr double kOffAxis_m = 1e-10;

bool standsStill(const Pose& displacement) { return displacement == Pose{}; }

/// Whether a body turned by half a revolution covers the same ground.
bool isSymmetric(const BodyBox& body) { return body.x.min == -body.x.max && body.y.min == -body.y.max; }

}  // namespace

std::vector<std::vector<ModeId>> companionsOf(const Robot& robot) {
  const std::size_t count = robot.modes.size();
  std::vector<std::vector<bool>> together(count, std::vector<bool>(count, false));
  for (std::size_t i = 0; i < count; ++i) together[i][i] = true;
  for (const Switch& change : robot.switches)
    if (standsStill(change.displacement) && robot.modes[change.from].canTurn() &&
        robot.modes[change.to].canTurn())
      together[change.from][change.to] = together[change.to][change.from] = true;
  for (std::size_t k = 0; k < count; ++k)  // Warshall's closure
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        if (together[i][k] && together[k][j]) together[i][j] = true;
  std::vector<std::vector<ModeId>> companions(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      if (together[i][j]) companions[i].push_back(static_cast<ModeId>(j));
  return companions;
}

Sites::Sites(const Checker& checker, Draft& draft, Draft::Check check)
    : checker_(checker), draft_(draft), check_(check), companions_(companionsOf(checker.robot())) {}

std::vector<Sites::PlaceId> Sites::add(ModeId mode, Point at, double keep_m) {
  const std::vector<ModeId>& modes = companions_[mode];
  std::vector<PlaceId> places;
  for (const ModeId m : modes) places.push_back(draft_.addPlace(m, at, keep_m));
  const Robot& robot = checker_.robot();
  // The last mode's twins first: so its headings reach all others (Freezer::shareHeadingsOfTwins).
  for (std::size_t second = modes.size(); second-- > 1;)
    for (std::size_t first = 0; first < second; ++first)
      if (robot.findSwitch(modes[first], modes[second]) || robot.findSwitch(modes[second], modes[first]))
        draft_.addTwins(places[first], places[second]);
  const auto own = std::find(modes.begin(), modes.end(), mode) - modes.begin();
  std::swap(places[0], places[static_cast<std::size_t>(own)]);
  return places;
}

bool Sites::isFree(PlaceId a, PlaceId b, double yaw, Sense sense) const {
  const Point from = draft_.positionOf(a);
  return checker_.isFree(translate(draft_.modeOf(a), sense, {from.x, from.y, yaw}, draft_.positionOf(b)),
                         std::min(draft_.keepOf(a), draft_.keepOf(b)));
}

bool Sites::connect(PlaceId a, PlaceId b) {
  const Mode& mode = checker_.robot().modes[draft_.modeOf(a)];
  const Point from = draft_.positionOf(a);
  const Point to = draft_.positionOf(b);
  const double way = distance(from, to);
  if (way < 1e-6) return false;
  const double direction = std::atan2(to.y - from.y, to.x - from.x);
  const auto heading_for = [&](Sense sense) {
    const double yaw = normalizedAngle(direction - angleOf(sense));
    if (const auto known = draft_.headingNear(a, yaw, kOffAxis_m / way)) return *known;
    return draft_.headingNear(b, yaw, kOffAxis_m / way).value_or(yaw);
  };
  bool connected = false;
  for (const Sense sense : {Sense::kForward, Sense::kLeft}) {
    if (!mode.canMove(sense) && !mode.canMove(opposite(sense))) continue;
    const double yaw = heading_for(sense);
    const double reversed_yaw = heading_for(opposite(sense));
    const bool later = check_ == Draft::Check::kWhenUsed;
    const bool is_free = later || isFree(a, b, yaw, sense);
    const bool is_reversed_free =
        later || (isSymmetric(mode.body_m) ? is_free : isFree(a, b, reversed_yaw, opposite(sense)));
    if (is_free) draft_.addTranslation(a, b, yaw, sense);
    if (is_reversed_free) draft_.addTranslation(a, b, reversed_yaw, opposite(sense));
    connected |= is_free || is_reversed_free;
  }
  return connected;
}

void Sites::connectAround(PlaceId place, std::span<const PlaceId> neighbours) {
  std::vector<double> taken;
  std::size_t tried = 0;
  const Point from = draft_.positionOf(place);
  for (const PlaceId neighbour : neighbours) {
    const Point to = draft_.positionOf(neighbour);
    const double direction = std::atan2(to.y - from.y, to.x - from.x);
    const bool is_hidden = std::any_of(taken.begin(), taken.end(), [&](double other) {
      return std::abs(normalizedAngle(other - direction)) < kCone_rad;
    });
    const bool is_needless = is_hidden || tried >= kNeighbours;
    if (is_needless && draft_.areJoined(place, neighbour)) continue;
    ++tried;
    if (connect(place, neighbour)) taken.push_back(direction);
  }
}

}  // namespace underway
