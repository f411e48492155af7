#include "planner/roadmap.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/stances.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

class GrownRoadmap : public ::testing::TestWithParam<const char*> {
 protected:
  std::shared_ptr<const Checker> shared =
      std::make_shared<const Checker>(test::ourWorld(GetParam()), test::nao());
  const Checker& checker = *shared;
  Stances stances{checker, Policy::kFastest};
  Roadmap dut = test::grown(shared, 1, 3);

  const Legs& legsOf(const Roadmap::Link& link) { return stances.ofGroup(dut.places[link.from].group); }
};

TEST_P(GrownRoadmap, TellsWhichWaysOfItsLinksAreFree) {
  ASSERT_GT(dut.links.size(), 50U);
  for (Roadmap::LinkId id = 0; id < dut.links.size(); ++id) {
    const Roadmap::Link& link = dut.links[id];
    ASSERT_EQ(dut.ways[id] & ~link.tried, 0U);
    if (link.crossing != Roadmap::kNone) {
      for (const Motion& motion : dut.crossings[link.crossing].motions) ASSERT_TRUE(checker.isFree(motion));
      continue;
    }
    const Legs& legs = legsOf(link);
    for (std::size_t way = 0; way < legs.ways().size(); ++way) {
      const Point from = dut.places[link.from].at;
      const Pose pose{from.x, from.y, legs.stanceOn(link.direction_rad, way).yaw};
      const Motion motion =
          translate(legs.ways()[way].mode, legs.ways()[way].sense, pose, dut.places[link.to].at);
      ASSERT_TRUE(std::isfinite(duration(*test::nao(), motion)));
      ASSERT_EQ(checker.isFree(motion), (dut.ways[id] >> way & 1U) != 0);
    }
  }
}

TEST_P(GrownRoadmap, KeepsLinksByTheirPlacesAndInPairs) {
  for (Roadmap::PlaceId place = 0; place < dut.places.size(); ++place)
    for (Roadmap::LinkId id = dut.places[place].first_link; id < dut.places[place].end_link; ++id)
      ASSERT_EQ(dut.links[id].from, place);
  for (Roadmap::LinkId id = 0; id < dut.links.size(); ++id) {
    const Roadmap::Link& link = dut.links[id];
    if (link.twin == Roadmap::kNone) continue;
    ASSERT_EQ(dut.links[link.twin].twin, id);
    ASSERT_EQ(dut.links[link.twin].from, link.to);
    ASSERT_EQ(dut.links[link.twin].to, link.from);
  }
}

TEST_P(GrownRoadmap, HasCrossingsThatBeginAndEndAtTheirPlaces) {
  for (const Roadmap::Link& link : dut.links) {
    if (link.crossing == Roadmap::kNone) continue;
    const Crossing& crossing = dut.crossings[link.crossing];
    ASSERT_EQ(crossing.entry().position(), dut.places[link.from].at);
    ASSERT_EQ(crossing.exit().position(), dut.places[link.to].at);
    for (std::size_t i = 1; i < crossing.motions.size(); ++i)
      ASSERT_EQ(crossing.motions[i].from, crossing.motions[i - 1].to);
  }
}

TEST_P(GrownRoadmap, IsTheSameForTheSameSeedAndBatchesAndAnotherForAnotherSeed) {
  const Roadmap again = test::grown(shared, 1, 3);
  ASSERT_EQ(again.places.size(), dut.places.size());
  ASSERT_EQ(again.links.size(), dut.links.size());
  EXPECT_EQ(again.ways, dut.ways);
  for (std::size_t i = 0; i < dut.places.size(); ++i) ASSERT_EQ(again.places[i].at, dut.places[i].at);
  for (std::size_t i = 0; i < dut.links.size(); ++i) {
    ASSERT_EQ(again.links[i].to, dut.links[i].to);
    ASSERT_EQ(again.links[i].direction_rad, dut.links[i].direction_rad);
  }
  EXPECT_NE(test::grown(shared, 2, 3).links.size(), dut.links.size());
}

INSTANTIATE_TEST_SUITE_P(OurMaps, GrownRoadmap,
                         ::testing::Values("scenario1", "scenario2a", "scenario3", "flat"));

}  // namespace
}  // namespace underway
