#include "apps/replay.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

using Json = nlohmann::json;

/// As the page reads them.
std::vector<int> unpacked(const std::string& text) {
  static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<int> cm;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2)
    cm.push_back(static_cast<int>(64 * kDigits.find(text[i]) + kDigits.find(text[i + 1])));
  return cm;
}

TEST(PackedRanges, areTheNearestOfEachFewBeamsInCentimetres) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> range(0.02F, 39.9F);
  Scan scan{0.0, Beams{}, {}};
  for (std::size_t i = 0; i < scan.beams.count; ++i) scan.ranges_m.push_back(range(random));
  for (int i = 8; i < 12; ++i) scan.ranges_m[i] = Scan::kNothing;
  const std::vector<int> cm = unpacked(packedRanges(scan));
  ASSERT_EQ(cm.size(), (scan.beams.count + kReplayBeams - 1) / kReplayBeams);
  for (std::size_t k = 0; k < cm.size(); ++k) {
    float nearest = Scan::kNothing;
    for (std::size_t i = k * kReplayBeams; i < std::min((k + 1) * kReplayBeams, scan.beams.count); ++i)
      nearest = std::min(nearest, scan.ranges_m[i]);
    EXPECT_EQ(cm[k], nearest == Scan::kNothing ? 4095 : std::lround(100.0 * nearest)) << k;
  }
}

/// A short run in this process: a robot and its mission in a small room with a table and a box.
struct ReplayTest : testing::Test {
  static std::shared_ptr<const World> room(std::vector<Obstacle> obstacles) {
    return std::make_shared<const World>(
        *World::make("</script>", {{0, 0, 0}, 4, 3}, 0.0, std::move(obstacles)));
  }
  const Obstacle table{"table", {{3.7, 1.5, 0.5}, {0.4, 2.0, 0.04}, {}}};
  const Obstacle step{"step", {{0.2, 2.8, 0.1}, {0.2, 0.2, 0.2}, {}}};
  const Obstacle box{"box", {{1.8, 1.5, 0.4}, {0.2, 0.7, 0.8}, {}}};
  std::shared_ptr<const World> map = room({table, step});
  std::shared_ptr<const World> truth = room({table, step, box});
  Request request = test::requestFor({0.6, 1.5, 0.0}, {2.8, 1.5, 0.0});
  TrueTrack true_track{truth, test::nao()};
  OwnTrack own_track;
  int ticks = 0;

  ReplayTest() {
    const auto source = [](const Request& asked, const std::shared_ptr<const World>& world) {
      return Planner(world, test::nao()).findPlan(asked, Planner::Clock::now() + std::chrono::seconds(2));
    };
    Mission mission(map, test::nao(), request, source);
    sim::SimulatedRobot body(truth, test::nao(), request.start, 0, 1);
    while (mission.outcome() == Mission::Outcome::kUnderway && body.now_s() < 600.0) {
      HeardSenses heard{static_cast<std::uint64_t>(++ticks), body.sense(), *body.sense().scan, {}};
      const Tick tick = mission.tick(heard.senses());
      body.step(tick.command);
      own_track.add(mission, tick.state, heard);
      true_track.add(heard.tick, body);
    }
  }
  [[nodiscard]] Replay replay() const {
    return {"nao in </script>", "It arrived.", *map, *truth, *test::nao(), request, true_track, own_track};
  }
};

TEST_F(ReplayTest, holdsTheWorldThePlansAndEveryTick) {
  const Json data = Json::parse(replayData(replay()));
  std::map<std::string, Json> things;
  for (const Json& thing : data["obstacles"]) things[thing["id"]] = thing;
  EXPECT_EQ(things["table"]["kind"], "over");
  EXPECT_EQ(things["step"]["kind"], "low");
  EXPECT_EQ(things["box"]["kind"], "tall");
  EXPECT_EQ(things["box"]["unmapped"], true);
  EXPECT_EQ(things["table"]["unmapped"], false);
  EXPECT_EQ(things["box"]["outline"].size(), 4U);
  EXPECT_GE(data["plans"].size(), 2U);  // the box is in the way
  EXPECT_GT(data["surprises"].size(), 0U);
  EXPECT_EQ(data["looks"].size(), static_cast<std::size_t>(ticks));
  for (const char* column : {"tick", "x", "y", "yaw", "mode", "clearance", "speed"})
    EXPECT_EQ(data["truth"][column].size(), static_cast<std::size_t>(ticks)) << column;
  for (const char* column : {"tick", "x", "y", "yaw", "state", "segment", "plans"})
    EXPECT_EQ(data["belief"][column].size(), static_cast<std::size_t>(ticks)) << column;
}

TEST_F(ReplayTest, columnsAddUpToWhatHappened) {
  const Json data = Json::parse(replayData(replay()));
  std::int64_t x = 0;
  std::int64_t clearance = 0;
  for (std::size_t i = 0; i < true_track.ticks().size(); ++i) {
    x += data["truth"]["x"][i].get<std::int64_t>();
    clearance += data["truth"]["clearance"][i].get<std::int64_t>();
    ASSERT_EQ(x, std::llround(1000.0 * true_track.ticks()[i].pose.x)) << i;
    ASSERT_EQ(clearance, std::llround(1000.0 * true_track.ticks()[i].clearance_m)) << i;
  }
}

TEST_F(ReplayTest, thePageIsOneFileThatNamesCannotBreak) {
  const std::string page = replayPage(replay());
  const std::string begin = "<script type=\"application/json\" id=\"run\">";
  const std::size_t from = page.find(begin) + begin.size();
  const std::size_t to = page.find("</script>", from);
  EXPECT_EQ(Json::parse(page.substr(from, to - from)), Json::parse(replayData(replay())));
  EXPECT_NE(page.find("<title>nao in &lt;/script&gt;</title>"), std::string::npos);
  EXPECT_EQ(page.find("http://"), std::string::npos);
  EXPECT_EQ(page.find("https://"), std::string::npos);
  EXPECT_LT(page.size(), 2'000'000U);
}

}  // namespace
}  // namespace underway
