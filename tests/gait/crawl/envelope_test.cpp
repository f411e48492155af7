#include "gait/crawl/envelope.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gait/nao.hpp"

namespace underway::gait {
namespace {

TEST(Envelope, HoldsTheWholeCrawl) {
  const auto room = crawlEnvelope(nao(), naoCrawler(), nominalGait());
  ASSERT_TRUE(room) << room.error().message;
  // Toe to hip is 170 mm at the start of the push, with the foot's sole behind; elbow to hip 260 mm, with the
  // forearm ahead, and a stroke on top.
  EXPECT_LT(room->low.x(), -0.17);
  EXPECT_GT(room->low.x(), -0.35);
  EXPECT_GT(room->high.x(), 0.43);
  EXPECT_LT(room->high.x(), 0.60);
  EXPECT_NEAR(room->low.y(), -room->high.y(), 1e-9);
  EXPECT_NEAR(room->low.z(), 0.0, 1e-9);
  EXPECT_LT(room->high.z(), 0.21);
  EXPECT_GT(room->advance_m, 0.04);
  EXPECT_DOUBLE_EQ(room->duration_s, nominalGait().times.cycle());
}

TEST(Envelope, SlidingElbowsNeedLessRoomAtTheSides) {
  CrawlGait slide = nominalGait();
  slide.lying.lowering = Lowering::kSlide;
  const auto narrow = crawlEnvelope(nao(), naoCrawler(), slide);
  const auto wide = crawlEnvelope(nao(), naoCrawler(), nominalGait());
  ASSERT_TRUE(narrow && wide);
  EXPECT_LT(narrow->high.y(), 0.195);
  EXPECT_GT(wide->high.y(), 0.22);
}

TEST(Envelope, DoesNotDependOnWhenTheCrawlBegan) {
  CrawlGait slow = nominalGait();
  slow.times = {1.6, 4.0, 3.0};
  const auto room = crawlEnvelope(nao(), naoCrawler(), nominalGait());
  const auto slower = crawlEnvelope(nao(), naoCrawler(), slow);
  ASSERT_TRUE(room && slower);
  EXPECT_NEAR(room->high.x(), slower->high.x(), 0.003);
  EXPECT_NEAR(room->high.z(), slower->high.z(), 0.003);
}

}  // namespace
}  // namespace underway::gait
