#include "gait/table_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "gait/crawl/gait.hpp"

namespace underway::gait {
namespace {

TEST(TableText, CsvReadsBackBitForBit) {
  const JointTable table = *crawlMotion(naoCrawler(), nominalGait(), 2);
  const auto back = tableFromCsv(toCsv(table), "it");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*back, table);
}

TEST(TableText, RefusesBrokenCsvWithTheLine) {
  for (const auto& [text, says] : {std::pair{"", "time_s"},
                                   {"t,a\n", "time_s"},
                                   {"time_s,a\n0,x\n", "line 2"},
                                   {"time_s,a\n0,1\n0,1\n", "line 3"},
                                   {"time_s,a\n0,1,2\n", "line 2"},
                                   {"time_s,a\n0,nan\n", "line 2"},
                                   {"time_s,a,a\n", "twice"}}) {
    const auto table = tableFromCsv(text, "motion.csv");
    ASSERT_FALSE(table) << text;
    EXPECT_NE(table.error().message.find(says), std::string::npos) << table.error().message;
    EXPECT_NE(table.error().message.find("motion.csv"), std::string::npos) << table.error().message;
  }
}

TEST(TableText, JsonIsWhatAngleInterpolationTakes) {
  JointTable table({"HeadYaw", "HeadPitch"});
  table.append(2.0, std::array{0.1, 0.2});
  table.append(2.5, std::array{0.3, 0.4});
  const auto json = nlohmann::json::parse(toNaoqiJson(table, 0.25));
  EXPECT_EQ(json["names"], (std::vector<std::string>{"HeadYaw", "HeadPitch"}));
  EXPECT_EQ(json["angleLists"], (std::vector<std::vector<double>>{{0.1, 0.3}, {0.2, 0.4}}));
  EXPECT_EQ(json["timeLists"], (std::vector<std::vector<double>>{{0.25, 0.75}, {0.25, 0.75}}));
  EXPECT_EQ(json["isAbsolute"], true);
}

}  // namespace
}  // namespace underway::gait
