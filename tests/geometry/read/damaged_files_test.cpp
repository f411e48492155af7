// Files with random damage: each is read or refused with a sentence; never a crash, a hang or a huge
// allocation. Run it with the sanitizers too.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <random>

#include "geometry/map.hpp"
#include "tests/geometry/read/sample_images.hpp"
#include "tests/geometry/read/scratch.hpp"

namespace underway {
namespace {

/// A copy with a few bytes changed, removed, doubled or exchanged for ones that mean something.
std::string damaged(std::string bytes, std::mt19937& random) {
  static const std::string kTelling = "[]{}:,-&*#?!|>'\"%@`\n\t 0123456789.eE+~\xff\x80PN";
  const unsigned changes = 1 + random() % 4;
  for (unsigned change = 0; change < changes && !bytes.empty(); ++change) {
    const std::size_t at = random() % bytes.size();
    switch (random() % 5) {
      case 0:
        bytes[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        bytes[at] = kTelling[random() % kTelling.size()];
        break;
      case 2:
        bytes.erase(at, 1 + random() % 8);
        break;
      case 3:
        bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 16));
        break;
      default:
        bytes.resize(at);
        break;
    }
  }
  return bytes;
}

constexpr int kRounds = 4000;

template <class Read>
void survivesDamage(const std::string& whole, Read read) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  ASSERT_TRUE(read(whole)) << "the undamaged file must be good";
  int refused = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto result = read(damaged(whole, random));
    if (result) continue;
    ++refused;
    ASSERT_FALSE(result.error().message.empty());
    ASSERT_EQ(result.error().message.find('\n'), std::string::npos) << result.error().message;
  }
  EXPECT_GT(refused, kRounds / 10) << "the damage should be felt";
}

/// The IHDR and PLTE checksums are made good again, so that damage gets past them.
std::string withGoodChecksums(const std::string& bytes) {
  std::string mended = bytes.substr(0, std::min<std::size_t>(8, bytes.size()));
  std::size_t at = mended.size();
  while (at + 12 <= bytes.size()) {
    std::uint32_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) size = size << 8 | static_cast<unsigned char>(bytes[at + i]);
    if (size > bytes.size() - at - 12) break;
    mended += pngChunk(bytes.substr(at + 4, 4), bytes.substr(at + 8, size));
    at += 12 + std::size_t{size};
  }
  return mended + bytes.substr(at);
}

TEST(DamagedFiles, PgmImagesAreReadOrRefused) {
  survivesDamage(pgmOf(4, 3, "abcdefghijkl"), decodeWhole);
  survivesDamage("P2\n# text\n3 2 100\n1 2 3\n40 50 100\n", decodeWhole);
}

TEST(DamagedFiles, PngImagesAreReadOrRefused) {
  const auto read = [](const std::string& bytes) { return decodeWhole(withGoodChecksums(bytes)); };
  const std::string palette = pngChunk("PLTE", "abcdefghi") + pngChunk("tRNS", "xy");
  survivesDamage(pngOf({4, 2, 2, 3}, {"\x18", "\x21"}, palette), read);
  survivesDamage(pngOf({2, 2, 16, 6}, {std::string(16, 'a'), std::string(16, 'b')}), read);
  survivesDamage(pngOf({5, 3, 8, 0, true}, interlacedLines(5, 3, "abcdefghijklmno")), read);
  survivesDamage(pngOf({4, 2, 8, 0}, {"abcd", "efgh"}), decodeWhole);
}

TEST(DamagedFiles, ScenariosAreReadOrRefused) {
  const Scratch scratch;
  survivesDamage(
      "name: room\nbounds_m: {min: [0, 0], max: [6, 4]}\nobstacles:\n  - {id: a, center_m: [2, 1, 0.5], "
      "size_m: [1, 2, 1], rpy_rad: [0, 0, 1]}\nqueries:\n  - name: q\n    start: [1, 1, 0]\n    goal: [2, "
      "2]\n    expect: ok\n",
      [&](const std::string& text) { return readMap(scratch.write("s.yaml", text)); });
}

TEST(DamagedFiles, MapServerMapsAreReadOrRefused) {
  const Scratch scratch;
  scratch.write("m.pgm", pgmOf(2, 2, "abcd"));
  survivesDamage(
      "image: m.pgm\nresolution: 0.05\norigin: [1, 2, 0.5]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: "
      "0.196\nmode: scale\n",
      [&](const std::string& text) { return readMap(scratch.write("m.yaml", text)); });
}

TEST(DamagedFiles, RobotsAreReadOrRefused) {
  const Scratch scratch;
  survivesDamage(
      "name: a\nmargin_m: 0.02\nmodes:\n  walk: {body_m: {x: [0, 1], y: [0, 1], z: [0, 1]}, speed_mps: "
      "{forward: 1}, "
      "turn_speed_radps: 1}\n  crawl: {body_m: {x: [0, 1], y: [0, 1], z: [0, 1]}, speed_mps: {left: 1}, "
      "turn_speed_radps: "
      "0}\nswitches:\n  - {from: walk, to: crawl, duration_s: 1, displacement: {x_m: 1}}\n",
      [&](const std::string& text) { return readRobot(scratch.write("r.yaml", text)); });
}

TEST(DamagedFiles, APipeIsRefusedNotWaitedFor) {
  const Scratch scratch;
  ASSERT_EQ(mkfifo(scratch.path("pipe").c_str(), 0600), 0);
  EXPECT_TRUE(refusedNaming(readMap(scratch.path("pipe")), {"pipe", "not a file"}));
  EXPECT_TRUE(refusedNaming(readMap("/dev/zero"), {"/dev/zero", "not a file"}));
}

TEST(DamagedFiles, AHugeYamlFileIsRefusedBySize) {
  const Scratch scratch;
  const auto file = scratch.write("r.yaml", "name: a\n");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // sparse: takes no room on the disk
  EXPECT_TRUE(refusedNaming(readRobot(file), {"r.yaml", "at most"}));
  EXPECT_TRUE(refusedNaming(readMap(file), {"r.yaml", "at most"}));
}

}  // namespace
}  // namespace underway
