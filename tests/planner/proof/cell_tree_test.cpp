#include "planner/proof/cell_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace underway::proof {
namespace {

CellTree randomTree(unsigned seed, bool joins_headings) {
  std::mt19937 random(seed);
  CellTree tree(joins_headings);
  for (int i = 0; i < 300; ++i) {
    const auto cell = static_cast<CellId>(random() % tree.size());
    const std::size_t axis = random() % 3;
    if (tree.canSplit(cell, axis)) tree.split(cell, axis);
  }
  return tree;
}

std::set<CellId> neighboursOf(const CellTree& tree, CellId cell) {
  const auto row = tree.neighbours(cell);
  return {row.begin(), row.end()};
}

TEST(CellTree, KnowsWhichCellsShareAFace) {
  for (const bool joins_headings : {true, false}) {
    const CellTree dut = randomTree(3, joins_headings);
    for (CellId a = 0; a < dut.size(); ++a) {
      std::set<CellId> expected;
      for (CellId b = 0; b < dut.size(); ++b) {
        const Contact contact = contactOf(dut.box(a), dut.box(b));
        if (a != b && contact.is_face && (joins_headings || contact.axis != kYaw)) expected.insert(b);
      }
      EXPECT_EQ(neighboursOf(dut, a), expected) << "cell " << a;
      EXPECT_EQ(dut.neighbours(a).size(), expected.size()) << "cell " << a;
    }
  }
}

TEST(CellTree, JoinsTheFirstAndTheLastHeading) {
  EXPECT_EQ(neighboursOf(CellTree(true), 0).size(), 2U);
  EXPECT_TRUE(neighboursOf(CellTree(false), 0).empty());
}

TEST(CellTree, CellsFillTheWholeOnceAlsoAfterManySplits) {
  const CellTree dut = randomTree(4, true);
  double volume = 0.0;
  for (CellId cell = 0; cell < dut.size(); ++cell) {
    double product = 1.0;
    for (const UnitRange range : dut.box(cell))
      product *= static_cast<double>(range.high - range.low) / kWholeAxis;
    volume += product;
  }
  EXPECT_DOUBLE_EQ(volume, 1.0);
}

TEST(CellTree, FindsAllCellsThatTouchABoxAlsoAcrossTheLastHeading) {
  const CellTree dut = randomTree(5, true);
  std::mt19937 random(6);
  const auto range = [&](Units lowest, Units highest) {
    std::uniform_int_distribution<Units> draw(lowest, highest);
    const auto [low, high] = std::minmax({draw(random), draw(random)});
    return UnitRange{low, high};
  };
  for (int round = 0; round < 200; ++round) {
    const CellBox box{range(0, kWholeAxis), range(0, kWholeAxis), range(-kWholeAxis / 2, kWholeAxis + 1000)};
    std::vector<CellId> found;
    dut.findTouching(box, found);
    const std::set<CellId> dut_found(found.begin(), found.end());
    for (CellId cell = 0; cell < dut.size(); ++cell) {
      bool touches = false;
      for (const Units turned : {-kWholeAxis, 0, kWholeAxis}) {
        bool all = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Units by = axis == kYaw ? turned : 0;
          const UnitRange own = dut.box(cell)[axis];
          all = all && own.low <= box[axis].high + by && box[axis].low + by <= own.high;
        }
        touches = touches || all;
      }
      ASSERT_EQ(dut_found.contains(cell), touches) << "cell " << cell;
    }
  }
}

}  // namespace
}  // namespace underway::proof
