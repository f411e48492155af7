#include "planner/roadmap_file.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <optional>
#include <utility>

#include "geometry/fingerprint.hpp"
#include "planner/byte_reader.hpp"
#include "planner/byte_writer.hpp"
#include "planner/roadmap_flaw.hpp"

namespace underway {
namespace {

constexpr std::string_view kMagic = "underway roadmap";
/// Rises with the form, and with every change of what a batch draws or how places are connected: growth goes
/// on from a file only as it would have without.
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kPlaceBytes = 21;
constexpr std::size_t kLinkBytes = 16;
constexpr std::size_t kLeastCrossingBytes = 61;  // one motion
constexpr std::uint32_t kMostBatches = 10'000'000;
/// What grows has three. What so many cost fits its fields (cost.hpp).
constexpr std::uint8_t kMostMotions = 8;

std::uint64_t checksumOf(std::string_view bytes) { return Fingerprint().add(bytes).value(); }

ByteWriter& write(ByteWriter& to, const Pose& pose) { return to.f64(pose.x).f64(pose.y).f64(pose.yaw); }

void write(ByteWriter& to, const Crossing& crossing) {
  write(to.u8(static_cast<std::uint8_t>(crossing.motions.size())), crossing.entry());
  for (const Motion& motion : crossing.motions) {
    to.u8(static_cast<std::uint8_t>(motion.kind)).u8(motion.mode).u8(motion.to_mode);
    write(to.u8(static_cast<std::uint8_t>(motion.sense)), motion.to).f64(motion.angle_rad);
  }
}

std::string bodyOf(const Roadmap& roadmap, const RoadmapKey& key) {
  ByteWriter to;
  to.text(key.world).text(key.robot).u64(key.seed).f64(key.sites_per_m2).u32(roadmap.batches);
  to.u32(static_cast<std::uint32_t>(roadmap.places.size()));
  to.u32(static_cast<std::uint32_t>(roadmap.links.size()));
  to.u32(static_cast<std::uint32_t>(roadmap.crossings.size()));
  for (const Roadmap::Place& place : roadmap.places)
    to.f64(place.at.x).f64(place.at.y).u8(place.group).u32(place.end_link - place.first_link);
  for (Roadmap::LinkId id = 0; id < roadmap.links.size(); ++id) {
    const Roadmap::Link& link = roadmap.links[id];
    to.u32(link.to).u32(link.twin).u32(link.crossing).u32(roadmap.ways[id]);
  }
  for (const Crossing& crossing : roadmap.crossings) write(to, crossing);
  return to.take();
}

using Flaw = std::optional<std::string>;

/// Reads what follows the key.
class Payload {
 public:
  Payload(ByteReader from, const Stances& stances, const Robot& robot)
      : from_(from), stances_(stances), robot_(robot) {}

  Flaw readInto(Roadmap& roadmap) {
    roadmap.batches = from_.u32();
    const std::uint32_t places = from_.u32();
    const std::uint32_t links = from_.u32();
    const std::uint32_t crossings = from_.u32();
    if (roadmap.batches > kMostBatches) return fmt::format("it holds {} batches", roadmap.batches);
    if (Flaw flaw = readPlaces(roadmap, places, links)) return flaw;
    if (Flaw flaw = readLinks(roadmap, links)) return flaw;
    if (Flaw flaw = readCrossings(roadmap, crossings)) return flaw;
    if (!from_.isAtEnd()) return "it is longer or shorter than it says";
    return flawIn(roadmap, stances_, robot_);
  }

 private:
  Flaw readPlaces(Roadmap& roadmap, std::uint32_t count, std::uint32_t links) {
    if (!from_.holds(count, kPlaceBytes)) return fmt::format("it ends before its {} places do", count);
    roadmap.places.reserve(count);
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      Roadmap::Place place;
      place.at.x = from_.f64();
      place.at.y = from_.f64();
      place.group = from_.u8();
      place.keep_m = robot_.margin_m;
      const std::uint32_t leaving = from_.u32();
      if (leaving > links - next) return fmt::format("place {} has links that are not there", i);
      place.first_link = std::exchange(next, next + leaving);
      place.end_link = next;
      roadmap.places.push_back(place);
    }
    if (next != links) return "there are links of no place";
    return std::nullopt;
  }

  Flaw readLinks(Roadmap& roadmap, std::uint32_t count) {
    if (!from_.holds(count, kLinkBytes)) return fmt::format("it ends before its {} links do", count);
    roadmap.links.reserve(count);
    roadmap.ways.reserve(count);
    for (Roadmap::PlaceId from = 0; from < roadmap.places.size(); ++from) {
      while (roadmap.links.size() < roadmap.places[from].end_link) {
        const auto link = linkFrom(roadmap, from);
        if (!link) return fmt::format("link {} leads nowhere", roadmap.links.size());
        roadmap.links.push_back(*link);
        roadmap.ways.push_back(from_.u32());
      }
    }
    return std::nullopt;
  }

