#include "local/seen_floor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace underway {
namespace {

constexpr Point kThere{1.01, 0.51};

bool isSeen(const SeenFloor& dut, Point at) {
  bool is_seen = true;
  dut.visitUnseen(round(at, 0.0), [&](Point) { is_seen = false; });
  return is_seen;
}

TEST(SeenFloor, IsSeenAsFarAsABeamPassedButNotWhereItEnds) {
  SeenFloor dut;
  dut.pass({0.0, 0.0}, {0.7, 0.0});
  for (const double x : {0.0, 0.5, 0.64}) EXPECT_TRUE(isSeen(dut, {x, 0.0})) << x;
  EXPECT_FALSE(isSeen(dut, {0.69, 0.0}));
  EXPECT_FALSE(isSeen(dut, {0.8, 0.0}));
  EXPECT_FALSE(isSeen(dut, {0.5, 0.03}));
}

TEST(SeenFloor, IsNotSeenBehindAShortBeamNorFarAway) {
  SeenFloor dut;
  dut.pass({0.0, 0.0}, {0.5 * SeenFloor::kShort_m, 0.0});
  EXPECT_FALSE(isSeen(dut, {0.0, 0.0}));
  dut.pass({0.0, 0.0}, {0.0, 3.0});
  EXPECT_TRUE(isSeen(dut, {0.0, SeenFloor::kFar_m - 0.05}));
  EXPECT_FALSE(isSeen(dut, {0.0, SeenFloor::kFar_m + 0.05}));
}

TEST(SeenFloor, ForgetsWhatSlidesOutAndKeepsTheRest) {
  SeenFloor dut;
  dut.mark(kThere);
  dut.slideTo({kThere.x - 3.0, kThere.y + 3.0});
  EXPECT_TRUE(isSeen(dut, kThere));
  dut.slideTo({kThere.x + 5.0, kThere.y});
  dut.slideTo({0.0, 0.0});
  EXPECT_FALSE(isSeen(dut, kThere));
}

TEST(SeenFloor, TellsTheMiddlesOfCellsThatWereNotSeen) {
  SeenFloor dut;
  const Point middle{0.5 * SeenFloor::kCell_m, 0.5 * SeenFloor::kCell_m};
  dut.mark(middle);
  int cells = 0;
  dut.visitUnseen(round(middle, SeenFloor::kCell_m), [&](Point at) {
    ++cells;
    EXPECT_FALSE(isSeen(dut, at));
    EXPECT_NEAR(std::max(std::abs(at.x - middle.x), std::abs(at.y - middle.y)), SeenFloor::kCell_m, 1e-9);
  });
  EXPECT_EQ(cells, 8);
}

TEST(SeenFloor, PassesOverWhatIsOutside) {
  SeenFloor dut;
  dut.mark({100.0, 0.0});
  dut.pass({100.0, 0.0}, {101.0, 0.0});
  int cells = 0;
  dut.visitUnseen(round({100.0, 0.0}, 1.0), [&](Point) { ++cells; });
  EXPECT_EQ(cells, 0);
}

}  // namespace
}  // namespace underway
