#include "geometry/piece_tree.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

Piece randomPiece(test::RandomWorld& random) {
  const OrientedBox box = random.box(false);
  const auto obstacle = std::make_shared<const Obstacle>(Obstacle{"o", box});
  return {obstacle, {{box.center_m.x, box.center_m.y}, 1.0, 0.0, 0.5 * box.size_m.x, 0.5 * box.size_m.y}, {}};
}

/// Walks a tree, checks what must hold for each node, and gathers the pieces.
void gather(const Tree& tree, const Node& node, std::multiset<const Obstacle*>& found) {
  ASSERT_GT(node.count(), 0U);
  ASSERT_EQ(node.used, (1U << node.count()) - 1U) << "the used entries are the first ones";
  for (std::size_t i = 0; i < node.count(); ++i) {
    if (node.isLeaf()) {
      const Piece& piece = *static_cast<const Leaf&>(node).pieces[i];
      found.insert(piece.obstacle.get());
      withCorners(piece, [&](ConvexView corners) {
        for (const Point p : corners) {
          ASSERT_LE(node.areas.min_x[i], p.x - tree.origin.x);
          ASSERT_GE(node.areas.max_x[i], p.x - tree.origin.x);
          ASSERT_LE(node.areas.min_y[i], p.y - tree.origin.y);
          ASSERT_GE(node.areas.max_y[i], p.y - tree.origin.y);
        }
      });
      continue;
    }
    const Node& below = *static_cast<const Branch&>(node).below[i];
    ASSERT_EQ(below.height + 1, node.height) << "all leaves are equally deep";
    for (std::size_t k = 0; k < below.count(); ++k) {
      ASSERT_LE(node.areas.min_x[i], below.areas.min_x[k]);
      ASSERT_GE(node.areas.max_x[i], below.areas.max_x[k]);
      ASSERT_LE(node.areas.min_y[i], below.areas.min_y[k]);
      ASSERT_GE(node.areas.max_y[i], below.areas.max_y[k]);
    }
    gather(tree, below, found);
  }
}

std::multiset<const Obstacle*> piecesOf(const Tree& tree) {
  std::multiset<const Obstacle*> found;
  if (tree.root) gather(tree, *tree.root, found);
  return found;
}

TEST(PieceTree, OfAnySizeHoldsEachPieceOnceInFullLeaves) {
  test::RandomWorld random(1);
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 64U, 65U, 100U, 512U, 513U, 5000U}) {
    std::vector<Piece> pieces;
    std::multiset<const Obstacle*> wanted;
    for (std::size_t i = 0; i < count; ++i) {
      pieces.push_back(randomPiece(random));
      wanted.insert(pieces.back().obstacle.get());
    }
    EXPECT_EQ(piecesOf(treeOf(pieces)), wanted) << count;
  }
}

TEST(PieceTree, ManyChangesKeepItWholeAndEarlierTreesAsTheyWere) {
  test::RandomWorld random(2);
  Tree dut;
  std::vector<Piece> held;
  std::vector<std::pair<Tree, std::multiset<const Obstacle*>>> earlier;
  const auto wanted = [&] {
    std::multiset<const Obstacle*> all;
    for (const Piece& piece : held) all.insert(piece.obstacle.get());
    return all;
  };
  for (int step = 0; step < 4000; ++step) {
    if (held.empty() || random.oneOf(100) < (step < 2500 ? 65 : 25)) {
      held.push_back(randomPiece(random));
      dut = with(dut, std::make_shared<const Piece>(held.back()));
    } else {
      const auto i = static_cast<std::ptrdiff_t>(random.oneOf(static_cast<int>(held.size())));
      dut = without(dut, held[static_cast<std::size_t>(i)]);
      held.erase(held.begin() + i);
    }
    if (step % 400 == 0) {
      ASSERT_EQ(piecesOf(dut), wanted()) << "after " << step << " changes";
      earlier.emplace_back(dut, wanted());
    }
  }
  EXPECT_EQ(piecesOf(dut), wanted());
  for (const auto& [tree, pieces] : earlier) EXPECT_EQ(piecesOf(tree), pieces);
}

TEST(PieceTree, WithoutWhatIsNotThereIsTheSame) {
  test::RandomWorld random(3);
  const Tree dut = treeOf({randomPiece(random), randomPiece(random)});
  EXPECT_EQ(without(dut, randomPiece(random)).root, dut.root);
  EXPECT_EQ(without(Tree{}, randomPiece(random)).root, nullptr);
}

TEST(RectangleAround, HoldsItsPointsAndIsTheSmallestAlongAnEdge) {
  test::RandomWorld random(4);
  for (int i = 0; i < 1000; ++i) {
    std::vector<Point> points;
    for (int k = 0; k < 3 + random.oneOf(8); ++k)
      points.push_back({random.between(0.0, 1.0), random.between(0.0, 0.3)});
    const std::vector<Point> hull = convexHull(points);
    const Rectangle dut = rectangleAround(hull);
    const auto corners = cornersOf(dut);
    for (const Point p : hull) ASSERT_LT(distanceTo(corners, p), 1e-12);
    ASSERT_LE(dut.half_x * dut.half_y, 0.5 * 0.15 * 1.6) << "hardly larger than the axis-aligned one";
  }
}

TEST(RectangleAround, APointAndALineIsThePointAndTheLine) {
  const Rectangle point = rectangleAround(std::vector<Point>{{3, 4}});
  EXPECT_EQ(point.half_x, 0.0);
  EXPECT_EQ(point.half_y, 0.0);
  const Rectangle line = rectangleAround(std::vector<Point>{{0, 0}, {3, 4}});
  EXPECT_NEAR(line.half_x, 2.5, 1e-15);
  EXPECT_NEAR(line.half_y, 0.0, 1e-15);
}

}  // namespace
}  // namespace underway
