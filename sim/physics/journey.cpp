#include "sim/physics/journey.hpp"

#include <cmath>
#include <stdexcept>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/player.hpp"

namespace underway::physics {
namespace {

constexpr double kTop_m = 0.03;
constexpr double kLeg_m = 0.04;
constexpr double kRoomToGetUp_m = 0.30;  ///< from the hips back to the feet, and some
constexpr double kRest_s = 1.0;

void add(std::set<std::string>& all, const Recording& recording) {
  all.insert(recording.touches.begin(), recording.touches.end());
}

bool isUpright(const Sample& sample) {
  constexpr double kMostLean_rad = 0.1;
  constexpr double kLeastHip_m = 0.23;  // .248 with straight legs
  return std::abs(sample.pitch_rad) < kMostLean_rad && sample.hip_height_m > kLeastHip_m;
}

}  // namespace

std::vector<OrientedBox> boxesOf(const Table& table) {
  const double middle = table.from_m + 0.5 * table.depth_m;
  std::vector<OrientedBox> boxes{{{middle, 0.0, table.clear_m + 0.5 * kTop_m},
                                  {table.depth_m, table.width_m + 2.0 * kLeg_m, kTop_m},
                                  {}}};
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      boxes.push_back(
          {{middle + x * (table.depth_m - kLeg_m), y * (table.width_m + kLeg_m), 0.5 * table.clear_m},
           {kLeg_m, kLeg_m, table.clear_m},
           {}});
  return boxes;
}

Expected<Journey> crawlUnder(const std::filesystem::path& robot, const Table& table,
                             const gait::CrawlGait& gait, const Conditions& conditions) {
  auto simulation = Simulation::make(robot, {.ground = {}, .obstacles = boxesOf(table)}, conditions);
  if (!simulation) return tl::unexpected(simulation.error());
  auto player = gait::CrawlPlayer::make(gait::naoCrawler(), gait);
  if (!player) throw std::invalid_argument("NAO cannot crawl so: " + player.error().message);
  const gait::JointTable down = player->down(0.0);
  simulation->start(down, Posture::kStanding, {});
  Journey journey;
  const Pose start = simulation->now().standing;
  journey.down = simulation->play(down, Posture::kStanding);
  journey.lying_after_down = relative(start, simulation->now().lying);
  const double behind = table.from_m + table.depth_m + kRoomToGetUp_m;
  journey.crawl = crawlLine(*simulation, *player, behind - simulation->now().lying.x);
  const Pose lay = simulation->now().lying;
  journey.up = simulation->play(player->up(), Posture::kLying);
  const Recording rest = simulation->hold(kRest_s, Posture::kStanding);
  journey.standing_after_up = relative(lay, simulation->now().standing);
  journey.end = relative(start, simulation->now().standing);
  journey.stands = isUpright(simulation->now());
  for (const Recording* recording : {&std::as_const(journey.down), &std::as_const(journey.up), &rest})
    add(journey.touches, *recording);
  for (const Recording& recording : journey.crawl.recordings) add(journey.touches, recording);
  return journey;
}

}  // namespace underway::physics
