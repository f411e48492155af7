#include "planner/place_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

TEST(PlaceIndex, FindsTheSameNearestPlacesAsLookingAtAll) {
  test::RandomWorld random(1);
  for (int round = 0; round < 50; ++round) {
    std::vector<PlaceIndex::Entry> entries;
    const double width = random.oneOf(2) == 0 ? 20.0 : 0.01;  // also all in a row
    for (std::uint32_t i = 0; i < 1U + static_cast<unsigned>(random.oneOf(300)); ++i)
      entries.push_back({{random.between(0.0, width), random.between(-3.0, 9.0)},
                         static_cast<GroupId>(random.oneOf(2)),
                         i});
    const PlaceIndex dut(entries);
    for (int query = 0; query < 50; ++query) {
      const Point to{random.between(-10.0, 30.0), random.between(-10.0, 20.0)};
      std::vector<std::pair<double, std::uint32_t>> all;
      for (const auto& entry : entries)
        if (entry.group == 1) all.emplace_back(distance(entry.at, to), entry.place);
      std::sort(all.begin(), all.end());
      const auto found = dut.nearest(1, to, 7);
      ASSERT_EQ(found.size(), std::min<std::size_t>(7, all.size()));
      for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i], all[i].second);
    }
  }
}

TEST(PlaceIndex, OfNothingOrAnUnknownGroupFindsNothing) {
  EXPECT_TRUE(PlaceIndex().nearest(0, {0, 0}, 5).empty());
  EXPECT_TRUE(PlaceIndex({{{1, 1}, 0, 0}}).nearest(3, {0, 0}, 5).empty());
}

}  // namespace
}  // namespace underway
