#include "sim/physics/crawl_figures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gait/crawl/crawler.hpp"

namespace underway::physics {
namespace {

/// A stretch of a motion.
gait::JointTable part(const gait::JointTable& whole, double from_s, double to_s) {
  gait::JointTable table(whole.joints());
  table.append(from_s, whole.sample(from_s));
  for (std::size_t row = 0; row < whole.rows(); ++row)
    if (whole.time(row) > from_s && whole.time(row) < to_s) table.append(whole.time(row), whole.angles(row));
  table.append(to_s, whole.sample(to_s));
  return table;
}

double slipOf(const Recording& recording, const std::array<const char*, 2>& shapes) {
  double most = 0.0;
  for (const char* shape : shapes)
    if (const auto slip = recording.slips_m.find(shape); slip != recording.slips_m.end())
      most = std::max(most, slip->second);
  return most;
}

void addPush(CrawlFigures& figures, const Recording& push, double share) {
  figures.toe_slip_m += share * slipOf(push, {"l_ankle_toe", "r_ankle_toe"});
  figures.elbow_slip_m += share * slipOf(push, {"LForeArm", "RForeArm"});
  figures.torque_cost += share * torqueCost(push, {1.0, 1.0, 1.0, 5.0});
  figures.even_cost += share * torqueCost(push, {1.0, 1.0, 1.0, 1.0});
  for (const auto& [servo, effort] : push.efforts) figures.saturated_s += share * effort.saturated_s;
  for (std::size_t joint = 0; joint < 4; ++joint) {
    std::vector<double> only(4, 0.0);
    only[joint] = 1.0;
    figures.rms_nm[joint] += share * std::sqrt(torqueCost(push, only) / push.duration_s);
  }
}

void widen(CrawlFigures& figures, const BodyBox& box) {
  figures.box = {hull(figures.box.x, box.x), hull(figures.box.y, box.y), hull(figures.box.z, box.z)};
}

}  // namespace

CrawlFigures measureCrawl(Simulation& simulation, const gait::CrawlGait& gait, int cycles) {
  if (cycles < 2) throw std::invalid_argument("a crawl is measured in at least two cycles");
  const auto cycle = gait::crawlMotion(gait::naoCrawler(), gait);
  if (!cycle) throw std::invalid_argument("NAO cannot crawl so: " + cycle.error().message);
  const double pushes = gait.times.extension_s;
  const double pushed = pushes + gait.times.push_s;
  const std::array parts{part(*cycle, 0.0, pushes), part(*cycle, pushes, pushed),
                         part(*cycle, pushed, cycle->duration())};
  simulation.start(*cycle, Posture::kLying, {});
  CrawlFigures figures;
  const double share = 1.0 / (cycles - 1);
  for (int i = 0; i < cycles; ++i) {
    const Pose before = simulation.now().lying;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Recording recording = simulation.play(parts[k], before);
      widen(figures, sweptBox(recording));
      if (k == 1 && i > 0) addPush(figures, recording, share);
    }
    if (i == 0) continue;
    const Pose made = relative(before, simulation.now().lying);
    figures.advance_m += share * made.x;
    figures.aside_m += share * made.y;
    figures.turn_rad += share * made.yaw;
  }
  figures.highest_m = figures.box.z.max;
  return figures;
}

}  // namespace underway::physics
