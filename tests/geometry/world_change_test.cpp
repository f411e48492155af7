#include "geometry/world_change.hpp"

#include <gtest/gtest.h>

namespace underway {
namespace {

using Kind = WorldChange::Kind;

const OrientedBox kHere{{1.0, 1.0, 0.5}, {0.2, 0.2, 1.0}, {}};
const OrientedBox kThere{{2.0, 1.0, 0.5}, {0.2, 0.2, 1.0}, {}};

World room() { return *World::make("room", {{0, 0, 0}, 4, 3}, 0.0, {{"box", kHere}, {"crate", kThere}}); }

TEST(WorldChange, eachRaisesTheRevisionByOne) {
  const WorldChange changes[] = {
      {Kind::kRemove, "crate"}, {Kind::kMove, "box", kThere}, {Kind::kAdd, "crate", kHere}};
  const Expected<World> dut = changed(room(), changes);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->revision(), 4U);
  EXPECT_EQ(dut->obstacles().size(), 2U);
  EXPECT_EQ(dut->obstacles()[*dut->obstacles().find("box")].box, kThere);
  EXPECT_EQ(dut->obstacles()[*dut->obstacles().find("crate")].box, kHere);
}

TEST(WorldChange, noneIsTheSameWorld) {
  const Expected<World> dut = changed(room(), {});
  ASSERT_TRUE(dut);
  EXPECT_EQ(dut->revision(), 1U);
  EXPECT_EQ(dut->hash(), room().hash());
}

TEST(WorldChange, thereAndBackGivesTheSameHash) {
  const WorldChange changes[] = {{Kind::kMove, "box", kThere}, {Kind::kMove, "box", kHere}};
  EXPECT_EQ(changed(room(), changes)->hash(), room().hash());
}

TEST(WorldChange, allWhoseIdsBeginAlikeGoTogetherAndThereMayBeNone) {
  const WorldChange changes[] = {{Kind::kAdd, "a.seen_1", kHere},
                                 {Kind::kAdd, "ab.seen_1", kHere},
                                 {Kind::kAdd, "a.seen_2", kThere},
                                 {Kind::kRemoveAll, "a.seen_"},
                                 {Kind::kRemoveAll, "a.seen_"}};
  const Expected<World> dut = changed(room(), changes);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->obstacles().size(), 3U);
  EXPECT_TRUE(dut->obstacles().find("ab.seen_1"));
  EXPECT_EQ(dut->revision(), 6U);  // three came, two went
  const WorldChange everything[] = {{Kind::kRemoveAll, ""}};
  EXPECT_FALSE(changed(room(), everything));
}

TEST(WorldChange, thatCannotBeMadeIsNamedByItsNumber) {
  const std::pair<WorldChange, const char*> cases[] = {
      {{Kind::kAdd, "box", kThere}, "box"},
      {{Kind::kMove, "chair", kThere}, "chair"},
      {{Kind::kRemove, "chair"}, "chair"},
      {{Kind::kAdd, "flat", {{1, 1, 1}, {0.1, 0.0, 0.1}, {}}}, "flat"},
  };
  for (const auto& [wrong, id] : cases) {
    const WorldChange changes[] = {{Kind::kRemove, "crate"}, wrong};
    const Expected<World> dut = changed(room(), changes);
    ASSERT_FALSE(dut);
    EXPECT_EQ(dut.error().code, ErrorCode::kInvalidRequest);
    EXPECT_TRUE(dut.error().message.starts_with("change 2 cannot be made: ")) << dut.error().message;
    EXPECT_NE(dut.error().message.find(id), std::string::npos) << dut.error().message;
    EXPECT_NE(dut.error().message.find("none was made"), std::string::npos) << dut.error().message;
  }
}

}  // namespace
}  // namespace underway
