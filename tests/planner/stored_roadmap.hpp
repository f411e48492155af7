#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include "geometry/fingerprint.hpp"
#include "planner/grow.hpp"
#include "planner/roadmap_file.hpp"
#include "planner/stances.hpp"
#include "tests/planner/fixture.hpp"

namespace underway::test {

/// A room with a table to crawl under and a narrow gap, small enough to spoil each byte of its roadmap.
inline std::shared_ptr<const World> smallRoom(double table_x = 2.0) {
  std::vector<Obstacle> obstacles{{"table_top", {{table_x, 1.0, 0.5}, {0.5, 2.0, 0.1}, {}}},
                                  {"pillar", {{0.7, 1.6, 0.5}, {0.1, 0.1, 1.0}, {}}}};
  return std::make_shared<const World>(
      *World::make("small_room", {{0.0, 0.0, 0.0}, 4.0, 2.0}, 0.0, std::move(obstacles)));
}

inline std::string grownBytes(const std::shared_ptr<const Checker>& checker, unsigned batches) {
  Growth growth(checker, {});
  for (unsigned i = 0; i < batches; ++i) growth.addBatch();
  return toBytes(growth.freeze(), keyOf(*checker, {}));
}

// Where things are in a file (roadmap_file.hpp).
inline constexpr std::size_t kVersionAt = 16;
inline constexpr std::size_t kChecksumAt = 20;
inline constexpr std::size_t kBodyAt = 28;
inline constexpr std::size_t kSeedAt = 60;
inline constexpr std::size_t kCountsAt = 76;
inline constexpr std::size_t kPlacesAt = 92;

/// The bytes with a checksum that is right: what is wrong with them is for others to find.
inline std::string sealed(std::string bytes) {
  if (bytes.size() < kBodyAt) return bytes;
  const std::uint64_t checksum = Fingerprint().add(std::string_view(bytes).substr(kBodyAt)).value();
  for (std::size_t i = 0; i < 8; ++i) bytes[kChecksumAt + i] = static_cast<char>(checksum >> (8 * i));
  return bytes;
}

/// Whether each way of a link, and each crossing, is told as the checker tells it, looked at one by one.
inline void expectTrue(const Roadmap& roadmap, const Checker& checker) {
  const Stances stances(checker, Policy::kFastest);
  for (Roadmap::LinkId id = 0; id < roadmap.links.size(); ++id) {
    const Roadmap::Link& link = roadmap.links[id];
    bool is_free = true;
    if (link.crossing != Roadmap::kNone) {
      for (const Motion& motion : roadmap.crossings.at(link.crossing).motions)
        is_free &= checker.isFree(motion) && std::isfinite(duration(checker.robot(), motion));
      ASSERT_EQ(roadmap.ways[id], is_free ? 1U : 0U);
      continue;
    }
    const Point from = roadmap.places.at(link.from).at;
    const Legs& legs = stances.ofGroup(roadmap.places[link.from].group);
    for (std::size_t way = 0; way < 32; ++way) {
      if (way < legs.ways().size()) {
        const Pose pose{from.x, from.y, legs.stanceOn(link.direction_rad, way).yaw};
        is_free = checker.isFree(
            translate(legs.ways()[way].mode, legs.ways()[way].sense, pose, roadmap.places.at(link.to).at));
      } else {
        is_free = false;
      }
      ASSERT_EQ((roadmap.ways[id] >> way & 1U) != 0, is_free);
    }
  }
}

}  // namespace underway::test
