#include "local/window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace underway {
namespace {

constexpr Point kThere{1.02, -0.53};

void hitOften(Window& window, Point at) {
  for (int i = 0; i < Window::kSure; ++i) window.hit(at);
}

TEST(Window, IsSureOfWhatWasSeenOftenEnough) {
  Window dut;
  for (int i = 1; i < Window::kSure; ++i) dut.hit(kThere);
  EXPECT_FALSE(dut.isOccupied(kThere));
  dut.hit(kThere);
  EXPECT_TRUE(dut.isOccupied(kThere));
  EXPECT_FALSE(dut.isOccupied({kThere.x + 0.1, kThere.y}));
}

/// A lidar's scan in which every beam ends at the same range.
Scan scanTo(double range_m) {
  Scan scan;
  scan.ranges_m.assign(scan.beams.count, static_cast<float>(range_m));
  return scan;
}

void takeBackInAllRows(Window& window, const Scan& scan, const Pose& from, double far_m = 2.5) {
  for (int part = 0; part < 2; ++part) window.takeBack(scan, from, far_m);
}

TEST(Window, TakesBackWhatIsSeenThrough) {
  Window dut;
  hitOften(dut, kThere);
  takeBackInAllRows(dut, scanTo(2.0), {0.0, 0.0, 0.3});
  EXPECT_FALSE(dut.isOccupied(kThere));
}

TEST(Window, KeepsWhatBeamsEndOnAndWhatNoneLooksAt) {
  const double range_m = std::hypot(kThere.x, kThere.y);
  const double bearing = std::atan2(kThere.y, kThere.x);
  Scan one_ends_on_it = scanTo(2.0);
  const auto beam = static_cast<std::size_t>(
      std::lround((bearing - one_ends_on_it.beams.first_rad) / one_ends_on_it.beams.step_rad));
  one_ends_on_it.ranges_m[beam + 1] = static_cast<float>(range_m + 0.01);
  Window dut;
  hitOften(dut, kThere);
  for (int i = 0; i < 10; ++i) {
    takeBackInAllRows(dut, scanTo(range_m), {});
    takeBackInAllRows(dut, one_ends_on_it, {});
    takeBackInAllRows(dut, scanTo(2.0), {0.0, 0.0, bearing + std::numbers::pi});  // it is behind
    takeBackInAllRows(dut, scanTo(2.0), {}, 1.0);                                 // it is further
    takeBackInAllRows(dut, scanTo(Scan::kNotLooked), {});
  }
  EXPECT_TRUE(dut.isOccupied(kThere));
}

/// Points at random, of which each is asked for by itself, slowly.
TEST(Window, TakesBackExactlyWhatThreeBeamsPassWhereverItHasSlid) {
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> off(-3.0, 3.0);
  std::uniform_real_distribution<float> range(0.1F, 3.5F);
  int taken_back = 0;
  for (int round = 0; round < 60; ++round) {
    Window dut;
    const Pose from{10.0 * off(random), 10.0 * off(random), off(random)};
    dut.slideTo(from.position());
    std::vector<Point> points;
    for (int i = 0; i < 40; ++i) points.push_back({from.x + off(random), from.y + off(random)});
    for (const Point p : points) hitOften(dut, p);
    const auto before = points;
    std::erase_if(points, [&](Point p) { return !dut.isOccupied(p); });
    Scan scan = scanTo(0.0);
    for (std::size_t i = 0; i < scan.ranges_m.size(); i += 20)  // walls that many beams end on
      std::fill_n(&scan.ranges_m[i], std::min<std::size_t>(20, scan.ranges_m.size() - i), range(random));
    takeBackInAllRows(dut, scan, from);
    for (const Point p : points) {
      const double range_m = distance(p, from.position());
      const double bearing = normalizedAngle(std::atan2(p.y - from.y, p.x - from.x) - from.yaw);
      bool is_passed = range_m < 2.5 && std::abs(bearing) < -scan.beams.first_rad - scan.beams.step_rad;
      for (std::size_t i = 0; i < scan.beams.count; ++i)
        if (std::abs(scan.beams.bearing(i) - bearing) < 1.5 * scan.beams.step_rad)
          is_passed &= scan.ranges_m[i] > range_m + Window::kShort_m;
      taken_back += is_passed ? 1 : 0;
      const bool is_shared = std::count_if(before.begin(), before.end(), [&](Point other) {
                               return distance(p, other) < 2.0 * Window::kCell_m;
                             }) > 1;
      if (is_shared) continue;
      ASSERT_EQ(dut.isOccupied(p), !is_passed) << "seed " << kSeed << " round " << round;
    }
  }
  EXPECT_GT(taken_back, 200);
}

TEST(Window, KeepsWhatStaysInsideAsItSlides) {
  Window dut;
  hitOften(dut, kThere);
  for (double x = 0.0; x < 3.0; x += 0.01) {
    dut.slideTo({x, -x});
    ASSERT_TRUE(dut.isOccupied(kThere)) << x;
  }
}

TEST(Window, ForgetsWhatSlidesOutAndDoesNotFindItAgainElsewhere) {
  Window dut;
  hitOften(dut, kThere);
  dut.slideTo({5.0, 0.0});
  EXPECT_FALSE(dut.isOccupied(kThere));
  int cells = 0;
  dut.visitOccupied({5.0, 0.0}, 3.0, [&](Point, bool) { ++cells; });
  EXPECT_EQ(cells, 0);
  dut.slideTo({0.0, 0.0});
  EXPECT_FALSE(dut.isOccupied(kThere));
}

TEST(Window, ForgetsAllAfterAJump) {
  Window dut;
  hitOften(dut, kThere);
  dut.slideTo({100.0, 100.0});
  dut.slideTo({0.0, 0.0});
  EXPECT_FALSE(dut.isOccupied(kThere));
}

TEST(Window, PassesOverWhatIsOutside) {
  Window dut;
  hitOften(dut, {50.0, 0.0});
  EXPECT_FALSE(dut.isOccupied({50.0, 0.0}));
}

TEST(Window, TellsWhatIsKnownFromWhatCameSince) {
  Window dut;
  hitOften(dut, kThere);
  dut.markKnown();
  hitOften(dut, {0.5, 0.5});
  int known = 0;
  int fresh = 0;
  dut.visitOccupied({0.0, 0.0}, 2.0, [&](Point, bool is_known) { ++(is_known ? known : fresh); });
  EXPECT_EQ(known, 1);
  EXPECT_EQ(fresh, 1);
}

TEST(Window, TellsWhereInACellSomethingWasSeen) {
  Window dut;
  for (int i = 0; i < 50; ++i) dut.hit({1.001 + 0.0002 * (i % 5), 0.549});
  dut.visitOccupied({1.0, 0.5}, 0.2, [](Point at, bool) {
    EXPECT_NEAR(at.x, 1.0014, 1e-4);
    EXPECT_NEAR(at.y, 0.549, 1e-4);
  });
}

/// How far a point lies outside the outlines of what was seen near it, in a direction; negative inside.
double outside(const Window& dut, Point from, Point at, Point towards) {
  double furthest = -1.0;
  dut.visitOutlines(from, 3.0, 0.01, [&](Point end) {
    furthest = std::max(furthest, (end.x - at.x) * towards.x + (end.y - at.y) * towards.y);
  });
  return -furthest;
}

/// A wedge's faces run from its tip, which a lidar looks at, to either side; its noise is along its view.
TEST(Window, OutlinesFacesToTheirEndsAndCornersToTheirTips) {
  constexpr unsigned kSeed = 7;
  constexpr double kNoise_m = 0.01;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> even(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, kNoise_m);
  double worst_m = 0.0;
  double sum_m = 0.0;
  constexpr int kRounds = 300;
  for (int round = 0; round < kRounds; ++round) {
    Window dut;
    const Point tip{even(random), even(random)};
    const double middle = 2.0 * std::numbers::pi * even(random);
    const double half = 0.75 * even(random);  // 0: one face, seen to its end
    const double aside = middle + std::numbers::pi + even(random) - 0.5;
    const Point from{tip.x + std::cos(aside), tip.y + std::sin(aside)};
    for (int i = 0; i < 400; ++i) {
      const double angle = middle + (i % 2 == 0 ? half : -half);
      const double along_m = 0.1 * even(random);
      const Point there{tip.x + along_m * std::cos(angle), tip.y + along_m * std::sin(angle)};
      const double off = noise(random) / distance(there, from);
      dut.hit({there.x + off * (there.x - from.x), there.y + off * (there.y - from.y)});
    }
    const double beyond_m = outside(dut, from, tip, {-std::cos(middle), -std::sin(middle)});
    worst_m = std::max(worst_m, beyond_m);
    sum_m += beyond_m;
  }
  EXPECT_LT(worst_m, 0.018) << "seed " << kSeed;  // the guard keeps 0.025 from the outlines
  EXPECT_NEAR(sum_m / kRounds, 0.0, 0.004) << "seed " << kSeed;
}

/// A pole of 3 cm: what is seen of it is as wide as it is, whatever the noise.
TEST(Window, OutlinesThinThingsAsWideAsTheyAre) {
  constexpr unsigned kSeed = 3;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> even(-0.015, 0.015);
  std::normal_distribution<double> noise(0.0, 0.01);
  Window dut;
  for (int i = 0; i < 400; ++i) dut.hit({0.825 + noise(random) * 0.5, 0.025 + even(random)});
  for (const double side : {-1.0, 1.0})
    EXPECT_LT(outside(dut, {0.0, 0.025}, {0.825, 0.025 + 0.015 * side}, {0.0, side}), 0.004)
        << "seed " << kSeed;
}

TEST(Window, TellsOfEachOccupiedCellOnceWhereverItHasSlid) {
  constexpr unsigned kSeed = 5;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> off(-3.0, 3.0);
  Window dut;
  Point at{0.0, 0.0};
  for (int round = 0; round < 40; ++round) {
    at = {at.x + 0.3 * off(random), at.y + 0.3 * off(random)};
    dut.slideTo(at);
    for (int i = 0; i < 20; ++i) hitOften(dut, {at.x + off(random), at.y + off(random)});
    const Point round_what{at.x + off(random), at.y + off(random)};
    const double reach = std::abs(off(random));
    std::set<std::pair<long, long>> told;
    dut.visitOccupied(round_what, reach, [&](Point p, bool) {
      const auto cell = [](double x) { return std::lround(std::floor(x / Window::kCell_m + 1e-6)); };
      ASSERT_TRUE(told.insert({cell(p.x), cell(p.y)}).second) << "seed " << kSeed << " round " << round;
    });
    // Every cell whose middle is well within reach, asked one by one.
    for (double y = -reach; y < reach; y += Window::kCell_m)
      for (double x = -reach; x < reach; x += Window::kCell_m) {
        const auto cell = [](double p) { return std::lround(std::floor(p / Window::kCell_m)); };
        const Point p{round_what.x + x, round_what.y + y};
        ASSERT_EQ(told.contains({cell(p.x), cell(p.y)}), dut.isOccupied(p))
            << "seed " << kSeed << " round " << round;
      }
  }
}

Scan openScan() {
  Scan scan;
  scan.ranges_m.assign(scan.beams.count, Scan::kNothing);
  return scan;
}

TEST(VirtualObstacles, ShortenTheBeamsThatMeetThemAndNoOthers) {
  VirtualObstacles dut;
  dut.add({2.0, 0.0}, 0.3);
  Scan scan = openScan();
  dut.shorten(scan, {0.0, 0.0, 0.0});
  for (std::size_t i = 0; i < scan.beams.count; ++i) {
    const double bearing = scan.beams.bearing(i);
    const double across = 2.0 * std::sin(bearing);
    if (std::abs(bearing) < 1.5 && std::abs(across) < 0.299) {
      ASSERT_NEAR(scan.ranges_m[i], 2.0 * std::cos(bearing) - std::sqrt(0.09 - across * across), 1e-6);
    } else if (std::abs(across) > 0.301 || std::abs(bearing) > 1.5) {
      ASSERT_EQ(scan.ranges_m[i], Scan::kNothing);
    }
  }
}

TEST(VirtualObstacles, AreNotThereForARobotThatStandsInThem) {
  VirtualObstacles dut;
  dut.add({0.1, 0.0}, 0.3);
  Scan scan = openScan();
  dut.shorten(scan, {0.0, 0.0, 0.0});
  EXPECT_EQ(scan.ranges_m, openScan().ranges_m);
}

TEST(VirtualObstacles, KeepTheNewestWhenThereAreTooMany) {
  VirtualObstacles dut;
  for (int i = 0; i < 20; ++i) dut.add({100.0, 100.0}, 0.3);
  dut.add({2.0, 0.0}, 0.3);
  Scan scan = openScan();
  dut.shorten(scan, {0.0, 0.0, 0.0});
  EXPECT_LT(scan.ranges_m[scan.beams.count / 2], 2.0F);
}

}  // namespace
}  // namespace underway
