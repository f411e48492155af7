#include <gtest/gtest.h>

#include "tests/geometry/read/sample_images.hpp"
#include "tests/geometry/read/scratch.hpp"

namespace underway {
namespace {

using Samples = std::vector<std::uint16_t>;
using namespace std::string_literals;

constexpr int kGrey = 0, kRgb = 2, kPalette = 3, kGreyAlpha = 4, kRgba = 6;

void expectSamples(const std::string& bytes, std::uint32_t channels, std::uint32_t max,
                   const Samples& samples) {
  const auto dut = decodeWhole(bytes);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->format.channels, channels);
  EXPECT_EQ(dut->format.max, max);
  EXPECT_EQ(dut->samples, samples);
}

TEST(Png, GreyKeepsItsValuesAtEveryDepth) {
  expectSamples(pngOf({3, 2, 8, kGrey}, {"\x00\x01\xcd"s, "\xfe\xff\x80"s}), 1, 255,
                {0, 1, 205, 254, 255, 128});
  expectSamples(pngOf({2, 1, 16, kGrey}, {"\x12\x34\xff\xfe"s}), 1, 65535, {0x1234, 0xfffe});
  expectSamples(pngOf({3, 1, 1, kGrey}, {"\xa0"s}), 1, 255, {255, 0, 255});
  expectSamples(pngOf({4, 1, 2, kGrey}, {"\x1b"s}), 1, 255, {0, 85, 170, 255});
  expectSamples(pngOf({2, 1, 4, kGrey}, {"\x3f"s}), 1, 255, {51, 255});
}

TEST(Png, ColoursComeAsThreeChannels) {
  expectSamples(pngOf({2, 1, 8, kRgb}, {"\x01\x02\x03\xff\xfe\xfd"s}), 3, 255, {1, 2, 3, 255, 254, 253});
  expectSamples(pngOf({1, 1, 16, kRgb}, {"\x01\x02\x03\x04\x05\x06"s}), 3, 65535, {0x102, 0x304, 0x506});
}

TEST(Png, AlphaIsTheFourthChannelAlsoOfAGrey) {
  expectSamples(pngOf({1, 1, 8, kRgba}, {"\x01\x02\x03\x04"s}), 4, 255, {1, 2, 3, 4});
  expectSamples(pngOf({1, 1, 16, kRgba}, {"\x01\x02\x03\x04\x05\x06\x07\x08"s}), 4, 65535,
                {0x102, 0x304, 0x506, 0x708});
  expectSamples(pngOf({2, 1, 8, kGreyAlpha}, {"\x0a\xff\x14\x00"s}), 4, 255,
                {10, 10, 10, 255, 20, 20, 20, 0});
  expectSamples(pngOf({1, 1, 16, kGreyAlpha}, {"\x01\x02\x03\x04"s}), 4, 65535, {0x102, 0x102, 0x102, 0x304});
}

TEST(Png, APaletteIsItsColoursNotItsIndices) {
  const std::string palette = pngChunk("PLTE", "\x00\x00\x00\xff\xff\xff\x0a\x14\x1e"s);
  expectSamples(pngOf({3, 1, 8, kPalette}, {"\x01\x02\x00"s}, palette), 3, 255,
                {255, 255, 255, 10, 20, 30, 0, 0, 0});
  expectSamples(pngOf({4, 1, 2, kPalette}, {"\x18"s}, palette), 3, 255,
                {0, 0, 0, 255, 255, 255, 10, 20, 30, 0, 0, 0});
  expectSamples(pngOf({2, 1, 8, kPalette}, {"\x01\x02"s}, palette + pngChunk("tRNS", "\xff\x80"s)), 4, 255,
                {255, 255, 255, 128, 10, 20, 30, 255});
}

TEST(Png, ATransparentGreyBecomesAnAlpha) {
  expectSamples(pngOf({2, 1, 8, kGrey}, {"\x05\x06"s}, pngChunk("tRNS", "\x00\x05"s)), 4, 255,
                {5, 5, 5, 0, 6, 6, 6, 255});
}

TEST(Png, AGammaChangesNoValue) {
  const std::string gamma = pngChunk("gAMA", bigEndian(22000));
  expectSamples(pngOf({3, 1, 8, kGrey}, {"\x40\x80\xcd"s}, gamma), 1, 255, {64, 128, 205});
  expectSamples(pngOf({1, 1, 16, kGrey}, {"\x40\x01"s}, gamma), 1, 65535, {0x4001});
}

TEST(Png, AnInterlacedImageIsTheSameImage) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {3u, 2u}, {8u, 8u}, {13u, 11u}}) {
    std::string pixels;
    for (std::uint32_t i = 0; i < width * height; ++i) pixels += static_cast<char>(i * 7 + 3);
    Samples expected;
    for (const char c : pixels) expected.push_back(static_cast<unsigned char>(c));
    expectSamples(pngOf({width, height, 8, kGrey, true}, interlacedLines(width, height, pixels)), 1, 255,
                  expected);
  }
}

TEST(Png, AFileCutShortAnywhereIsRefused) {
  const std::string whole = pngOf({3, 2, 8, kGrey}, {"abc", "def"});
  ASSERT_TRUE(decodeWhole(whole));
  for (std::size_t size = 8; size < whole.size(); ++size)
    EXPECT_TRUE(refusedNaming(decodeWhole(whole.substr(0, size)), {"sample", "damaged PNG"})) << size;
}

TEST(Png, AWrongChecksumIsRefused) {
  std::string bytes = pngOf({3, 2, 8, kGrey}, {"abc", "def"});
  bytes[bytes.find("abc")] = 'x';
  EXPECT_TRUE(refusedNaming(decodeWhole(bytes), {"sample", "damaged PNG"}));
}

TEST(Png, ASmallFileCannotClaimALargeImage) {
  EXPECT_TRUE(refusedNaming(decodeWhole(pngOf({20000, 20000, 8, kGrey}, {std::string(1000, 'x')})),
                            {"sample", "20000 x 20000", "at most"}));
  EXPECT_TRUE(refusedNaming(decodeWhole(pngOf({9000, 9000, 16, kRgba}, {std::string(1000, 'x')})),
                            {"sample", "9000 x 9000", "cut short"}));
  EXPECT_TRUE(refusedNaming(decodeWhole(pngOf({2147483647, 1, 8, kGrey}, {"x"})), {"sample", "at most"}));
}

TEST(Png, AnInterlacedImageTooLargeToHoldWholeIsRefused) {
  // Large enough for the packed size to be plausible: the pixels themselves are never looked at.
  EXPECT_TRUE(refusedNaming(decodeWhole(pngOf({9000, 9000, 16, kRgba, true}, {std::string(700'000, 'x')})),
                            {"sample", "interlac"}));
}

}  // namespace
}  // namespace underway
