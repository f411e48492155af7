#include <gtest/gtest.h>

#include "tests/geometry/read/sample_images.hpp"
#include "tests/geometry/read/scratch.hpp"

namespace underway {
namespace {

using Samples = std::vector<std::uint16_t>;
using namespace std::string_literals;

TEST(Pgm, BinaryPixelsComeRowByRowFromTheTop) {
  const auto dut = decodeWhole(pgmOf(3, 2, "\x00\x01\x02\xfd\xfe\xff"s));
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->format.width, 3u);
  EXPECT_EQ(dut->format.height, 2u);
  EXPECT_EQ(dut->format.max, 255u);
  EXPECT_EQ(dut->samples, (Samples{0, 1, 2, 253, 254, 255}));
}

TEST(Pgm, TextPixelsMayHaveCommentsAndAnyWhiteSpaceBetweenThem) {
  const auto dut = decodeWhole("P2 # kind\n# a line\n2\t2\r\n# largest\n15 0 7 # mid\n\n8\n15");
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->format.max, 15u);
  EXPECT_EQ(dut->samples, (Samples{0, 7, 8, 15}));
}

TEST(Pgm, WideSamplesHaveTheirHighByteFirst) {
  const auto dut = decodeWhole("P5 2 1 65535\n\x12\x34\xff\xfe"s);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->format.max, 65535u);
  EXPECT_EQ(dut->samples, (Samples{0x1234, 0xfffe}));
}

TEST(Pgm, ASampleThatLooksLikeWhiteSpaceOrACommentIsASample) {
  const auto dut = decodeWhole("P5 3 1 255\n\n# "s);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->samples, (Samples{'\n', '#', ' '}));
}

TEST(Pgm, AFileThatIsCutShortIsRefused) {
  EXPECT_TRUE(refusedNaming(decodeWhole(pgmOf(3, 2, "12345")), {"sample", "cut short", "3 x 2"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P2 3 1 9 1 2"), {"sample", "cut short"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P2 3 1 9 100000 1"), {"sample", "above the header's largest"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P2 3 1 99999 1 2 3"), {"sample", "65535"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 1 1 255"), {"sample", "cut short"}));
}

TEST(Pgm, AHeaderThatMakesNoSenseIsRefused) {
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 "), {"sample", "header"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 2 -3 255\n"), {"sample", "header"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 2 99999999999999999999 255\n"), {"sample", "header"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 0 3 255\n"), {"sample", "0 x 3"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 2 1 0\n12"), {"sample", "largest sample"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 2 1 65536\n1234"), {"sample", "65536"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 2 1 255x12"), {"sample", "white space"}));
}

TEST(Pgm, ASampleAboveTheLargestIsRefusedWithItsPlace) {
  EXPECT_TRUE(
      refusedNaming(decodeWhole("P5 2 2 100\n\x01\x02\x03\x65"s), {"sample", "pixel 1 of row 1", "101"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P2 2 1 7 3 8"), {"sample", "pixel 1 of row 0", "8"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P2 2 1 7 3 x"), {"sample", "pixel 1 of row 0", "not a number"}));
}

TEST(Pgm, ASmallFileCannotClaimALargeImage) {
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 20000 20000 255\n"s + std::string(1000, 'x')),
                            {"sample", "20000 x 20000", "at most"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 9000 9000 255\n"s + std::string(1000, 'x')),
                            {"sample", "9000 x 9000", "cut short"}));
  EXPECT_TRUE(refusedNaming(decodeWhole("P5 4294967295 4294967295 255\nx"), {"sample", "at most"}));
}

TEST(Image, FormatsThatAreNotReadAreNamedWithAWayOut) {
  const std::pair<std::string, std::string> kinds[] = {
      {"GIF89a..", "GIF"},          {"P6 1 1 255\nabc", "PPM"}, {"P4 1 1\na", "PBM"},
      {"\xff\xd8\xff\xe0", "JPEG"}, {"P7\nWIDTH 1", "PAM"},     {"BM\x7a\0\0\0\0\0\0\0\x36\0"s, "BMP"},
      {"II*\0"s, "TIFF"},           {"MM\0*"s, "TIFF"}};
  for (const auto& [bytes, name] : kinds) {
    EXPECT_TRUE(isImage(bytes)) << name;
    EXPECT_TRUE(refusedNaming(decodeWhole(bytes), {"sample", name, "convert"}));
  }
}

TEST(Image, TextIsNoImage) {
  for (const std::string& text : {"P5x: 1"s, "BMI: 3\nname: x"s, "image: map.pgm"s, ""s, "P"s}) {
    EXPECT_FALSE(isImage(text)) << text;
    EXPECT_TRUE(refusedNaming(decodeWhole(text), {"sample", "no image"}));
  }
}

}  // namespace
}  // namespace underway
