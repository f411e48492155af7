#include "gait/crawl/gait.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "gait/crawl/motion_writer.hpp"
#include "gait/crawl/posture.hpp"

namespace underway::gait {
namespace {

constexpr double kRow_s = 0.025;

/// Starts and ends at rest.
double eased(double share) { return share * share * (3.0 - 2.0 * share); }

/// The parts of M3, as shares of its time.
constexpr double kDown = 0.34;   ///< spread: the chest goes down
constexpr double kKnees = 0.2;   ///< the knees bend
constexpr double kAhead = 0.26;  ///< spread: the arms rise
constexpr double kSlideKnees = 0.3;
constexpr double kSlideArms = 0.45;

class Cycle {
 public:
  Cycle(const Crawler& crawler, const CrawlGait& gait) : crawler_(crawler), gait_(gait), writer_(crawler) {}

  GaitExpected<JointTable> motion() && {
    const auto lying = lyingPosture(crawler_, gait_);
    const auto ready = pushPosture(crawler_, gait_, 0.0);
    if (!lying || !ready) {
      writer_.refuse(0.0, lying ? ready.error() : lying.error());
      return std::move(writer_).finish();
    }
    now_ = *lying;
    writer_.write(0.0, now_);
    // M1, M2, M3.
    moveTo(*ready, gait_.times.extension_s);
    follow(gait_.times.push_s, [&](double s) { return pushPosture(crawler_, gait_, gait_.stroke * s); });
    gait_.lying.lowering == Lowering::kSpread ? spread(*lying) : slide(*lying);
    return std::move(writer_).finish();
  }

 private:
  using Path = std::function<Feasible<Posture>(double share)>;

  /// Along a path, the share of it proportional to time.
  void follow(double seconds, const Path& path) {
    const int rows = std::max(1, static_cast<int>(std::ceil(seconds / kRow_s - 1e-9)));
    for (int row = 1; row <= rows && !writer_.failed(); ++row) {
      const double share = static_cast<double>(row) / rows;
      const auto posture = path(share);
      if (!posture) return writer_.refuse(time_s_ + share * seconds, posture.error());
      writer_.write(time_s_ + share * seconds, *posture);
      now_ = *posture;
    }
    time_s_ += seconds;
  }

  void moveTo(const Posture& to, double seconds) {
    const Posture from = now_;
    follow(seconds, [&](double share) -> Feasible<Posture> { return between(from, to, eased(share)); });
  }

  /// The feet go up: only the knees bend. Elbows and chest stay as they are against the back.
  Posture kneesBent(const Posture& lying, double hip_rad) const {
    Posture bent = now_;
    for (std::size_t i = 0; i < 2; ++i) {
      bent.sides[i].knee = lying.sides[i].knee;
      bent.sides[i].hip = hip_rad;
    }
    return bent;
  }

  void spread(const Posture& lying) {
    const double seconds = gait_.times.lowering_s;
    follow(kDown * seconds, [&](double s) { return spreadPosture(crawler_, gait_, eased(s)); });
    moveTo(kneesBent(lying, gait_.lying.hip_rad), kKnees * seconds);
    Posture ahead = lying;
    for (std::size_t i = 0; i < 2; ++i) ahead.sides[i].spread_m = now_.sides[i].spread_m;
    moveTo(ahead, kAhead * seconds);
    moveTo(lying, (1.0 - kDown - kKnees - kAhead) * seconds);
  }

  void slide(const Posture& lying) {
    const double seconds = gait_.times.lowering_s;
    const double ankle_rad = now_.sides[0].ankle;
    moveTo(kneesBent(lying, gait_.lying.hip_rad), kSlideKnees * seconds);
    Posture ahead = lying;
    for (SideShape& side : ahead.sides) side.ankle = ankle_rad;  // the toes curl when the feet are up
    moveTo(ahead, kSlideArms * seconds);
    moveTo(lying, (1.0 - kSlideKnees - kSlideArms) * seconds);
  }

  const Crawler& crawler_;
  const CrawlGait& gait_;
  MotionWriter writer_;
  Posture now_;
  double time_s_ = 0.0;
};

}  // namespace

CrawlGait nominalGait() {
  CrawlGait gait;
  gait.name = "nominal";
  gait.push = nominalPush();
  gait.spread_m = naoCrawler().arm.spreadFor(0.08975);
  return gait;
}

CrawlGait cruiseGait() {
  CrawlGait gait = nominalGait();
  gait.name = "cruise";
  gait.push.hip = cubicThrough(radians(20.0), radians(26.0), 0.0, radians(20.0));
  return gait;
}

GaitExpected<JointTable> crawlMotion(const Crawler& crawler, const CrawlGait& gait, int cycles) {
  if (cycles < 1) throw std::invalid_argument("a crawl has at least one cycle");
  auto cycle = Cycle(crawler, gait).motion();
  if (!cycle || cycles == 1) return cycle;
  JointTable motion = *cycle;
  for (int i = 1; i < cycles; ++i) motion.append(*cycle);
  return motion;
}

}  // namespace underway::gait
