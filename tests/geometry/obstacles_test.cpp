#include "geometry/obstacles.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

Obstacles tableOf(std::vector<Obstacle> obstacles) {
  std::optional<std::string> twin;
  Obstacles table(std::move(obstacles), twin);
  EXPECT_FALSE(twin);
  return table;
}

std::map<std::string, OrientedBox> contentOf(const Obstacles& table) {
  std::map<std::string, OrientedBox> content;
  for (const Obstacle& obstacle : table) content[obstacle.id] = obstacle.box;
  return content;
}

class ObstaclesProperty : public testing::TestWithParam<unsigned> {
 protected:
  test::RandomWorld random{GetParam()};
};

TEST_P(ObstaclesProperty, ManyChangesLeaveWhatAMapWouldHoldAndEarlierTablesAsTheyWere) {
  Obstacles dut;
  std::map<std::string, OrientedBox> model;
  std::vector<std::pair<Obstacles, std::map<std::string, OrientedBox>>> earlier;
  for (int step = 0; step < 3000; ++step) {
    const bool grows = random.oneOf(100) < (step < 2000 ? 60 : 20);
    if (grows || model.empty()) {
      const std::string id = std::to_string(step);
      const OrientedBox box = random.box(true);
      dut = dut.with({id, box});
      model[id] = box;
    } else {
      const std::size_t i = static_cast<std::size_t>(random.oneOf(static_cast<int>(dut.size())));
      const std::string id = dut[i].id;
      if (random.oneOf(2) == 0) {
        dut = dut.without(i);
        model.erase(id);
      } else {
        model[id] = random.box(true);
        dut = dut.withBox(i, model[id]);
      }
    }
    if (step % 500 == 0) earlier.emplace_back(dut, model);
    ASSERT_EQ(dut.size(), model.size());
  }
  EXPECT_EQ(contentOf(dut), model);
  for (const auto& [id, box] : model) {
    ASSERT_TRUE(dut.find(id)) << id;
    EXPECT_EQ(dut[*dut.find(id)].id, id);
  }
  EXPECT_FALSE(dut.find("nobody"));
  for (const auto& [table, content] : earlier) EXPECT_EQ(contentOf(table), content);
}

TEST_P(ObstaclesProperty, ChangesLeadFromOneTableToTheOther) {
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 500; ++i) obstacles.push_back({std::to_string(i), random.box(false)});
  const Obstacles before = tableOf(obstacles);
  Obstacles after = before;
  for (int k = 0; k < 20; ++k) {
    const auto at = static_cast<std::size_t>(random.oneOf(static_cast<int>(after.size())));
    after = k % 3 == 0   ? after.without(at)
            : k % 3 == 1 ? after.withBox(at, random.box(false))
                         : after.with({std::to_string(1000 + k), random.box(false)});
  }
  std::multiset<const Obstacle*> led;
  for (std::size_t i = 0; i < before.size(); ++i) led.insert(before.pointer(i).get());
  const auto changes = Obstacles::changes(before, after);
  EXPECT_LE(changes.size(), 40U) << "shares what did not change";
  for (const auto& [gone, come] : changes) {
    if (gone) led.erase(led.find(gone.get()));
    if (come) led.insert(come.get());
  }
  std::multiset<const Obstacle*> wanted;
  for (std::size_t i = 0; i < after.size(); ++i) wanted.insert(after.pointer(i).get());
  EXPECT_EQ(led, wanted);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ObstaclesProperty, testing::Values(1U, 2U, 3U));

TEST(Obstacles, TellTheFirstIdThatIsGivenTwice) {
  std::optional<std::string> twin;
  const Obstacles dut({{"a", {}}, {"b", {}}, {"c", {}}, {"b", {}}, {"a", {}}}, twin);
  EXPECT_EQ(twin, "b");
}

TEST(Obstacles, OfNothingAreEmptyAndTakeMore) {
  const Obstacles none = tableOf({});
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(none.find("a"));
  EXPECT_EQ(none.with({"a", {}}).without(0).size(), 0U);
}

}  // namespace
}  // namespace underway
