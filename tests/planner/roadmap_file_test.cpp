#include "planner/roadmap_file.hpp"

#include <gtest/gtest.h>

#include "tests/planner/stored_roadmap.hpp"

namespace underway {
namespace {

using test::expectTrue;
using test::nao;
using test::ourWorld;
using test::requestFor;
using test::sealed;
using test::smallRoom;
using test::soon;

std::string preparedBytes(const std::shared_ptr<const World>& world, GrowthSettings settings = {}) {
  Planner planner(world, nao(), settings);
  planner.prepare(soon());
  return planner.save();
}

/// The sentence with which a planner refuses bytes.
std::string refusalOf(Planner& planner, std::string_view bytes) {
  const Expected<Loaded> loaded = planner.load(bytes);
  EXPECT_FALSE(loaded);
  EXPECT_FALSE(planner.roadmap()) << "what is refused is not used";
  return loaded ? "" : loaded.error().message;
}
std::string refusalOf(std::string_view bytes, GrowthSettings settings = {}) {
  Planner planner(smallRoom(), nao(), settings);
  return refusalOf(planner, bytes);
}

bool says(const std::string& sentence, std::string_view part) {
  return sentence.find(part) != std::string::npos || (ADD_FAILURE() << sentence, false);
}

class StoredRoadmap : public ::testing::TestWithParam<const char*> {};

TEST_P(StoredRoadmap, ComesBackBitForBit) {
  const auto world = ourWorld(GetParam());
  Planner before(world, nao());
  before.prepare(soon());
  Planner dut(world, nao());
  const Expected<Loaded> loaded = dut.load(before.save());
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_TRUE(loaded->is_of_this_world);
  EXPECT_EQ(loaded->batches, before.roadmap()->batches);
  EXPECT_EQ(dut.save(), before.save());

  const Roadmap& a = *before.roadmap();
  const Roadmap& b = *dut.roadmap();
  EXPECT_EQ(a.crossings_in, b.crossings_in);
  EXPECT_EQ(a.first_in, b.first_in);
  EXPECT_EQ(a.node_count, b.node_count);
  EXPECT_EQ(a.edge_count, b.edge_count);
  EXPECT_EQ(a.main_index.size(), b.main_index.size());
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    ASSERT_EQ(a.places[i].turns_freely, b.places[i].turns_freely);
    ASSERT_EQ(a.places[i].keep_m, b.places[i].keep_m);
  }
  for (std::size_t i = 0; i < a.links.size(); ++i) {
    ASSERT_EQ(a.links[i].tried, b.links[i].tried);
    ASSERT_EQ(a.links[i].direction_rad, b.links[i].direction_rad);
    ASSERT_EQ(a.links[i].length_m, b.links[i].length_m);
  }
}

TEST_P(StoredRoadmap, GrowsOnAsIfItHadNeverStopped) {
  const auto checker = std::make_shared<const Checker>(ourWorld(GetParam()), nao());
  const RoadmapKey key = keyOf(*checker, {});
  Growth uninterrupted(checker, {});
  for (int i = 0; i < 3; ++i) uninterrupted.addBatch();
  const std::string saved = toBytes(uninterrupted.freeze(), key);
  for (int i = 0; i < 4; ++i) uninterrupted.addBatch();

  Growth dut(checker, {});
  dut.addBatch();  // dropped
  const Stances stances(*checker, Policy::kFastest);
  const Expected<LoadedRoadmap> loaded = load(saved, key, stances, *checker);
  ASSERT_TRUE(loaded) << loaded.error().message;
  dut.takeOver(loaded->roadmap);
  for (int i = 0; i < 4; ++i) dut.addBatch();
  EXPECT_EQ(dut.batches(), 7U);
  EXPECT_EQ(toBytes(dut.freeze(), key), toBytes(uninterrupted.freeze(), key));
}

INSTANTIATE_TEST_SUITE_P(OurMaps, StoredRoadmap, ::testing::Values("scenario1", "scenario3", "flat"));

TEST(RoadmapFile, HalfAnEarlierRoadmapIsPreparedToTheEnd) {
  const auto world = smallRoom();
  Planner dut(world, nao());
  ASSERT_TRUE(dut.load(test::grownBytes(std::make_shared<const Checker>(world, nao()), 1)));
  dut.prepare(soon());
  EXPECT_EQ(dut.save(), preparedBytes(world));
}

TEST(RoadmapFile, GivesTheSamePlansAsTheRoadmapItKeeps) {
  const auto world = ourWorld("scenario3");
  Planner before(world, nao());
  before.prepare(soon());
  Planner dut(world, nao());
  ASSERT_TRUE(dut.load(before.save()));
  const Request request = requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0});
  const Expected<Plan> a = before.plan(request, soon());
  const Expected<Plan> b = dut.plan(request, soon());
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->segments.size(), b->segments.size());
  for (std::size_t i = 0; i < a->segments.size(); ++i)
    EXPECT_EQ(a->segments[i].motion, b->segments[i].motion);
}

