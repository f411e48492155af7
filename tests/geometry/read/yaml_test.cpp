#include "geometry/read/yaml.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/read/scratch.hpp"

namespace underway {
namespace {

Expected<YamlFile> parse(const std::string& text) {
  return parseYaml("x.yaml", text, ErrorCode::kInvalidMap);
}

/// What is wrong when a file is read in some way.
template <class Read>
Expected<void> faultOf(const std::string& text, Read read) {
  auto file = parse(text);
  if (!file) return tl::unexpected(file.error());
  read(file->root());
  if (file->fault()) return tl::unexpected(*file->fault());
  return {};
}

Expected<void> faultOfNumber(const std::string& text) {
  return faultOf("a: 1\nb: " + text, [](const YamlValue& root) { (void)root.at("b").number(); });
}

TEST(Yaml, ValuesAreReadAsWhatTheyAre) {
  auto file = parse("n: -1.5e3\nplus: +.5\nt: hello\nyes: true\nl: [1, 2.5]\nm: {a: 1}\nempty:\n");
  ASSERT_TRUE(file) << file.error().message;
  const YamlValue dut = file->root();
  EXPECT_EQ(dut.at("n").number(), -1500.0);
  EXPECT_EQ(dut.at("plus").number(), 0.5);
  EXPECT_EQ(dut.at("t").text(), "hello");
  EXPECT_TRUE(dut.at("yes").flag());
  EXPECT_EQ(dut.at("l").numbers(1, 3), (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(dut.at("m").members().at(0).key(), "a");
  EXPECT_TRUE(dut.find("empty"));
  EXPECT_FALSE(file->fault());
}

TEST(Yaml, WhatIsNotThereReadsAsItsFallback) {
  auto file = parse("a: 1");
  const YamlValue dut = file->root();
  EXPECT_FALSE(dut.find("b"));
  EXPECT_EQ(dut.find("b").number(7.0), 7.0);
  EXPECT_EQ(dut.find("b").text("x"), "x");
  EXPECT_TRUE(dut.find("b").items().empty());
  EXPECT_FALSE(dut.find("b").find("c"));
  EXPECT_FALSE(file->fault());
}

TEST(Yaml, NumbersAreFiniteAndWhole) {
  EXPECT_TRUE(faultOfNumber("0.1"));
  for (const char* text : {".inf", "-.inf", "inf", ".nan", "NaN", "-Infinity"})
    EXPECT_TRUE(refusedNaming(faultOfNumber(text), {"x.yaml:2: b:", "finite", text}));
  for (const char* text : {"1.5m", "0x10", "1 2", "+-1", "+", "\"1\"", "~", "[1]", "{a: 1}", "1,5"})
    EXPECT_TRUE(refusedNaming(faultOfNumber(text), {"x.yaml:2: b:", "expected a number"})) << text;
  EXPECT_TRUE(refusedNaming(faultOfNumber("1e400"), {"x.yaml:2: b:", "beyond"}));
}

TEST(Yaml, TextIsNotEmptyAndOnOneLine) {
  const auto fault_of = [](const std::string& text) {
    return faultOf("t: " + text, [](const YamlValue& root) { (void)root.at("t").text(); });
  };
  EXPECT_TRUE(fault_of("12"));
  EXPECT_TRUE(refusedNaming(fault_of("\"\""), {"x.yaml:1: t:", "empty"}));
  EXPECT_TRUE(refusedNaming(fault_of("\"a\\nb\""), {"x.yaml:1: t:", "control characters", "a?b"}));
  EXPECT_TRUE(refusedNaming(fault_of("~"), {"x.yaml:1: t:", "expected text", "nothing"}));
  EXPECT_TRUE(refusedNaming(fault_of("[a]"), {"x.yaml:1: t:", "expected text", "a list of 1"}));
}

TEST(Yaml, OnlyTheFirstFaultIsTold) {
  const auto fault = faultOf("a: x\nb: y", [](const YamlValue& root) {
    (void)root.at("b").number();
    (void)root.at("a").number();
  });
  EXPECT_TRUE(refusedNaming(fault, {"x.yaml:2:", "\"y\""}));
}

TEST(Yaml, UnknownKeysAreRefusedWithTheNearestKnownOne) {
  const auto fault_of = [](const std::string& text) {
    return faultOf(text, [](const YamlValue& root) { root.allowOnly({"name", "obstacles"}); });
  };
  EXPECT_TRUE(fault_of("name: x"));
  EXPECT_TRUE(refusedNaming(fault_of("name: x\nobstacle: []"),
                            {"x.yaml:2:", "\"obstacle\"", "did you mean \"obstacles\"?"}));
  EXPECT_TRUE(refusedNaming(fault_of("colour: red"), {"x.yaml:1:", "\"colour\"", "name or obstacles"}));
  EXPECT_TRUE(refusedNaming(fault_of(std::string(500, 'k') + ": 1"), {"x.yaml:1:", "kkk..."}));
}

TEST(Yaml, ListsOfNumbersHaveTheirLength) {
  const auto fault_of = [](const std::string& text) {
    return faultOf("l: " + text,
                   [](const YamlValue& root) { EXPECT_GE(root.at("l").numbers(2, 3).size(), 2u); });
  };
  EXPECT_TRUE(fault_of("[1, 2]"));
  EXPECT_TRUE(fault_of("[1, 2, 3]"));
  EXPECT_TRUE(refusedNaming(fault_of("[1]"), {"x.yaml:1: l:", "2 to 3 numbers", "a list of 1"}));
  EXPECT_TRUE(refusedNaming(fault_of("[1, 2, 3, 4]"), {"x.yaml:1: l:", "a list of 4"}));
  EXPECT_TRUE(refusedNaming(fault_of("[1, two]"), {"x.yaml:1: l[1]:", "\"two\""}));
  EXPECT_TRUE(refusedNaming(fault_of("5"), {"x.yaml:1: l:", "a list of 2 to 3 numbers", "\"5\""}));
}

TEST(Yaml, AMissingKeyIsNamed) {
  const auto fault = faultOf("a: 1", [](const YamlValue& root) { (void)root.at("b").number(); });
  EXPECT_TRUE(refusedNaming(fault, {"x.yaml:1:", "\"b\"", "missing"}));
}

TEST(Yaml, KeysGivenTwiceAreRefusedWithBothLines) {
  EXPECT_TRUE(refusedNaming(parse("a: 1\nb: 2\n\na: 3\n"), {"x.yaml:4:", "\"a\"", "twice", "line 1"}));
  EXPECT_TRUE(refusedNaming(parse("m: {a: 1, a: 2}"), {"x.yaml:1:", "\"a\"", "twice"}));
}

TEST(Yaml, WhatIsNotOneSmallDocumentIsRefused) {
  EXPECT_TRUE(refusedNaming(parse(""), {"x.yaml:1:", "empty"}));
  EXPECT_TRUE(refusedNaming(parse("# only this\n"), {"x.yaml:1:", "empty"}));
  EXPECT_TRUE(refusedNaming(parse("a: 1\n---\nb: 2\n"), {"x.yaml:2:", "second document"}));
  EXPECT_TRUE(refusedNaming(parse("a: &x [1]\nb: *x\n"), {"x.yaml:1:", "anchors"}));
  EXPECT_TRUE(refusedNaming(parse("a: [1, 2\nb: {"), {"x.yaml:"}));
  EXPECT_TRUE(refusedNaming(parse("a:\n\t- 1"), {"x.yaml:2:"}));
  EXPECT_TRUE(refusedNaming(parse("[a]: 1"), {"x.yaml:1:", "key"}));
  EXPECT_TRUE(refusedNaming(parse(": 1"), {"x.yaml:1:", "key"}));
  EXPECT_TRUE(refusedNaming(parse(std::string("a: 1\0b", 6)), {"x.yaml:1:", "binary"}));
}

TEST(Yaml, DeepAndHugeFilesAreRefusedQuickly) {
  EXPECT_TRUE(refusedNaming(parse(std::string(1'000'000, '[')), {"x.yaml:1:"}));
  EXPECT_TRUE(refusedNaming(parse(std::string(kLargestYaml + 1, ' ')), {"x.yaml:1:", "at most"}));
  EXPECT_TRUE(refusedNaming(parse("a: " + std::string(100'000, '{')), {"x.yaml:1:"}));
  std::string nested;
  for (int depth = 0; depth < 1000; ++depth) nested += std::string(depth, ' ') + "a:\n";
  EXPECT_TRUE(refusedNaming(parse(nested), {"x.yaml:", "deep"}));
  std::string dashes;
  for (int depth = 0; depth < 10'000; ++depth) dashes += "- ";
  EXPECT_TRUE(refusedNaming(parse(dashes), {"x.yaml:1:", "deep"}));
}

TEST(Yaml, AListOrAScalarIsNoMapping) {
  for (const char* text : {"[1, 2]", "hello", "~"})
    EXPECT_TRUE(refusedNaming(faultOf(text, [](const YamlValue& root) { root.allowOnly({"a"}); }),
                              {"x.yaml:1:", "a mapping"}))
        << text;
}

}  // namespace
}  // namespace underway
