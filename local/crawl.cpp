#include "local/crawl.hpp"

#include <algorithm>
#include <cmath>

#include "local/low.hpp"

namespace underway {
namespace {

constexpr double kKept = 0.75;  // of the clearance, where it goes down turned

}  // namespace

Passage passageFrom(const Plan& plan, const Robot& robot, std::size_t down) {
  Passage passage{down, 0.0, kClearanceCap_m, 0.0, 0.0};
  for (std::size_t i = down; i < plan.segments.size(); ++i) {
    const Motion& motion = plan.segments[i].motion;
    if (i > down && !isLow(robot, motion.mode)) break;  // it has got up
    passage.slack_m = std::min(passage.slack_m, plan.segments[i].closeness.clearance_m);
    passage.length_m += length(motion);
  }
  // A third of the slack each for position and heading; what is left is for the crawl's own drift.
  passage.tolerance_m = std::clamp(passage.slack_m / 3.0, 0.006, 0.03);
  passage.tolerance_rad = std::clamp(passage.slack_m / 3.0 / std::max(passage.length_m, 0.3), 0.008, 0.05);
  return passage;
}

Pose entryOf(const Passage& passage, const Plan& plan, double drift_rad_per_m, const Checker& checker) {
  const Motion& planned = plan.segments[passage.down].motion;
  const Switch& down = *checker.robot().findSwitch(planned.mode, planned.to_mode);
  const double turned = -0.5 * drift_rad_per_m * passage.length_m;
  const double keep_m = kKept * std::min(passage.slack_m, checker.robot().margin_m);
  for (const double share : {1.0, 0.5, 0.25})
    for (const double back_m : {0.0, 0.01, 0.02, 0.03}) {
      const Pose entry = compose(planned.from, {-back_m, 0.0, share * turned});
      if (checker.isFree(switchModes(down, entry), keep_m) &&
          checker.isFree(stay(planned.mode, entry), keep_m))
        return entry;
    }
  return planned.from;
}

bool hasRoomUp(const Checker& checker, const Switch& up, const Pose& at, double unsure_m) {
  constexpr double kAcross = 0.5;  // it is surer of its place across
  const double margin = std::max(kAcross * unsure_m, 0.01);
  // The box is longer than the doubt is wide: what is free at both ends is free between them.
  const Motion back = translate(up.from, Sense::kBackward, at, unsure_m);
  const Motion on = translate(up.from, Sense::kForward, at, unsure_m);
  return checker.isFree(switchModes(up, back.to), margin) && checker.isFree(switchModes(up, on.to), margin);
}

bool isNearLow(const Checker& checker, ModeId standing, ModeId low, const Pose& at, double nearer_m) {
  const Robot& robot = checker.robot();
  const double low_m =  // as far ahead of the lower body's front
      std::max(nearer_m + robot.modes[standing].body_m.x.max - robot.modes[low].body_m.x.max, 0.0);
  return !checker.isFree(translate(standing, Sense::kForward, at, nearer_m), 0.0) &&
         checker.isFree(translate(low, Sense::kForward, at, low_m), 0.0);
}

double sigmaAfter(double strokes, const CrawlSettings& settings) {
  return std::hypot(settings.fix_sigma_m, settings.stroke_m * settings.kept_sigma * std::sqrt(strokes));
}

}  // namespace underway
