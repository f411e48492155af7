#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <random>

#include "tests/planner/stored_roadmap.hpp"

/// Bytes that no roadmap was saved as: refused, or a roadmap with no wrong way; never a crash.
namespace underway {
namespace {

using test::expectTrue;
using test::nao;
using test::sealed;
using test::smallRoom;

class SpoiltRoadmap : public ::testing::Test {
 protected:
  std::shared_ptr<const Checker> checker = std::make_shared<const Checker>(smallRoom(), nao());
  Stances stances{*checker, Policy::kFastest};
  RoadmapKey key = keyOf(*checker, {});
  std::string good = test::grownBytes(checker, 1);
  std::mt19937_64 random{20};
  unsigned accepted = 0;

  [[nodiscard]] Expected<LoadedRoadmap> loadedFrom(std::string_view bytes) const {
    return load(bytes, key, stances, *checker);
  }

  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
  }

  /// Loads it; what is accepted must be true, and fit to be grown on and planned on.
  void tryOn(std::string_view bytes) {
    const Expected<LoadedRoadmap> loaded = loadedFrom(bytes);
    if (!loaded) {
      ASSERT_FALSE(loaded.error().message.empty());
      return;
    }
    expectTrue(loaded->roadmap, *checker);
    if (++accepted % 16 != 1) return;
    Growth growth(checker, {});
    growth.takeOver(loaded->roadmap);
    growth.addBatch();
    expectTrue(growth.freeze(), *checker);
    Planner planner(smallRoom(), nao());
    ASSERT_TRUE(planner.load(bytes));
    (void)planner.findPlan(test::requestFor({0.6, 0.6, 0.0}, {3.4, 1.0, 0.0}),
                           Planner::Clock::now() + std::chrono::milliseconds(50));
  }

  [[nodiscard]] std::uint32_t countAt(std::size_t i) const { return numberAt(test::kCountsAt + 4 * i); }
  [[nodiscard]] std::uint32_t numberAt(std::size_t at) const {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
      number |= std::uint32_t{static_cast<unsigned char>(good[at + i])} << (8 * i);
    return number;
  }
};

void put(std::string& bytes, std::size_t at, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size && at + i < bytes.size(); ++i)
    bytes[at + i] = static_cast<char>(value >> (8 * i));
}

double doubleAt(const std::string& bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i)
    value |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return std::bit_cast<double>(value);
}

TEST_F(SpoiltRoadmap, IsNotSpoiltToBeginWith) {
  const auto loaded = loadedFrom(good);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_FALSE(loaded->roadmap.crossings.empty());
  expectTrue(loaded->roadmap, *checker);
  ASSERT_EQ(toBytes(loaded->roadmap, key), good);
}

TEST_F(SpoiltRoadmap, IsRefusedWhenCutShortAnywhere) {
  for (std::size_t size = 0; size < good.size(); ++size) {
    const std::string cut = good.substr(0, size);  // of its own, so that a sanitizer sees its end
    ASSERT_FALSE(loadedFrom(cut)) << size;
  }
}

TEST_F(SpoiltRoadmap, IsRefusedWhenCutShortAnywhereWithARightChecksum) {
  for (std::size_t size = 0; size < good.size(); ++size)
    ASSERT_FALSE(loadedFrom(sealed(good.substr(0, size)))) << size;
  ASSERT_FALSE(loadedFrom(sealed(good + '\0')));
}

TEST_F(SpoiltRoadmap, IsRefusedWhenAnyByteIsAnother) {
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::string bytes = good;
    bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U + below(255)));
    ASSERT_FALSE(loadedFrom(bytes)) << at;
  }
}

