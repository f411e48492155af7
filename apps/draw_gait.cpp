#include "apps/draw_gait.hpp"

#include <array>
#include <numbers>

#include "apps/chart.hpp"
#include "gait/crawl/torque.hpp"
#include "gait/nao.hpp"
#include "gait/rest.hpp"

namespace underway {
namespace {

using namespace gait;

constexpr std::array kColours{"#3b6fd4", "#e8590c", "#2f9e44", "#c2255c", "#7048e8", "#868e96", "#b08900"};
constexpr int kSteps = 100;

Chart tripletChart(const CrawlGait& gait) {
  Chart chart{"Free angles of the push (nominal dashed)", "phase of the push", "degrees", {}, false};
  const auto add = [&](const char* label, const char* colour, const Cubic& cubic, bool is_nominal) {
    Series series{is_nominal ? "" : label, colour, is_nominal, {}};
    for (int i = 0; i <= kSteps; ++i) {
      const double s = static_cast<double>(i) / kSteps;
      series.points.push_back({s, degrees(cubic.at(s))});
    }
    chart.series.push_back(series);
  };
  const PushShape nominal = nominalPush();
  add("", kColours[0], nominal.knee, true);
  add("", kColours[1], nominal.hip, true);
  add("", kColours[2], nominal.alpha, true);
  add("theta3, knee", kColours[0], gait.push.knee, false);
  add("theta4, hip", kColours[1], gait.push.hip, false);
  add("alpha, upper arm", kColours[2], gait.push.alpha, false);
  return chart;
}

Chart chainChart(const CrawlGait& gait) {
  Chart chart{
      "The chain on its way: toe, ankle, knee, hip, shoulder, elbow", "mm ahead of the toe", "mm", {}, true};
  constexpr int kFrames = 6;
  const LinkLengths lengths = naoCrawler().lengths(gait.spread_m);
  for (int i = 0; i < kFrames; ++i) {
    const double s = static_cast<double>(i) / (kFrames - 1);
    const auto chain = pushPose(lengths, gait.push.at(s), {gait.toe_to_elbow_m, 0.0});
    if (!chain) continue;
    Series series{i == 0             ? "start"
                  : i == kFrames - 1 ? "end"
                                     : "",
                  kColours[static_cast<std::size_t>(i)],
                  false,
                  {}};
    for (const PlanePoint p : pointsOf(lengths, *chain)) series.points.push_back({1e3 * p.x, 1e3 * p.z});
    chart.series.push_back(series);
  }
  return chart;
}

Chart jointChart(const JointTable& motion, const char* title, const std::vector<const char*>& joints) {
  Chart chart{title, "s", "degrees", {}, false};
  for (std::size_t i = 0; i < joints.size(); ++i)
    for (const char* side : {"L", "R"}) {
      const bool is_left = side[0] == 'L';
      Series series{is_left ? joints[i] : "", kColours[i], !is_left, {}};
      const auto column = motion.find(std::string(side).append(joints[i]));
      for (std::size_t row = 0; column && row < motion.rows(); ++row)
        series.points.push_back({motion.time(row), degrees(motion.angles(row)[*column])});
      chart.series.push_back(series);
    }
  return chart;
}

void addTorques(const CrawlGait& gait, const PushShape& push, bool is_nominal, Chart& chart) {
  constexpr std::array kNames{"ankle", "knee", "hip", "shoulder"};
  const LinkLengths lengths = naoCrawler().lengths(gait.spread_m);
  const ChainMasses masses = chainMassesOf(nao());
  for (std::size_t j = 0; j < kNames.size(); ++j) {
    Series series{is_nominal ? "" : kNames[j], kColours[j], is_nominal, {}};
    for (int i = 0; i <= kSteps; ++i) {
      const double s = static_cast<double>(i) / kSteps;
      const auto chain = pushPose(lengths, push.at(s), {gait.toe_to_elbow_m, 0.0});
      if (chain) series.points.push_back({s, loadOf(masses, pointsOf(lengths, *chain), {}).torques_nm[j]});
    }
    chart.series.push_back(series);
  }
}

Chart torqueChart(const CrawlGait& gait) {
  Chart chart{"Torques that hold the push, one side (nominal dashed)", "phase of the push", "Nm", {}, false};
  addTorques(gait, nominalPush(), true, chart);
  addTorques(gait, gait.push, false, chart);
  return chart;
}

/// What a low table would see, and how far the centre of mass is inside the support, where gravity lays the
/// robot.
Chart heightChart(const JointTable& cycles) {
  constexpr double kFaceDown_rad = 0.5 * std::numbers::pi;
  Chart chart{"Over the floor (at rest)", "s", "mm", {}, false};
  Series highest{"highest point", kColours[0], false, {}};
  Series center{"centre of mass", kColours[1], false, {}};
  Series margin{"stability margin", kColours[2], false, {}};
  const std::vector<Rest> rests = settleAll(nao(), cycles, kFaceDown_rad);
  for (std::size_t row = 0; row < rests.size(); ++row) {
    const double time_s = cycles.time(row);
    highest.points.push_back({time_s, 1e3 * rests[row].high.z()});
    center.points.push_back({time_s, 1e3 * rests[row].mass_center.z()});
    margin.points.push_back({time_s, 1e3 * rests[row].margin_m});
  }
  chart.series = {highest, center, margin};
  return chart;
}

}  // namespace

std::string drawGait(const CrawlGait& gait, const JointTable& motion) {
  return drawCharts(
      {tripletChart(gait), chainChart(gait),
       jointChart(motion, "Arms (right dashed)", {"ShoulderPitch", "ShoulderRoll", "ElbowYaw", "ElbowRoll"}),
       jointChart(motion, "Legs (right dashed)", {"HipPitch", "KneePitch", "AnklePitch"}), torqueChart(gait),
       heightChart(motion)},
      "Crawl \"" + gait.name + "\"");
}

}  // namespace underway
