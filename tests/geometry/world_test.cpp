#include "geometry/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace underway {
namespace {

const Bounds kRoom{{0, 0, 0}, 6, 4};

std::string refusalOf(const Bounds& bounds, std::vector<Obstacle> obstacles) {
  const auto dut = World::make("room", bounds, 0.0, std::move(obstacles));
  if (dut) return "accepted";
  EXPECT_EQ(dut.error().code, ErrorCode::kInvalidMap);
  return dut.error().message;
}

TEST(World, RefusesObstaclesThatAreNoBoxesAndSaysWhich) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusalOf(kRoom, {{"a", {{0, 0, 0}, {1, 0, 1}, {}}}}).find("obstacle \"a\": size_m"),
            std::string::npos);
  EXPECT_NE(refusalOf(kRoom, {{"b", {{0, 0, 0}, {1, -1, 1}, {}}}}).find("\"b\""), std::string::npos);
  EXPECT_NE(refusalOf(kRoom, {{"c", {{nan, 0, 0}, {1, 1, 1}, {}}}}).find("finite"), std::string::npos);
  EXPECT_NE(refusalOf(kRoom, {{"d", {{1e6, 0, 0}, {1, 1, 1}, {}}}}).find("100 km"), std::string::npos);
  EXPECT_NE(refusalOf(kRoom, {{"", {{0, 0, 0}, {1, 1, 1}, {}}}}).find("no id"), std::string::npos);
}

TEST(World, RefusesAnIdGivenTwice) {
  const OrientedBox box{{0, 0, 0}, {1, 1, 1}, {}};
  EXPECT_NE(refusalOf(kRoom, {{"twin", box}, {"other", box}, {"twin", box}}).find("\"twin\" is given twice"),
            std::string::npos);
}

TEST(World, RefusesBoundsWithoutAnInside) {
  EXPECT_NE(refusalOf({{0, 0, 0}, 0, 4}, {}).find("bounds"), std::string::npos);
  EXPECT_NE(refusalOf({{0, 0, 0}, 6, -1}, {}).find("bounds"), std::string::npos);
}

TEST(World, HashTellsEveryChangeAndNoOther) {
  const Obstacle box{"a", {{1, 1, 1}, {1, 1, 1}, {}}};
  Obstacle moved = box;
  moved.box.center_m.x = std::nextafter(1.0, 2.0);
  const World dut = *World::make("one", kRoom, 0.0, {box});
  EXPECT_EQ(dut.hash(), World::make("another name", kRoom, 0.0, {box})->hash());
  EXPECT_NE(dut.hash(), World::make("one", kRoom, 0.0, {moved})->hash());
  EXPECT_NE(dut.hash(), World::make("one", kRoom, 0.1, {box})->hash());
  EXPECT_EQ(dut.hash().size(), 16U);
}

TEST(World, ChangesMakeTheNextRevisionAndLeaveThisOneAsItIs) {
  const OrientedBox here{{1, 1, 1}, {1, 1, 1}, {}};
  const OrientedBox there{{3, 1, 1}, {1, 1, 1}, {}};
  const World first = *World::make("room", kRoom, 0.0, {{"a", here}});
  const World second = *first.added({"b", here});
  const World third = *second.moved("a", there);
  const World fourth = *third.removed("b");
  EXPECT_EQ(first.revision(), 1U);
  EXPECT_EQ(fourth.revision(), 4U);
  EXPECT_EQ(first.obstacles().size(), 1U);
  EXPECT_EQ(second.obstacles().size(), 2U);
  EXPECT_EQ(first.obstacles()[0].box, here);
  EXPECT_EQ(fourth.obstacles()[0].box, there);
  EXPECT_EQ(fourth.obstacles().size(), 1U);
}

TEST(World, HashTellsWhatIsThereAndNotHowItCame) {
  const OrientedBox here{{1, 1, 1}, {1, 1, 1}, {}};
  const OrientedBox there{{3, 1, 1}, {1, 1, 1}, {}};
  const World dut = *World::make("room", kRoom, 0.0, {{"a", here}, {"b", there}});
  const World other_order = *World::make("room", kRoom, 0.0, {{"b", there}, {"a", here}});
  const World by_changes = *World::make("room", kRoom, 0.0, {{"c", here}, {"a", there}})
                                ->removed("c")
                                ->moved("a", here)
                                ->added({"b", there});
  EXPECT_EQ(dut.hash(), other_order.hash());
  EXPECT_EQ(dut.hash(), by_changes.hash());
  EXPECT_NE(dut.hash(), dut.moved("a", there)->hash());
  EXPECT_NE(dut.hash(), dut.removed("a")->hash());
}

TEST(World, HashTellsObstaclesThatExchangedTheirNumbers) {
  const auto hash = [](double a, double b, double first_yaw, double second_yaw) {
    return World::make("room", kRoom, 0.0,
                       {{"box_0", {{1, a, .5}, {.5, .3, 1}, {0, 0, first_yaw}}},
                        {"box_1", {{3, b, .5}, {.5, .3, 1}, {0, 0, second_yaw}}}})
        ->hash();
  };
  EXPECT_NE(hash(1, 2, 0.0, 2.0), hash(1, 2, 2.0, 0.0));
  EXPECT_NE(hash(1, 2, 0.0, 0.0), hash(2, 1, 0.0, 0.0));
}

TEST(World, RefusesChangesThatCannotBeAndSaysWhy) {
  const OrientedBox box{{1, 1, 1}, {1, 1, 1}, {}};
  const OrientedBox flat{{1, 1, 1}, {1, 1, 0}, {}};
  const World dut = *World::make("room", kRoom, 0.0, {{"a", box}});
  EXPECT_NE(dut.added({"a", box}).error().message.find("\"a\" is taken"), std::string::npos);
  EXPECT_NE(dut.added({"b", flat}).error().message.find("obstacle \"b\": size_m"), std::string::npos);
  EXPECT_NE(dut.moved("a", flat).error().message.find("obstacle \"a\": size_m"), std::string::npos);
  EXPECT_NE(dut.moved("b", box).error().message.find("no obstacle \"b\""), std::string::npos);
  EXPECT_NE(dut.removed("b").error().message.find("no obstacle \"b\""), std::string::npos);
}

TEST(Bounds, ContainTheirEdgesAndTurnWithTheirCorner) {
  EXPECT_TRUE(kRoom.contains({0, 0}));
  EXPECT_TRUE(kRoom.contains({6, 4}));
  EXPECT_FALSE(kRoom.contains({6.000001, 4}));
  const Bounds turned{{1, 1, 1.5707963267948966}, 6, 4};  // its width runs along y, its height along -x
  EXPECT_TRUE(turned.contains({0, 5}));
  EXPECT_FALSE(turned.contains({2, 5}));
  EXPECT_NEAR(turned.corners()[2].x, -3.0, 1e-12);
  EXPECT_NEAR(turned.corners()[2].y, 7.0, 1e-12);
}

}  // namespace
}  // namespace underway