  std::optional<Roadmap::Link> linkFrom(const Roadmap& roadmap, Roadmap::PlaceId from) {
    Roadmap::Link link;
    link.from = from;
    link.to = from_.u32();
    link.twin = from_.u32();
    link.crossing = from_.u32();
    link.tried = 1;
    if (link.to >= roadmap.places.size()) return std::nullopt;
    if (link.crossing != Roadmap::kNone) return link;
    const Roadmap::Place& here = roadmap.places[from];
    const Point there = roadmap.places[link.to].at;
    if (here.group >= stances_.all().size()) return std::nullopt;
    link.tried = (Roadmap::Ways{1} << stances_.ofGroup(here.group).ways().size()) - 1U;
    link.direction_rad = std::atan2(there.y - here.at.y, there.x - here.at.x);
    link.length_m = distance(here.at, there);
    return link;
  }

  Flaw readCrossings(Roadmap& roadmap, std::uint32_t count) {
    if (!from_.holds(count, kLeastCrossingBytes))
      return fmt::format("it ends before its {} crossings do", count);
    roadmap.crossings.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      std::optional<Route> route = readRoute();
      if (!route) return fmt::format("crossing {} is none that this robot can make", i);
      roadmap.crossings.emplace_back(robot_, *std::move(route));
    }
    return std::nullopt;
  }

  /// Chained and legal, or empty: a crossing's costs are worked out only for what the robot can do.
  std::optional<Route> readRoute() {
    const std::uint8_t count = from_.u8();
    if (count == 0 || count > kMostMotions) return std::nullopt;
    Route route;
    Pose here = pose();
    for (std::uint8_t i = 0; i < count; ++i) {
      const Motion motion = motionFrom(here);
      if (!isLegal(robot_, motion) || (!route.empty() && route.back().to_mode != motion.mode))
        return std::nullopt;
      route.push_back(motion);
      here = motion.to;
    }
    return route;
  }

  Motion motionFrom(const Pose& here) {
    Motion motion;
    motion.kind = static_cast<MotionKind>(from_.u8());
    motion.mode = from_.u8();
    motion.to_mode = from_.u8();
    motion.sense = static_cast<Sense>(from_.u8());
    motion.from = here;
    motion.to = pose();
    motion.angle_rad = from_.f64();
    return motion;
  }

  Pose pose() {
    const double x = from_.f64();
    const double y = from_.f64();
    return {x, y, from_.f64()};
  }

  ByteReader from_;
  const Stances& stances_;
  const Robot& robot_;
};

tl::unexpected<Error> refused(std::string sentence) {
  return fail(ErrorCode::kInvalidRequest, std::move(sentence));
}

/// Else a sentence that names it could bring anything onto a terminal.
bool isHash(std::string_view text) {
  return text.size() == RoadmapKey::kHashDigits &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

RoadmapKey keyFrom(ByteReader& from) {
  RoadmapKey key;
  key.world = from.text(RoadmapKey::kHashDigits);
  key.robot = from.text(RoadmapKey::kHashDigits);
  key.seed = from.u64();
  key.sites_per_m2 = from.f64();
  return key;
}

}  // namespace

std::string toBytes(const Roadmap& roadmap, const RoadmapKey& key) {
  const std::string body = bodyOf(roadmap, key);
  ByteWriter to;
  to.text(kMagic).u32(kVersion).u64(checksumOf(body)).text(body);
  return to.take();
}

bool isRoadmapFile(std::string_view bytes) { return bytes.substr(0, kMagic.size()) == kMagic; }

Expected<RoadmapFile> fromBytes(std::string_view bytes, const RoadmapKey& here, const Stances& stances,
                                const Robot& robot) {
  if (!isRoadmapFile(bytes))
    return refused("this is no roadmap file: give one that was saved, or a new name");
  ByteReader from(bytes.substr(kMagic.size()));
  const std::uint32_t version = from.u32();
  if (from.hasFailed()) return refused("the roadmap file is cut short: let it be grown anew");
  if (version != kVersion)
    return refused(
        fmt::format("the roadmap file is of version {}, and this program reads version {}: let it be "
                    "grown anew",
                    version, kVersion));
  const std::uint64_t checksum = from.u64();
  if (checksum != checksumOf(from.rest()))
    return refused("the roadmap file is damaged or cut short, its checksum is wrong: let it be grown anew");
  RoadmapFile file{keyFrom(from), {}};
  if (!isHash(file.key.world) || !isHash(file.key.robot))
    return refused("the roadmap file contradicts itself, its hashes are none: let it be grown anew");
  if (auto why = mismatch(file.key, here)) return refused(*std::move(why));
  if (auto flaw = Payload(from, stances, robot).readInto(file.roadmap))
    return refused(fmt::format("the roadmap file contradicts itself, {}: let it be grown anew", *flaw));
  return file;
}

}  // namespace underway
