#pragma once

#include <string>
#include <string_view>

#include "geometry/error.hpp"
#include "planner/roadmap.hpp"
#include "planner/roadmap_key.hpp"
#include "planner/stances.hpp"

namespace underway {

/// A grown roadmap as bytes, the same on every machine. Little-endian, doubles bit for bit:
///
///     "underway roadmap"  version u32  checksum u64: Fingerprint over all that follows
///     world hash, robot hash: 16 characters each  seed u64  sites per square metre f64
///     batches u32  places u32  links u32  crossings u32: how many
///     of each place: x f64  y f64  group u8  links that leave it u32
///     of each link: to u32  twin u32  crossing u32  free ways u32
///     of each crossing: motions u8  entry x f64  y f64  yaw f64
///         of each motion: kind u8  mode u8  to mode u8  sense u8  to x f64  y f64  yaw f64  angle f64
///
/// What follows from these is not kept. Precondition: the roadmap is from Growth, so that its places keep the
/// robot's margin and each link has tried all ways there are.
[[nodiscard]] std::string toBytes(const Roadmap& roadmap, const RoadmapKey& key);

/// What a file says; nobody has looked yet whether the world agrees.
struct RoadmapFile {
  RoadmapKey key;
  Roadmap roadmap;  ///< sound in form; to be arranged (arrange.hpp) before use
};

/// Whether bytes begin as a roadmap file does: others are somebody's, and not to be written over.
[[nodiscard]] bool isRoadmapFile(std::string_view bytes);

/// Reads a roadmap for a robot (`stances` and `robot` are of it) and a key, whatever the world. Trusts
/// nothing: any bytes at all may be given. Errors: kInvalidRequest with a sentence that says what does not
/// fit and what to do, for bytes that are no roadmap, of another version, damaged, cut short, that contradict
/// themselves, or made for another key (mismatch in roadmap_key.hpp).
[[nodiscard]] Expected<RoadmapFile> fromBytes(std::string_view bytes, const RoadmapKey& here,
                                              const Stances& stances, const Robot& robot);

}  // namespace underway
