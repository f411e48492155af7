#include "apps/draw_svg.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace underway {
namespace {

Robot makeRobot() {
  Robot robot;
  robot.name = "nao";
  for (const char* mode : {"frontal", "lateral", "crawl"}) {
    Mode& added = robot.modes.emplace_back();
    added.name = mode;
    added.body_m = {{-0.13, 0.13}, {-0.195, 0.195}, {0.0, added.name == "crawl" ? 0.21 : 0.585}};
  }
  robot.switches.push_back({0, 2, 8.0, {0.3, 0.0, 0.0}, {{-0.13, 0.66}, {-0.195, 0.195}, {0.0, 0.585}}});
  return robot;
}

World makeWorld(std::vector<Obstacle> obstacles) {
  return World::make("room <1> & \"2\"", {{0.0, 0.0, 0.0}, 6.0, 4.0}, 0.0, std::move(obstacles)).value();
}

Obstacle box(const std::string& id, double x, double z) { return {id, {{x, 2.0, z}, {0.4, 0.4, 0.2}, {}}}; }

PlanDocument makeDocument(const Robot& robot) {
  PlanDocument document{{}, "nao", {"frontal", "lateral", "crawl"}, "room", 1, "w", "r", 1, Plan{}};
  document.request.start = {0.6, 2.0, 0.0};
  const Motion walk = translate(0, Sense::kForward, document.request.start, 2.0);
  const Motion about = turn(0, walk.to, 7.0, 7.0);
  const Motion down = switchModes(robot.switches[0], about.to);
  document.answer->segments = {{walk, 20.0, {}}, {about, 9.0, {}}, {down, 8.0, {}}};
  document.answer->goal = down.to;
  document.request.goal = down.to.position();
  return document;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Every element is closed, attributes are quoted, and no number went wrong.
void expectWellFormed(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    ASSERT_NE(end, std::string::npos);
    const std::string tag = svg.substr(at + 1, end - at - 1);
    ASSERT_EQ(count(tag, "\"") % 2, 0U) << tag;
    if (tag.back() == '/') continue;
    const std::string name = tag.substr(0, tag.find(' '));
    if (name[0] != '/') {
      open.push_back(name);
    } else {
      ASSERT_FALSE(open.empty());
      ASSERT_EQ("/" + open.back(), name);
      open.pop_back();
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(DrawSvg, AMapAloneIsDrawn) {
  const Robot robot = makeRobot();
  const World world = makeWorld({box("wall", 2.0, 0.1)});
  expectWellFormed(drawSvg({world, robot}));
}

TEST(DrawSvg, NamesFromFilesAreEscaped) {
  const Robot robot = makeRobot();
  const World world = makeWorld({});
  const std::string svg = drawSvg({world, robot});
  expectWellFormed(svg);
  EXPECT_NE(svg.find("room &lt;1&gt; &amp; &quot;2&quot;"), std::string::npos);
}

TEST(DrawSvg, ObstaclesAreToldApartByTheModesTheyBlock) {
  const Robot robot = makeRobot();
  const World world = makeWorld({box("wall", 2.0, 0.1), box("table", 3.0, 0.4), box("lamp", 4.0, 1.5)});
  const std::string svg = drawSvg({world, robot});
  for (const char* label : {"blocks every mode", "free for crawl only", "blocks no mode"})
    EXPECT_EQ(count(svg, label), 1U) << label;
}

TEST(DrawSvg, APlanIsDrawnInTheColoursOfItsModesWithStartGoalAndTotals) {
  const Robot robot = makeRobot();
  const World world = makeWorld({});
  const PlanDocument document = makeDocument(robot);
  const std::string svg = drawSvg({world, robot, nullptr, &document});
  expectWellFormed(svg);
  for (const char* part :
       {"#0072b2", "#d55e00", ">S</text>", ">G</text>", ">frontal</text>", ">switching</text>"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
}

TEST(DrawSvg, AFailureShowsItsSentenceAndWhatIsInTheWay) {
  const Robot robot = makeRobot();
  const World world = makeWorld({box("table", 3.0, 0.25)});
  PlanDocument document = makeDocument(robot);
  document.answer = tl::unexpected(
      Error{ErrorCode::kNoPathExists, "the table is too low", {{"table", "crawl", "height", 0.21, 0.15}}});
  const std::string svg = drawSvg({world, robot, nullptr, &document});
  expectWellFormed(svg);
  EXPECT_NE(svg.find("no plan: no_path_exists"), std::string::npos);
  EXPECT_NE(svg.find("the table is too low"), std::string::npos);
  EXPECT_NE(svg.find("in the way"), std::string::npos);
}

TEST(DrawSvg, AGoalFarOutsideDoesNotShrinkTheMap) {
  const Robot robot = makeRobot();
  const World world = makeWorld({});
  PlanDocument document = makeDocument(robot);
  document.request.goal = {9e4, 9e4};
  document.answer = fail(ErrorCode::kGoalOutOfBounds, "the goal is outside");
  EXPECT_EQ(drawSvg({world, robot, nullptr, &document}).substr(0, 200),
            drawSvg({world, robot}).substr(0, 200));
}

TEST(DrawSvg, ManyObstaclesOfAKindAreOnePathOfFewBytesEach) {
  const Robot robot = makeRobot();
  std::vector<Obstacle> cells;
  for (int i = 0; i < 20'000; ++i)
    cells.push_back({std::to_string(i), {{0.02 * (i % 200), 0.03 * (i / 200), 1.0}, {0.02, 0.02, 2.0}, {}}});
  const World world = makeWorld(std::move(cells));
  const std::string svg = drawSvg({world, robot});
  EXPECT_LT(count(svg, "<path"), 10U);
  EXPECT_LT(svg.size(), 20'000U * 60U);
}

TEST(DrawSvg, ALargeRoadmapIsThinnedOut) {
  const Robot robot = makeRobot();
  const World world = makeWorld({});
  Roadmap roadmap;
  for (std::uint32_t i = 0; i < 50'000; ++i) {
    roadmap.places.push_back({.at = {0.0001 * i, 1.0}});
    roadmap.links.push_back({.from = i, .to = (i + 1) % 50'000});
    roadmap.ways.push_back(1);
  }
  roadmap.count();
  const std::string svg = drawSvg({world, robot, &roadmap});
  EXPECT_LT(svg.size(), 200'000U);
  EXPECT_NE(svg.find("50000 nodes, 50000 edges"), std::string::npos);
}

}  // namespace
}  // namespace underway
