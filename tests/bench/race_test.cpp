#include "bench/race.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "bench/ompl_log.hpp"
#include "bench/race_plots.hpp"

namespace underway::bench {
namespace {

Race raceOf(std::vector<Run> own, std::vector<Run> peer) {
  return {"query", 10.0, {{kOwnName, std::move(own)}, {"PRM", std::move(peer)}}};
}

const Run kSolved{{{0.01, 12.0}, {0.05, 10.5}, {0.2, 10.0}}, 1.0, false};
const Run kUnsolved{{}, 1.0, true};

TEST(Race, KnowsWhenARunHadItsFirstPlanAndAGoodOne) {
  EXPECT_EQ(firstTime(kSolved), 0.01);
  EXPECT_EQ(timeWithin(kSolved, 11.0), 0.05);
  EXPECT_EQ(costAt(kSolved, 0.1), 10.5);
  EXPECT_FALSE(costAt(kSolved, 0.001).has_value());
  EXPECT_FALSE(firstTime(kUnsolved).has_value());
}

TEST(Race, CountsARunThatNeverSolvedAsInfinite) {
  EXPECT_EQ(quantileOf({0.5, std::nullopt, 0.1}, 0.5), 0.5);
  EXPECT_TRUE(std::isinf(quantileOf({0.5, std::nullopt, std::nullopt}, 0.5)));
}

/// Reads a log as OMPL's ompl_benchmark_statistics.py does, as far as counts and fields go.
class LogReader {
 public:
  explicit LogReader(const std::string& text) : in_(text) {}

  std::string line() {
    std::string line;
    EXPECT_TRUE(std::getline(in_, line)) << "the log ends too early";
    return line;
  }
  /// The number at the beginning of a line that ends with the words.
  double number(const std::string& words) {
    const std::string text = line();
    EXPECT_TRUE(text.ends_with(words)) << text;
    return std::stod(text);
  }
  bool atEnd() { return in_.peek() == std::char_traits<char>::eof(); }

 private:
  std::istringstream in_;
};

std::size_t fieldsIn(const std::string& line, const std::string& separator) {
  std::size_t fields = 0;
  for (std::size_t at = line.find(separator); at != std::string::npos;
       at = line.find(separator, at + separator.size()))
    ++fields;
  return fields;
}

TEST(OmplLog, IsOfTheFormThatOmplsScriptReads) {
  LogReader dut(toOmplLog({"room", "map room\nrobot nao", "host", "2026-01-01 00:00:00", 1.0, 7},
                          {raceOf({kSolved, kSolved}, {kSolved, kUnsolved})}));
  EXPECT_TRUE(dut.line().starts_with("OMPL version "));
  EXPECT_EQ(dut.line(), "Experiment room");
  EXPECT_EQ(dut.line(), "Running on host");
  EXPECT_EQ(dut.line(), "Starting at 2026-01-01 00:00:00");
  EXPECT_EQ(dut.line(), "<<<|");
  while (dut.line() != "|>>>") continue;
  EXPECT_EQ(dut.number("is the random seed"), 7);
  EXPECT_EQ(dut.number("seconds per run"), 1);
  dut.number("MB per run");
  EXPECT_EQ(dut.number("runs per planner"), 2);
  EXPECT_EQ(dut.number("seconds spent to collect the data"), 4);
  EXPECT_EQ(dut.number("enum types"), 0);
  const auto planners = static_cast<int>(dut.number("planners"));
  ASSERT_EQ(planners, 2);
  for (int planner = 0; planner < planners; ++planner) {
    EXPECT_FALSE(dut.line().empty()) << "the planner's name";
    EXPECT_EQ(dut.number("common properties"), 0);
    const auto properties = static_cast<std::size_t>(dut.number("properties for each run"));
    for (std::size_t i = 0; i < properties; ++i) {
      const std::string property = dut.line();
      EXPECT_TRUE(property.ends_with(" REAL") || property.ends_with(" BOOLEAN")) << property;
    }
    ASSERT_EQ(dut.number("runs"), 2);
    for (int run = 0; run < 2; ++run) EXPECT_EQ(fieldsIn(dut.line(), "; "), properties);
    ASSERT_EQ(dut.number("progress properties for each run"), 2);
    EXPECT_EQ(dut.line(), "time REAL");
    EXPECT_EQ(dut.line(), "best cost REAL");
    ASSERT_EQ(dut.number("runs"), 2);
    for (int run = 0; run < 2; ++run) {
      const std::string progress = dut.line();
      EXPECT_EQ(fieldsIn(progress, ","), 2 * fieldsIn(progress, ";"));
    }
    EXPECT_EQ(dut.line(), ".");
  }
  EXPECT_TRUE(dut.atEnd());
}

TEST(RacePlots, DrawACurveForEachPlanner) {
  const std::vector<Race> races{raceOf({kSolved, kSolved}, {kUnsolved, kUnsolved})};
  for (const std::string& dut :
       {plotFirstPlan(races, 1.0), plotWithinTenPercent(races, 1.0), plotCost(races, 1.0)}) {
    EXPECT_TRUE(dut.starts_with("<svg "));
    EXPECT_NE(dut.find(">underway<"), std::string::npos);
    EXPECT_NE(dut.find(">PRM"), std::string::npos);
  }
  EXPECT_NE(plotCost(races, 1.0).find("PRM (none)"), std::string::npos);
}

}  // namespace
}  // namespace underway::bench
