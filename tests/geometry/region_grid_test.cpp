#include "geometry/region_grid.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

constexpr unsigned kSeed = 1;

/// What a look at all of them finds.
std::set<std::uint32_t> overlapping(const std::vector<Region>& regions, const Region& region) {
  std::set<std::uint32_t> found;
  for (std::uint32_t i = 0; i < regions.size(); ++i)
    if (regions[i].overlaps(region)) found.insert(i);
  return found;
}

std::set<std::uint32_t> visited(const RegionGrid& dut, const Region& region) {
  std::set<std::uint32_t> found;
  dut.visit(region, [&](std::uint32_t index) { found.insert(index); });
  return found;
}

class Regions {
 public:
  Region any() {
    static constexpr std::array kSizes_m{0.0, 1e-9, 0.01, 0.5, 0.5, 30.0, 1e5};
    const auto size = [&] {
      return random.between(0.0, 1.0) * kSizes_m[static_cast<std::size_t>(random.oneOf(7))];
    };
    const Point at{random.between(-10, 10), random.between(-10, 10)};
    return {at.x, at.y, at.x + size(), at.y + size()};
  }
  /// One that touches another at a corner or along a side, exactly.
  Region touching(const Region& other) {
    const double size = random.between(0.0, 0.5);
    if (random.oneOf(2) == 0) return {other.max_x, other.max_y, other.max_x + size, other.max_y + size};
    return {other.min_x - size, other.min_y, other.min_x, other.max_y};
  }
  test::RandomWorld random{kSeed};
};

void expectAsLookingAtAll(Regions& draw, const std::vector<Region>& regions) {
  const RegionGrid dut(regions);
  for (int i = 0; i < 40; ++i) {
    Region asked = draw.any();
    if (!regions.empty() && draw.random.oneOf(2) == 0)
      asked = draw.touching(
          regions[static_cast<std::size_t>(draw.random.oneOf(static_cast<int>(regions.size())))]);
    ASSERT_EQ(visited(dut, asked), overlapping(regions, asked)) << "seed " << kSeed << " query " << i;
  }
  ASSERT_EQ(visited(dut, {-1e9, -1e9, 1e9, 1e9}).size(), regions.size());
}

TEST(RegionGrid, FindsWhatLookingAtAllFinds) {
  Regions draw;
  for (const int count : {1, 2, 3, 10, 100, 1000}) {
    for (int round = 0; round < 20; ++round) {
      std::vector<Region> regions;
      for (int i = 0; i < count; ++i) regions.push_back(draw.any());
      expectAsLookingAtAll(draw, regions);
    }
  }
}

TEST(RegionGrid, FindsThemInARowOnAPointAndFarApart) {
  Regions draw;
  std::vector<Region> row, column, point, far;
  for (int i = 0; i < 500; ++i) {
    const double at = draw.random.between(-1000, 1000);
    row.push_back({at, 1.0, at + 0.1, 1.0});
    column.push_back({2.0, at, 2.0, at + 0.1});
    point.push_back({3.0, 4.0, 3.0, 4.0});
    far.push_back({at * 1e2, at * at, at * 1e2 + 1.0, at * at + 1.0});
  }
  for (const auto& regions : {row, column, point, far}) expectAsLookingAtAll(draw, regions);
}

TEST(RegionGrid, FindsNothingWhereThereIsNothing) {
  Regions draw;
  expectAsLookingAtAll(draw, {});
  EXPECT_TRUE(visited(RegionGrid(), {-1, -1, 1, 1}).empty());
}

TEST(RegionGrid, TakesNoMoreRoomThanItsRegionsCallFor) {
  // A hundred thousand in a row a thousand kilometres long, and one as large as all of it.
  std::vector<Region> regions{{0.0, 0.0, 1e6, 1e6}};
  for (int i = 0; i < 100'000; ++i) regions.push_back({10.0 * i, 0.0, 10.0 * i + 1.0, 1e-3});
  const RegionGrid dut(regions);
  EXPECT_EQ(visited(dut, {50.0, 0.0, 50.5, 0.0}), (std::set<std::uint32_t>{0, 6}));
}

}  // namespace
}  // namespace underway
