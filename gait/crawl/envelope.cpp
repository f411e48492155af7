#include "gait/crawl/envelope.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "gait/rest.hpp"

namespace underway::gait {
namespace {

constexpr double kFaceDown_rad = 0.5 * std::numbers::pi;

/// Where the body frame's origin is: below the hip joints.
double hipX(const Skeleton& skeleton, const JointTable& motion, const Rest& rest, std::size_t row) {
  std::vector<double> pose;
  for (const std::string& joint : skeleton.joints()) pose.push_back(motion.angles(row)[*motion.find(joint)]);
  const auto link = skeleton.findLink("LThigh");
  if (!link) throw std::invalid_argument("the crawl's body frame is below LThigh, which the skeleton lacks");
  return (rest.placement() * placementsOf(skeleton, pose)[*link]).translation().x();
}

Envelope envelopeFrom(const std::vector<Rest>& rests, std::size_t first, std::size_t last, double origin_x) {
  Envelope envelope{rests[first].low, rests[first].high, 0.0, 0.0, rests[first].margin_m};
  for (std::size_t i = first; i <= last; ++i) {
    envelope.low = envelope.low.cwiseMin(rests[i].low);
    envelope.high = envelope.high.cwiseMax(rests[i].high);
    envelope.least_margin_m = std::min(envelope.least_margin_m, rests[i].margin_m);
  }
  envelope.low.x() -= origin_x;
  envelope.high.x() -= origin_x;
  return envelope;
}

/// The first row that is not before a time.
std::size_t rowAt(const JointTable& motion, double time_s) {
  std::size_t row = 0;
  while (row + 1 < motion.rows() && motion.time(row) < time_s - 1e-9) ++row;
  return row;
}

}  // namespace

GaitExpected<Envelope> crawlEnvelope(const Skeleton& skeleton, const Crawler& crawler,
                                     const CrawlGait& gait) {
  const auto motion = crawlMotion(crawler, gait, 2);
  if (!motion) return tl::unexpected(motion.error());
  const std::vector<Rest> rests = settleAll(skeleton, *motion, kFaceDown_rad);
  const std::size_t last = motion->rows() - 1;
  const std::size_t second = rowAt(*motion, gait.times.cycle());
  const std::size_t push = rowAt(*motion, gait.times.cycle() + gait.times.extension_s);
  Envelope envelope = envelopeFrom(rests, second, last, hipX(skeleton, *motion, rests[push], push));
  envelope.advance_m = rests[last].root.x() - rests[second].root.x();
  envelope.duration_s = gait.times.cycle();
  return envelope;
}

}  // namespace underway::gait
