#include "gait/crawl/chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/push.hpp"
#include "tests/gait/random_numbers.hpp"

namespace underway::gait {
namespace {

constexpr double kClosed_m = 1e-12;

LinkLengths authors() {
  LinkLengths lengths = naoCrawler().lengths(0.0);
  lengths[4] = 0.08975;
  return lengths;
}

Triplet randomTriplet(test::RandomNumbers& random) {
  return {random.between(-0.7, 1.5), random.between(-1.5, 0.6), random.between(-1.7, -0.2)};
}

/// Every way two distances can leave a triangle with a third.
bool canSpan(double needs, double a, double b) { return needs <= a + b && needs >= std::abs(a - b); }

TEST(Chain, ClosesOverTheWholeFeasibleRange) {
  test::RandomNumbers random(1);
  int feasible = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Triplet triplet = randomTriplet(random);
    const PlanePoint elbow{random.between(0.2, 0.6), random.between(-0.05, 0.05)};
    const auto roots = closeChain(authors(), triplet, elbow);
    if (!roots) continue;
    ++feasible;
    ASSERT_LE(closureError(authors(), roots->ankle_up, elbow), kClosed_m) << "case " << i;
    ASSERT_LE(closureError(authors(), roots->ankle_down, elbow), kClosed_m) << "case " << i;
    const double alpha = roots->ankle_up.back() + roots->ankle_up.shoulder();
    ASSERT_NEAR(alpha, triplet.alpha, 1e-12) << "(4.10), case " << i;
    ASSERT_EQ(roots->ankle_up.knee(), triplet.knee);
    ASSERT_EQ(roots->ankle_up.hip(), triplet.hip);
  }
  EXPECT_GT(feasible, 50'000) << "the cases hardly test anything";
}

TEST(Chain, ClosesWithinRoundingOfTheEdgeOfReach) {
  test::RandomNumbers random(2);
  int at_edge = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Triplet triplet = randomTriplet(random);
    const auto reach = reachOf(authors(), triplet);
    if (!reach || reach->least_m == 0.0) continue;
    for (const double edge_m : {reach->least_m, reach->most_m}) {
      const double inside_m = edge_m == reach->least_m ? 1e-12 : -1e-12;
      const PlanePoint elbow{edge_m + inside_m, 0.0};
      const auto roots = closeChain(authors(), triplet, elbow);
      ASSERT_TRUE(roots) << "case " << i;
      ASSERT_LE(closureError(authors(), roots->ankle_up, elbow), kClosed_m) << "case " << i;
      ASSERT_FALSE(closeChain(authors(), triplet, {edge_m - 1e6 * inside_m, 0.0})) << "case " << i;
      ++at_edge;
    }
  }
  EXPECT_GT(at_edge, 10'000);
}

TEST(Chain, IsInfeasibleExactlyWhereFootAndLegCannotSpan) {
  test::RandomNumbers random(3);
  int infeasible = 0;
  for (int i = 0; i < 50'000; ++i) {
    const LinkLengths l = authors();
    const Triplet t = randomTriplet(random);
    const PlanePoint elbow{random.between(-0.6, 0.9), 0.0};
    // The leg from ankle to shoulder, straight from (4.14) and (4.15).
    const double k1 = l[1] + l[2] * std::cos(t.knee) + l[3] * std::cos(t.knee + t.hip);
    const double k2 = -l[2] * std::sin(t.knee) - l[3] * std::sin(t.knee + t.hip);
    const double span = std::hypot(elbow.x - l[4] * std::cos(t.alpha), elbow.z - l[4] * std::sin(t.alpha));
    const auto roots = closeChain(l, t, elbow);
    ASSERT_EQ(roots.has_value(), canSpan(span, l[0], std::hypot(k1, k2))) << "case " << i;
    if (roots) continue;
    ++infeasible;
    ASSERT_NEAR(roots.error().needs_m, span, 1e-12);
    ASSERT_FALSE(canSpan(roots.error().needs_m, roots.error().most_m, 0.0) &&
                 roots.error().needs_m >= roots.error().least_m);
  }
  EXPECT_GT(infeasible, 5'000);
}

TEST(Chain, AgreesWithTheThesisEquationByEquation) {
  test::RandomNumbers random(4);
  for (int i = 0; i < 10'000; ++i) {
    const LinkLengths l = authors();
    const Triplet t{random.between(radians(-5), radians(45)), random.between(radians(-30), radians(27)),
                    random.between(radians(-90), radians(-30))};
    const double d_e = 0.43;
    const auto dut = closeChain(l, t, {d_e, 0.0});
    ASSERT_TRUE(dut) << "case " << i;
    const double k1 = l[1] + l[2] * std::cos(t.knee) + l[3] * std::cos(t.knee + t.hip);
    const double k2 = -l[2] * std::sin(t.knee) - l[3] * std::sin(t.knee + t.hip);
    const double x = d_e - l[4] * std::cos(t.alpha);
    const double z = l[4] * std::sin(t.alpha);
    const double r = x * x + z * z - l[0] * l[0] - k1 * k1 - k2 * k2;  // (4.13)
    const double theta2 = std::atan2(k2, k1) - std::acos(r / (2.0 * l[0] * std::hypot(k1, k2)));
    const double k3 = l[0] + k1 * std::cos(theta2) + k2 * std::sin(theta2);  // (4.19)
    const double k4 = k2 * std::cos(theta2) - k1 * std::sin(theta2);         // (4.20)
    const double theta1 = std::atan2(k4 * x - k3 * z, k3 * x + k4 * z);      // (4.17), (4.18)
    EXPECT_NEAR(std::remainder(dut->ankle_up.ankle() - theta2, 2.0 * M_PI), 0.0, 1e-7) << "case " << i;
    EXPECT_NEAR(std::remainder(dut->ankle_up.toe() - theta1, 2.0 * M_PI), 0.0, 1e-7) << "case " << i;
  }
}

TEST(Chain, TakesTheRootThatHasTheAnkleAboveTheFloor) {
  test::RandomNumbers random(5);
  for (int i = 0; i < 10'000; ++i) {
    const Triplet t{random.between(radians(-5), radians(45)), random.between(radians(-30), radians(27)),
                    random.between(radians(-90), radians(-30))};
    const auto roots = closeChain(authors(), t, {0.43, 0.0});
    ASSERT_TRUE(roots);
    const ChainPoints up = pointsOf(authors(), roots->ankle_up);
    const ChainPoints down = pointsOf(authors(), roots->ankle_down);
    ASSERT_GT(up[1].z, 0.0) << "case " << i;
    ASSERT_LT(down[1].z, 0.0) << "the other one has it below in every case; " << i;
    ASSERT_EQ(&choose(authors(), *roots), &roots->ankle_up);
  }
}

TEST(Chain, NominalGaitIsAsTheAuthorTellsIt) {
  double ankle_top = 0.0;
  double shoulder_from = 0.0;
  double shoulder_to = 0.0;
  for (int i = 0; i <= 600; ++i) {
    const auto chain = pushPose(authors(), nominalPush().at(i / 600.0), {0.43, 0.0});
    ASSERT_TRUE(chain);
    const ChainPoints points = pointsOf(authors(), *chain);
    ankle_top = std::max(ankle_top, points[1].z);
    if (i == 0) shoulder_from = points[4].x;
    shoulder_to = points[4].x;
    EXPECT_GE(points[3].z, 0.014) << "hip";
    EXPECT_LE(points[3].z, 0.033) << "hip";
  }
  EXPECT_NEAR(ankle_top, 0.1038, 0.0001);
  EXPECT_NEAR(shoulder_to - shoulder_from, 0.0777, 0.0001) << "the stroke";
}

TEST(Chain, TellsWhatIsMissing) {
  const auto chain = pushPose(authors(), {0.3, 0.4, -0.5}, {0.9, 0.0});
  ASSERT_FALSE(chain);
  EXPECT_NE(chain.error().sentence().find("822.4 mm"), std::string::npos) << chain.error().sentence();
}

}  // namespace
}  // namespace underway::gait
