#pragma once

#include "gait/crawl/gait.hpp"
#include "gait/crawl/steering.hpp"

namespace underway::gait {

/// The phase of the push at which the hips have come so far, as a share of a whole push's advance (0..1]: the
/// gait's `stroke` for a shorter cycle. In physics the advance is within 5 mm of that share.
[[nodiscard]] double strokeFor(const Crawler& crawler, const CrawlGait& gait, double share);

/// The crawl, motion by motion, as it comes to be wanted: down, one cycle after the other, up. Each motion
/// begins where the last one ended. The heading that the robot had when it was told to go down is kept, by
/// turns in the pushes from what the inertial heading says between them.
///
/// Headings [rad] are of any frame that does not turn. For NAO, whose switches these are (switches.hpp).
class CrawlPlayer {
 public:
  /// Errors: those of crawlMotion, of any turn the steering may ask for, at any stroke.
  [[nodiscard]] static GaitExpected<CrawlPlayer> make(const Crawler& crawler, const CrawlGait& gait,
                                                      const Steering& steering = {});

  /// From standing. The line to be crawled runs along the heading.
  [[nodiscard]] JointTable down(double heading_rad);
  /// It lies already; the line runs along the heading. Its joints are to be as in the row.
  JointTable lie(double heading_rad);
  /// A cycle that advances by a share of a whole one, 0.2 to 1 (clamped).
  [[nodiscard]] JointTable cycle(double heading_rad, double share = 1.0);
  /// To standing. The cycles before have ended.
  [[nodiscard]] JointTable up();

  /// What a whole cycle advances [m].
  [[nodiscard]] double advance() const { return steering_.advance_m; }
  /// And how long it takes [s].
  [[nodiscard]] double cycleTime() const;

 private:
  CrawlPlayer(const Crawler& crawler, const CrawlGait& gait, const Steering& steering);
  [[nodiscard]] JointTable straight() const;

  Crawler crawler_;
  CrawlGait gait_;
  Steering steering_;
  JointTable last_;  ///< one row: where the last motion ended
  double line_rad_ = 0.0;
  double turn_rad_ = 0.0;  ///< of the last push
  double share_ = 0.0;     ///< of the last cycle
  OffLine off_;
};

}  // namespace underway::gait
