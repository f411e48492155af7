#include "gait/crawl/switches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/gait.hpp"
#include "gait/nao.hpp"

namespace underway::gait {
namespace {

const JointTable& crawl() {
  static const JointTable table = crawlMotion(naoCrawler(), nominalGait()).value();
  return table;
}

void expectWithinLimits(const JointTable& table) {
  for (std::size_t column = 0; column < table.joints().size(); ++column) {
    const JointLimits& limits = nao().links.at(nao().findJoint(table.joints()[column]).value()).limits;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      SCOPED_TRACE(table.joints()[column] + " at " + std::to_string(table.time(row)) + " s");
      const double angle = table.angles(row)[column];
      EXPECT_GE(angle, limits.lower_rad);
      EXPECT_LE(angle, limits.upper_rad);
      if (row == 0) continue;
      const double speed = (angle - table.angles(row - 1)[column]) / (table.time(row) - table.time(row - 1));
      EXPECT_LE(std::abs(speed), limits.speed_radps);
    }
  }
}

TEST(Switches, KeepTheJointsLimitsInAngleAndSpeed) {
  expectWithinLimits(goDown(crawl()));
  expectWithinLimits(getUp(crawl()));
}

TEST(Switches, LeadFromStandingToTheCrawlAndBack) {
  const JointTable down = goDown(crawl());
  const JointTable up = getUp(crawl());
  const JointTable stand = standing(crawl());
  EXPECT_TRUE(std::ranges::equal(down.angles(0), stand.angles(0)));
  EXPECT_TRUE(std::ranges::equal(down.angles(down.rows() - 1), crawl().angles(0)));
  EXPECT_TRUE(std::ranges::equal(up.angles(0), crawl().angles(0)));
  EXPECT_TRUE(std::ranges::equal(up.angles(up.rows() - 1), stand.angles(0)));
}

TEST(Switches, MakeOneTableWithTheCrawl) {
  JointTable whole = goDown(crawl());
  const double down_s = whole.duration();
  whole.append(crawl());
  whole.append(getUp(crawl()));
  EXPECT_NEAR(whole.duration(), down_s + crawl().duration() + getUp(crawl()).duration(), 1e-9);
}

TEST(Switches, RefuseWhatIsNoCrawlOfNao) {
  EXPECT_THROW((void)goDown(JointTable({"LHipPitch"})), std::invalid_argument);
  JointTable other({"LHipPitch"});
  other.append(0.0, std::array{0.0});
  EXPECT_THROW((void)getUp(other), std::invalid_argument);
  EXPECT_THROW((void)standing(other), std::invalid_argument);
}

}  // namespace
}  // namespace underway::gait
