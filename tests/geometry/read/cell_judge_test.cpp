#include "geometry/read/cell_judge.hpp"

#include <gtest/gtest.h>

namespace underway {
namespace {

constexpr Cell kFree = Cell::kFree, kOccupied = Cell::kOccupied, kUnknown = Cell::kUnknown;

ImageFormat formatOf(std::uint32_t channels, std::uint32_t max = 255) { return {1, 1, channels, max}; }

Cell judge(const MapServerSettings& settings, std::vector<std::uint16_t> pixel, std::uint32_t max = 255) {
  return CellJudge(settings, formatOf(static_cast<std::uint32_t>(pixel.size()), max))(pixel);
}

TEST(CellJudge, DarkIsOccupiedLightIsFreeAndBetweenIsUnknown) {
  const MapServerSettings settings;
  EXPECT_EQ(judge(settings, {0}), kOccupied);
  EXPECT_EQ(judge(settings, {254}), kFree);
  EXPECT_EQ(judge(settings, {128}), kUnknown);
}

TEST(CellJudge, NegateTurnsThePixelNotTheThresholds) {
  MapServerSettings settings;
  settings.negate = true;
  EXPECT_EQ(judge(settings, {255}), kOccupied);
  EXPECT_EQ(judge(settings, {0}), kFree);
  EXPECT_EQ(judge(settings, {49}), kFree);     // 49/255 = 0.192
  EXPECT_EQ(judge(settings, {50}), kUnknown);  // 50/255 = 0.19608
}

TEST(CellJudge, TheUnknownGrey205IsUnknownAt0196AndFreeAt025) {
  MapServerSettings settings;
  EXPECT_EQ(judge(settings, {205}), kUnknown);
  EXPECT_EQ(judge(settings, {206}), kFree);
  settings.free_thresh = 0.25;
  EXPECT_EQ(judge(settings, {205}), kFree);
}

TEST(CellJudge, APixelOnAThresholdIsUnknown) {
  MapServerSettings settings;
  settings.occupied_thresh = 0.8;  // exactly (255 - 51) / 255
  settings.free_thresh = 0.2;      // exactly (255 - 204) / 255
  for (const std::uint16_t scale : {std::uint16_t{1}, std::uint16_t{257}}) {
    const std::uint32_t max = 255u * scale;
    const auto grey = [&](int v) {
      return std::vector<std::uint16_t>{static_cast<std::uint16_t>(v * scale)};
    };
    EXPECT_EQ(judge(settings, grey(51), max), kUnknown);
    EXPECT_EQ(judge(settings, grey(50), max), kOccupied);
    EXPECT_EQ(judge(settings, grey(204), max), kUnknown);
    EXPECT_EQ(judge(settings, grey(205), max), kFree);
  }
}

TEST(CellJudge, SixteenBitsAreToldApart) {
  MapServerSettings settings;
  settings.occupied_thresh = 0.5;
  settings.free_thresh = 0.5;
  EXPECT_EQ(judge(settings, {32767}, 65535), kOccupied);
  EXPECT_EQ(judge(settings, {32768}, 65535), kFree);
}

TEST(CellJudge, ChannelsAreAveraged) {
  const MapServerSettings settings;
  EXPECT_EQ(judge(settings, {0, 0, 255}), kOccupied);  // p = 0.667
  EXPECT_EQ(judge(settings, {0, 0, 0}), kOccupied);
  EXPECT_EQ(judge(settings, {0, 30, 255}), kUnknown);  // p = 0.627
}

TEST(CellJudge, TrinaryCountsAlphaAsAChannel) {
  const MapServerSettings settings;
  EXPECT_EQ(judge(settings, {0, 0, 0, 0}), kOccupied);
  EXPECT_EQ(judge(settings, {0, 0, 0, 255}), kOccupied);       // p = 0.75
  EXPECT_EQ(judge(settings, {100, 100, 100, 255}), kUnknown);  // p = 0.456, and 0.608 without alpha
  EXPECT_EQ(judge(settings, {255, 255, 255, 0}), kUnknown);    // p = 0.25
  EXPECT_EQ(judge(settings, {80, 80, 80, 255}), kUnknown);  // p = 0.515, and 0.686, occupied, without alpha
}

TEST(CellJudge, ScaleLeavesAlphaOutAndTakesAnyTransparencyForUnknown) {
  MapServerSettings settings;
  settings.mode = PixelMode::kScale;
  EXPECT_EQ(judge(settings, {80, 80, 80, 255}), kOccupied);  // p = 0.686
  EXPECT_EQ(judge(settings, {0, 0, 0, 254}), kUnknown);
  EXPECT_EQ(judge(settings, {255, 255, 255, 0}), kUnknown);
  EXPECT_EQ(judge(settings, {255, 255, 255, 255}), kFree);
  EXPECT_EQ(judge(settings, {128}), kUnknown);
}

TEST(CellJudge, RawPixelsAreOccupancyInPerCent) {
  MapServerSettings settings;
  settings.mode = PixelMode::kRaw;
  for (const bool negate : {false, true}) {
    settings.negate = negate;
    EXPECT_EQ(judge(settings, {0}), kFree);
    EXPECT_EQ(judge(settings, {19}), kFree);
    EXPECT_EQ(judge(settings, {20}), kUnknown);
    EXPECT_EQ(judge(settings, {65}), kUnknown);
    EXPECT_EQ(judge(settings, {66}), kOccupied);
    EXPECT_EQ(judge(settings, {100}), kOccupied);
    EXPECT_EQ(judge(settings, {101}), kUnknown);
    EXPECT_EQ(judge(settings, {255}), kUnknown);
    EXPECT_EQ(judge(settings, {100 * 257}, 65535), kOccupied);
    EXPECT_EQ(judge(settings, {0, 0, 0, 0}), kFree);
  }
}

}  // namespace
}  // namespace underway