TEST_F(SpoiltRoadmap, MadeOfRandomBytesIsRefused) {
  for (int i = 0; i < 2000; ++i) {
    // With more and more of a right beginning.
    std::string bytes = good.substr(0, std::array<std::size_t, 4>{0, 16, 20, test::kCountsAt}[i % 4]);
    for (std::size_t more = below(400); more > 0; --more) bytes.push_back(static_cast<char>(below(256)));
    ASSERT_FALSE(loadedFrom(bytes));
    ASSERT_FALSE(loadedFrom(sealed(bytes)));
  }
}

TEST_F(SpoiltRoadmap, HasNoWrongWayWhenAnyByteIsAnotherAndTheChecksumIsRight) {
  for (std::size_t at = test::kBodyAt; at < good.size(); at += 1 + below(5)) {
    std::string bytes = good;
    bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << below(8)));
    tryOn(sealed(bytes));
    if (HasFatalFailure()) FAIL() << at;
  }
}

TEST_F(SpoiltRoadmap, HasNoWrongWayWhenItsNumbersAreOthers) {
  const std::size_t links_at = test::kPlacesAt + std::size_t{21} * countAt(1);
  const std::size_t crossings_at = links_at + std::size_t{16} * countAt(2);
  const std::array<std::uint64_t, 9> whole{0,          1,          2,          countAt(1), countAt(2),
                                           countAt(3), 0x7fffffff, 0xfffffffe, 0xffffffff};
  const std::array<double, 12> real{0.0, -0.0,  1.0,    -1.0, 3.2,      7.0,
                                    1e5, 1e300, 5e-324, NAN,  INFINITY, -INFINITY};
  const auto another = [&](double value) {
    switch (below(4)) {
      case 0:
        return real[below(real.size())];
      case 1:
        return std::nextafter(value, INFINITY);
      case 2:
        return value + 1e-3;
      default:
        return -value;
    }
  };
  const auto spoilReal = [&](std::string& bytes, std::size_t at) {
    put(bytes, at, std::bit_cast<std::uint64_t>(another(doubleAt(good, at))), 8);
  };
  const std::array<std::size_t, 9> in_crossing{0, 1, 9, 17, 25, 26, 27, 28, 29};
  for (int i = 0; i < 4000; ++i) {
    std::string bytes = good;
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
      const std::size_t place = test::kPlacesAt + 21 * below(countAt(1));
      const std::size_t link = links_at + 16 * below(countAt(2));
      const std::size_t other = links_at + 16 * below(countAt(2));
      // Every crossing of this robot has three motions.
      const std::size_t crossing = crossings_at + std::size_t{25 + 3 * 36} * below(countAt(3));
      const std::size_t motion = crossing + 25 + 36 * below(3);
      switch (below(10)) {
        case 0:
          put(bytes, test::kCountsAt + 4 * below(4), whole[below(whole.size())], 4);
          break;
        case 1:
          spoilReal(bytes, place + 8 * below(2));
          break;
        case 2:
          put(bytes, place + 16, below(4), 1);
          break;
        case 3:
          put(bytes, place + 17, whole[below(whole.size())], 4);
          break;
        case 4:
          put(bytes, link + 4 * below(4), whole[below(whole.size())], 4);
          break;
        case 5:
          put(bytes, link + 12, random(), 4);
          break;
        case 6:
          bytes.replace(link, 16, good, other, 16);
          break;
        case 7:
          put(bytes, motion + below(4), below(6), 1);
          break;
        case 8:
          spoilReal(bytes, motion + 4 + 8 * below(4));
          break;
        default:
          spoilReal(bytes, crossing + 1 + 8 * below(3));
          break;
      }
      if (below(8) == 0)
        bytes[test::kBodyAt] = bytes[test::kBodyAt] == '0' ? '1' : '0';  // said to be of another world
      if (below(40) == 0) put(bytes, crossing + in_crossing[below(in_crossing.size())], below(256), 1);
    }
    tryOn(sealed(bytes));
    if (HasFatalFailure()) FAIL() << i;
  }
  EXPECT_GT(accepted, 100U) << "that little got so far says that the rest was not put to the test";
}

}  // namespace
}  // namespace underway
