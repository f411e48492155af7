#include "apps/table.hpp"

#include <gtest/gtest.h>

#include "apps/plan_table.hpp"

namespace underway {
namespace {

TEST(Table, ColumnsAreAlignedAndLinesEndWithoutBlanks) {
  Table table({{"name"}, {"m", Table::Align::kRight}, {"at"}});
  table.add({{"a"}, {"1.5"}, {""}});
  table.add({{"longer"}, {"22.25"}, {"end"}});
  EXPECT_EQ(table.text(false),
            "name        m  at\n"
            "a         1.5\n"
            "longer  22.25  end\n");
}

TEST(Table, WidthsCountCharactersNotBytes) {
  Table table({{"id"}, {"x"}});
  table.add({{"T\xC3\xBCr"}, {"1"}});
  EXPECT_EQ(table.text(false), "id   x\nT\xC3\xBCr  1\n");
}

TEST(Table, ColoursDoNotShiftColumns) {
  Table table({{"mode"}, {"x"}});
  table.add({{"crawl", "33"}, {"1"}});
  EXPECT_EQ(table.text(true), "\x1b[1mmode\x1b[0m   \x1b[1mx\x1b[0m\n\x1b[33mcrawl\x1b[0m  1\n");
}

TEST(Table, NamesFromFilesCannotMoveTheCursor) {
  Table table({{"id"}});
  table.add({{"a\x1b[2Jb\nc"}});
  EXPECT_EQ(table.text(false), "id\na [2Jb c\n");
}

TEST(Table, ARowOfAnotherLengthIsAMistake) {
  Table table({{"a"}, {"b"}});
  EXPECT_THROW(table.add({{"1"}}), std::invalid_argument);
}

PlanDocument makeDocument() {
  PlanDocument document{{}, "nao", {"frontal", "lateral", "crawl"}, "room", 1, "w", "r", 1, Plan{}};
  const Motion walk = translate(0, Sense::kForward, {0.6, 2.0, 0.0}, 1.5);
  Plan& plan = *document.answer;
  plan.segments = {{walk, 22.1, {0.12, Nearest{"wall", {1.0, 2.5}}, 0.25}},
                   {turn(0, walk.to, -0.5, -0.5), 3.0, {1.0, {}, {}}}};
  plan.total_time_s = 25.1;
  plan.length_m = 1.5;
  return document;
}

TEST(PlanTable, APlanIsOneLineASegmentAndItsTotals) {
  const std::string text = describe(makeDocument(), false);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  for (const char* part :
       {"forward 1.500 m", "turn -0.500 rad", "0.600,2.000,0.000", "2.100,2.000,0.000", ">= 1.000", "wall",
        "0.250", "Total 25.1 s, 1.50 m (frontal 1.50 m), least clearance 0.120 m"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
}

TEST(PlanTable, APlanWithoutSegmentsSaysThatTheRobotIsThere) {
  PlanDocument document = makeDocument();
  document.answer = Plan{};
  EXPECT_EQ(describe(document, false), "The robot is there already.\n");
}

TEST(PlanTable, AFailureShowsWhatIsInTheWay) {
  PlanDocument document = makeDocument();
  document.answer = tl::unexpected(
      Error{ErrorCode::kNoPathExists, "too low", {{"table_top", "crawl", "height", 0.21, 0.19}}});
  EXPECT_EQ(describe(document, false),
            "No plan: no_path_exists.\n"
            "in the way  mode   of      needs m  has m\n"
            "table_top   crawl  height    0.210  0.190\n");
}

}  // namespace
}  // namespace underway
