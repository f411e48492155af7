#include "gait/crawl/player.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "gait/crawl/switches.hpp"

namespace underway::gait {
namespace {

constexpr double kShortest = 0.2;
constexpr double kJoin_s = 0.1;

double hipAt(const Crawler& crawler, const CrawlGait& gait, double phase) {
  const LinkLengths lengths = crawler.lengths(gait.spread_m);
  const auto chain = pushPose(lengths, gait.push.at(phase), {gait.toe_to_elbow_m, 0.0});
  if (!chain) throw std::invalid_argument("this push has no stroke: its chain does not close");
  return pointsOf(lengths, *chain)[3].x;
}

JointTable lastRow(const JointTable& table) {
  JointTable row(table.joints());
  row.append(0.0, table.angles(table.rows() - 1));
  return row;
}

/// The next motion, led to from where the last one ended: turns that differ begin with other angles.
JointTable joined(const JointTable& last, const JointTable& next) {
  JointTable table = last;
  for (std::size_t row = 0; row < next.rows(); ++row)
    table.append(kJoin_s + next.time(row) - next.time(0), next.angles(row));
  return table;
}

double wrapped(double angle_rad) { return std::remainder(angle_rad, radians(360.0)); }

}  // namespace

double strokeFor(const Crawler& crawler, const CrawlGait& gait, double share) {
  constexpr int kHalvings = 30;
  const double start = hipAt(crawler, gait, 0.0);
  const double wanted = start + share * (hipAt(crawler, gait, 1.0) - start);
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (hipAt(crawler, gait, middle) < wanted ? low : high) = middle;
  }
  return high;
}

GaitExpected<CrawlPlayer> CrawlPlayer::make(const Crawler& crawler, const CrawlGait& gait,
                                            const Steering& steering) {
  for (const double share : {kShortest, 0.5, 1.0})
    for (const double turn : {-steering.most_turn_rad, 0.0, steering.most_turn_rad}) {
      CrawlGait tried = gait;
      tried.turn_rad = turn;
      if (const auto motion = crawlMotion(crawler, tried); !motion) return tl::unexpected(motion.error());
      tried.stroke = strokeFor(crawler, gait, share);
      if (const auto motion = crawlMotion(crawler, tried); !motion) return tl::unexpected(motion.error());
    }
  return CrawlPlayer(crawler, gait, steering);
}

CrawlPlayer::CrawlPlayer(const Crawler& crawler, const CrawlGait& gait, const Steering& steering)
    : crawler_(crawler), gait_(gait), steering_(steering), last_(standing(straight())) {}

JointTable CrawlPlayer::straight() const { return crawlMotion(crawler_, gait_).value(); }

double CrawlPlayer::cycleTime() const { return gait_.times.cycle() + kJoin_s; }

JointTable CrawlPlayer::down(double heading_rad) {
  lie(heading_rad);
  return goDown(straight());
}

JointTable CrawlPlayer::lie(double heading_rad) {
  last_ = lastRow(straight());
  line_rad_ = heading_rad;
  turn_rad_ = 0.0;
  share_ = 0.0;
  off_ = {};
  return last_;
}

JointTable CrawlPlayer::cycle(double heading_rad, double share) {
  Steering made = steering_;
  made.advance_m *= share_;
  off_ = reckon(off_, wrapped(heading_rad - line_rad_), turn_rad_, made);
  share_ = std::clamp(share, kShortest, 1.0);
  CrawlGait gait = gait_;
  gait.stroke = strokeFor(crawler_, gait_, share_);
  turn_rad_ = turnTowards(off_, steering_);
  gait.turn_rad = turn_rad_;
  const JointTable motion = joined(last_, crawlMotion(crawler_, gait).value());
  last_ = lastRow(motion);
  return motion;
}

JointTable CrawlPlayer::up() {
  const JointTable motion = joined(last_, getUp(straight()));
  last_ = lastRow(motion);
  return motion;
}

}  // namespace underway::gait
