#include <array>
#include <cmath>

#include "bench/planner_parts.hpp"

namespace underway::bench {
namespace {

constexpr std::array kSpare_m{0.02, 0.04, 0.08};
constexpr std::chrono::milliseconds kDeadline{100};
constexpr double kLength_m = 5.0;  // of the room
constexpr double kWidth_m = 3.0;
constexpr double kWall_m = 0.1;  // thick, in the middle
constexpr double kLintel_m = 0.05;

Obstacle block(const char* id, Range x, Range y, Range z) {
  return {id, OrientedBox{{0.5 * (x.min + x.max), 0.5 * (y.min + y.max), 0.5 * (z.min + z.max)},
                          {x.length(), y.length(), z.length()},
                          {}}};
}

/// What a passage is for: a mode, how wide a gap its body and margins fill, and how high it is.
struct Passage {
  std::string mode;
  double filled_m = 0.0;
  double height_m = 10.0;
};

/// The least a crawl has to cover to get under a wall: from where lying down ends to where standing up
/// begins.
double crawlUnderWall(const Robot& robot, const Switch& down, const Switch& up) {
  const double begins = down.body_m.x.max + robot.margin_m - down.displacement.x;
  return begins + kWall_m + robot.margin_m - up.body_m.x.min;
}

std::vector<Passage> passagesOf(const Robot& robot) {
  std::vector<Passage> passages;
  for (std::size_t i = 0; i < robot.modes.size(); ++i) {
    const Mode& mode = robot.modes[i];
    const Switch* down = robot.findSwitch(0, static_cast<ModeId>(i));
    const Switch* up = robot.findSwitch(static_cast<ModeId>(i), 0);
    const bool is_low = mode.body_m.z.max < robot.modes.front().body_m.z.max;
    const bool goes_ahead = mode.canMove(Sense::kForward);
    const double body_m = (goes_ahead ? mode.body_m.y : mode.body_m.x).length();
    const double drift_m = is_low && down != nullptr && up != nullptr
                               ? 2.0 * mode.drift_m_per_m * crawlUnderWall(robot, *down, *up)
                               : 0.0;
    passages.push_back(
        {mode.name, body_m + 2.0 * robot.margin_m + drift_m, is_low ? mode.body_m.z.max + 0.05 : 10.0});
  }
  return passages;
}

/// Two halves of a room and a wall between them, with a gap that is not in its middle.
Expected<World> roomWith(const Passage& passage, double spare_m) {
  const double middle = 0.4 * kWidth_m;
  const double gap_m = passage.filled_m + spare_m;
  const Range x{0.5 * (kLength_m - kWall_m), 0.5 * (kLength_m + kWall_m)};
  const Range gap{middle - 0.5 * gap_m, middle + 0.5 * gap_m};
  std::vector<Obstacle> walls{block("below", x, {0.0, gap.min}, {0.0, 1.0}),
                              block("above", x, {gap.max, kWidth_m}, {0.0, 1.0})};
  if (passage.height_m < 1.0)
    walls.push_back(block("lintel", x, gap, {passage.height_m, passage.height_m + kLintel_m}));
  return World::make("gap", {{0.0, 0.0, 0.0}, kLength_m, kWidth_m}, 0.0, std::move(walls));
}

}  // namespace

Expected<void> addNarrow(const PlannerOptions& options, Report& report, const Progress& progress) {
  const auto robot = naoOf(options);
  if (!robot) return tl::unexpected(robot.error());
  const unsigned long seeds = options.quick ? 10 : 100;
  const auto passages = passagesOf(**robot);
  double done = 0.0;
  for (const Passage& passage : passages)
    for (const double spare_m : kSpare_m) {
      auto made = roomWith(passage, spare_m);
      if (!made) return tl::unexpected(made.error());
      const auto world = std::make_shared<const World>(std::move(*made));
      const Request request{{0.8, 2.2, 0.0}, 0, {4.2, 2.2}, 0.0, 0, Policy::kPriority};
      unsigned long solved = 0;
      std::vector<double> took_ms;
      for (unsigned long seed = 1; seed <= seeds; ++seed) {
        const auto start = Planner::Clock::now();
        Planner planner(world, *robot, {seed, GrowthSettings{}.sites_per_m2});
        solved += planner.plan(request, start + kDeadline) ? 1 : 0;
        took_ms.push_back(std::chrono::duration<double, std::milli>(Planner::Clock::now() - start).count());
        progress(done += 1.0 / static_cast<double>(passages.size() * kSpare_m.size() * seeds));
      }
      const std::string what = "gap for " + passage.mode + " with " +
                               std::to_string(std::lround(spare_m * 100)) + " cm to spare: ";
      const double percent = 100.0 * static_cast<double>(solved) / static_cast<double>(seeds);
      report.rows.push_back(
          {what + "solved within 100 ms", percent, "%", "100", solved == seeds, 1, seeds, {}, {}});
      report.rows.push_back({what + "p50", quantile(took_ms, 0.5), "ms", "", {}, 1, seeds, {}, {}});
    }
  return {};
}

}  // namespace underway::bench
