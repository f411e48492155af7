#include "geometry/layer.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/flatten.hpp"
#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

constexpr Range kSlab{0.005, 0.5};

Prism randomBody(test::RandomWorld& random) {
  const double size = random.oneOf(4) == 0 ? 1.5 : 0.3;
  return {random.pose(), {-size * random.between(0.1, 1.0), size}, {-0.2, 0.2}, kSlab};
}

class LayerProperty : public testing::TestWithParam<int> {
 protected:
  test::RandomWorld random{7};
  std::shared_ptr<const World> world = random.world(GetParam());
  Layer dut = Layer::seenIn(kSlab, world->obstacles());

  /// The nearest obstacle, the slow way; of equals the one with the smallest id.
  template <class GapTo>
  std::pair<double, std::string> nearest(const GapTo& gap_to) {
    std::pair<double, std::string> best{1e9, ""};
    for (const Obstacle& obstacle : world->obstacles()) {
      const auto piece = flattened(obstacle.box, kSlab);
      if (!piece.empty()) best = std::min(best, {gap_to(piece).distance_m, obstacle.id});
    }
    return best;
  }
};

TEST_P(LayerProperty, FindsTheNearestPieceOfAll) {
  for (int i = 0; i < 500; ++i) {
    const Prism body = randomBody(random);
    const auto footprint = body.footprint();
    const auto wanted = nearest([&](ConvexView piece) { return gapBetween(footprint, piece); });
    const auto found = dut.nearest(body, 100.0);
    ASSERT_EQ(found.has_value(), wanted.first < 100.0);
    if (!found) continue;
    ASSERT_NEAR(found->gap.distance_m, wanted.first, 1e-9);
    if (wanted.first == 0.0) {
      ASSERT_EQ(found->piece->obstacle->id, wanted.second);
    }
    ASSERT_EQ(dut.touches(body), wanted.first == 0.0);
    ASSERT_FALSE(dut.nearest(body, 0.999 * wanted.first)) << "nothing is nearer than the cap";
  }
}

TEST_P(LayerProperty, FindsTheNearestPieceOfATurn) {
  for (int i = 0; i < 300; ++i) {
    const Turning turning(randomBody(random), random.between(-3.0, 3.0));
    const auto wanted = nearest([&](ConvexView piece) { return turning.gapTo(piece); });
    const auto found = dut.nearest(turning, 100.0);
    ASSERT_EQ(found.has_value(), wanted.first < 100.0);
    if (!found) continue;
    ASSERT_NEAR(found->gap.distance_m, wanted.first, 1e-9);
    ASSERT_EQ(dut.touches(turning), wanted.first == 0.0);
  }
}

TEST_P(LayerProperty, AnswersABatchAsItAnswersOneByOne) {
  std::vector<Prism> bodies;
  for (int i = 0; i < 1000; ++i) bodies.push_back(randomBody(random));
  std::vector<char> touched(bodies.size(), 2);
  dut.touchEach(bodies, touched);
  for (std::size_t i = 0; i < bodies.size(); ++i) ASSERT_EQ(touched[i] != 0, dut.touches(bodies[i]));
}