TEST(RoadmapFile, IsNothingBeforeAnythingHasGrown) {
  EXPECT_EQ(Planner(smallRoom(), nao()).save(), "");
  EXPECT_TRUE(says(refusalOf(""), "no roadmap file"));
}

TEST(RoadmapFile, IsNotLoadedOverARoadmap) {
  Planner dut(smallRoom(), nao());
  dut.prepare(soon());
  const std::string before = dut.save();
  const Expected<Loaded> loaded = dut.load(before);
  ASSERT_FALSE(loaded);
  EXPECT_TRUE(says(loaded.error().message, "before the first plan"));
  EXPECT_EQ(dut.save(), before);
}

TEST(RoadmapFile, OfAnotherRobotIsRefused) {
  Robot other = *nao();
  other.modes[0].speed_mps[0] += 0.01;
  Planner dut(smallRoom(), std::make_shared<const Robot>(other));
  EXPECT_TRUE(says(refusalOf(dut, preparedBytes(smallRoom())), "another robot"));
}

TEST(RoadmapFile, OfAnotherSeedIsRefused) {
  EXPECT_TRUE(says(refusalOf(preparedBytes(smallRoom()), {7, 3.0}), "seed 1, not 7"));
}

TEST(RoadmapFile, OfOtherSettingsIsRefused) {
  EXPECT_TRUE(says(refusalOf(preparedBytes(smallRoom()), {1, 4.5}), "3 sites per square metre, not 4.5"));
}

TEST(RoadmapFile, OfAnotherVersionIsRefused) {
  std::string bytes = preparedBytes(smallRoom());
  ++bytes[test::kVersionAt];
  EXPECT_TRUE(says(refusalOf(bytes), "version 2"));
}

TEST(RoadmapFile, OfAnotherWorldIsLookedAtAgain) {
  const std::string bytes = preparedBytes(smallRoom());
  const auto moved = smallRoom(2.1);
  Planner dut(moved, nao());
  const Expected<Loaded> loaded = dut.load(bytes);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_FALSE(loaded->is_of_this_world);
  EXPECT_GT(loaded->repair.closed, 0U);
  EXPECT_GT(loaded->repair.opened, 0U);
  expectTrue(*dut.roadmap(), *dut.checker());
  Planner next(moved, nao());
  const Expected<Loaded> again = next.load(dut.save());
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_TRUE(again->is_of_this_world) << "it is saved for the world it was looked at in";
}

TEST(RoadmapFile, OfAQuiteDifferentWorldIsRefused) {
  Planner dut(smallRoom(), nao());
  EXPECT_TRUE(says(refusalOf(dut, preparedBytes(ourWorld("flat"))), "too different"));
}

TEST(RoadmapFile, ThatCallsABlockedWayFreeIsRefused) {
  // The roadmap of a room without the pillar, said to be this room's.
  auto empty = std::make_shared<const World>(*smallRoom()->removed("pillar"));
  std::string bytes = preparedBytes(empty);
  const std::string hash = smallRoom()->hash();
  bytes.replace(test::kBodyAt, hash.size(), hash);
  EXPECT_TRUE(says(refusalOf(sealed(bytes)), "lies"));
}

TEST(RoadmapFile, ThatCallsAFreeWayBlockedIsRefused) {
  std::string bytes = preparedBytes(smallRoom());
  auto empty = std::make_shared<const World>(*smallRoom()->removed("pillar"));
  bytes.replace(test::kBodyAt, RoadmapKey::kHashDigits, empty->hash());
  Planner dut(empty, nao());
  EXPECT_TRUE(says(refusalOf(dut, sealed(bytes)), "lies"));
}

}  // namespace
}  // namespace underway