TEST_P(LayerProperty, VisitsWhatTouchesAndStopsWhenTold) {
  for (int i = 0; i < 300; ++i) {
    const Prism body = randomBody(random);
    std::set<std::string> visited;
    dut.visitTouched(body, [&](const Piece& piece) { return visited.insert(piece.obstacle->id), false; });
    std::set<std::string> wanted;
    for (const Obstacle& obstacle : world->obstacles()) {
      const auto piece = flattened(obstacle.box, kSlab);
      if (!piece.empty() && areTouching(body.footprint(), piece)) wanted.insert(obstacle.id);
    }
    ASSERT_EQ(visited, wanted);
    int visits = 0;
    dut.visitTouched(body, [&](const Piece&) { return ++visits > 0; });
    ASSERT_EQ(visits, wanted.empty() ? 0 : 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, LayerProperty, testing::Values(0, 1, 5, 64, 700));

Layer layerOf(std::vector<Obstacle> obstacles) {
  std::optional<std::string> twin;
  return Layer::seenIn(kSlab, Obstacles(std::move(obstacles), twin));
}

const Prism kBody{{0.0, 0.0, 0.0}, {-0.1, 0.1}, {-0.1, 0.1}, kSlab};

TEST(Layer, TakesAHundredThousandBoxesInOnePlace) {
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 100'000; ++i)
    obstacles.push_back({std::to_string(100'000 + i), {{0.3, 0, 0.2}, {0.2, 0.2, 0.2}, {}}});
  const Layer dut = layerOf(obstacles);
  EXPECT_FALSE(dut.touches(kBody));
  EXPECT_TRUE(dut.touches(kBody.grown(0.1)));
  EXPECT_NEAR(dut.nearest(kBody, 1.0)->gap.distance_m, 0.1, 2e-9);
  EXPECT_EQ(dut.nearest(kBody.grown(0.2), 1.0)->piece->obstacle->id, "100000")
      << "the smallest id of all that touch";
}

TEST(Layer, TakesPiecesThatAreAPointOrALine) {
  // A box on its edge, and one on its corner, that reach the slab with just that.
  const double half_diagonal = 0.5 * std::sqrt(2.0);
  const Layer line =
      layerOf({{"edge", {{0.3, 0.0, 0.5 + half_diagonal}, {1.0, 1.0, 1.0}, {0.0, M_PI / 4.0, 0.0}}}});
  ASSERT_NE(line.tree().root, nullptr);
  EXPECT_NEAR(line.nearest(kBody, 1.0)->gap.distance_m, 0.2, 1e-6);
  EXPECT_TRUE(line.touches(kBody.grown(0.2 + 1e-6)));
  const double steep = std::atan(std::sqrt(0.5));
  const Layer point = layerOf(
      {{"corner", {{0.3, 0.0, 0.5 + 0.5 * std::sqrt(3.0)}, {1.0, 1.0, 1.0}, {M_PI / 4.0, steep, 0.0}}}});
  ASSERT_NE(point.tree().root, nullptr);
  EXPECT_NEAR(point.nearest(kBody, 1.0)->gap.distance_m, 0.2, 1e-6);
}

TEST(Layer, AnswersFarFromTheOriginAsNearIt) {
  for (const double far : {0.0, 1e3, 9.9e4}) {
    const Layer dut = layerOf({{"box", {{far + 0.3, -far, 0.2}, {0.2, 0.2, 0.2}, {}}}});
    Prism body = kBody;
    body.frame = {far, -far, 0.0};
    EXPECT_FALSE(dut.touches(body.grown(0.1 - 1e-7))) << far;
    EXPECT_TRUE(dut.touches(body.grown(0.1))) << far;
  }
}

TEST(Layer, SeesAWallOfKilometresThatLeansAHairByItsMiddle) {
  // The slab cuts 50 um off its ends. Rounding turns edges that short, and their lines, kilometres on, by
  // more than the body is deep in the wall.
  const OrientedBox wall{{-0.083676416682565646, -0.2106484105165054, 0.47032655839686605},
                         {6671.2501096273727, 0.024366856587042234, 1.5463530318206136},
                         {0.0, -8.1353266785599843e-05, -2.1043190963707028}};
  const Range slab{0.005, 0.57250309899324248};
  std::optional<std::string> twin;
  const Layer dut = Layer::seenIn(slab, Obstacles({{"wall", wall}}, twin));
  const Prism body{{-0.2660461381754945, -0.48849442310622404, 0.0},
                   {-0.0049768888539316594, 0.0024320313511697078},
                   {-0.0028562828503158823, 0.0015406027193398096},
                   slab};
  EXPECT_TRUE(dut.touches(body)) << "it is 10 um deep in the wall";
  EXPECT_FALSE(dut.touches({{body.frame.x - 2e-5, body.frame.y + 2e-5, 0.0}, body.x, body.y, slab}))
      << "or, that much to the side, out of it";
}

TEST(Layer, KeepsItsPrecisionNearAnOutlier) {
  const Layer dut =
      layerOf({{"near", {{0.3, 0.0, 0.2}, {0.2, 0.2, 0.2}, {}}}, {"far", {{9e4, 9e4, 0.2}, {1, 1, 1}, {}}}});
  EXPECT_FALSE(dut.touches(kBody.grown(0.1 - 1e-7)));
  EXPECT_TRUE(dut.touches(kBody.grown(0.1)));
}

TEST(Layer, WhatIsNotFiniteTouches) {
  const Layer dut = layerOf({{"box", {{0.3, 0.0, 0.2}, {0.2, 0.2, 0.2}, {}}}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Pose& frame : {Pose{nan, 0, 0}, Pose{0, nan, 0}, Pose{0, 0, nan}, Pose{0, 0, INFINITY}}) {
    Prism body = kBody;
    body.frame = frame;
    EXPECT_TRUE(dut.touches(body));
  }
}

TEST(Layer, HangingAboveIsWhatReachesHigherAndIsNotSeen) {
  std::optional<std::string> twin;
  const Obstacles room({{"table", {{0, 0, 0.72}, {1, 1, 0.04}, {}}},
                        {"wall", {{0, 0, 0.5}, {1, 1, 1.0}, {}}},
                        {"stool", {{0, 0, 0.2}, {1, 1, 0.4}, {}}},
                        {"leaning", {{0, 0, 0.5}, {1, 1, 1.0}, {0.3, 0.0, 0.0}}}},
                       twin);
  std::set<std::string> hanging;
  Layer::hangingAbove(0.585, room).visitTouched(kBody, [&](const Piece& piece) {
    return hanging.insert(piece.obstacle->id), false;
  });
  EXPECT_EQ(hanging, (std::set<std::string>{"leaning", "table"}));
}

TEST(Layer, LooksAlikeInSlabsThatCutNoBox) {
  std::optional<std::string> twin;
  const Obstacles walls({{"wall", {{0, 0, 1}, {1, 1, 2}, {}}}, {"lamp", {{0, 0, 2}, {1, 1, 0.1}, {}}}}, twin);
  EXPECT_TRUE(Layer::looksAlike({0.005, 0.2}, {0.005, 0.6}, walls));
  EXPECT_FALSE(Layer::looksAlike({0.005, 0.2}, {0.005, 1.99}, walls));
  EXPECT_FALSE(Layer::looksAlike({0.005, 0.2}, {0.005, 0.6},
                                 walls.with({"board", {{0, 0, 0}, {1, 1, 1}, {0.1, 0, 0}}})));
}

}  // namespace
}  // namespace underway
