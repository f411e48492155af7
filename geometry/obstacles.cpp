#include "geometry/obstacles.hpp"

#include <algorithm>
#include <bit>
#include <functional>

namespace underway {
namespace {

constexpr std::size_t kPerBucket = 32;  // a change copies a bucket and the list of buckets: about as much

std::uint64_t hashOf(std::string_view id) { return std::hash<std::string_view>{}(id); }

}  // namespace

Obstacles::Obstacles(std::vector<Obstacle> obstacles, std::optional<std::string>& twin)
    : size_(obstacles.size()), buckets_(std::bit_ceil(obstacles.size() / kPerBucket + 1)) {
  // One block for all; each pointer keeps the whole block alive.
  const auto block = std::make_shared<const std::vector<Obstacle>>(std::move(obstacles));
  std::vector<Bucket> buckets(buckets_.size());
  for (std::size_t i = 0; i < size_; i += kChunk) {
    Chunk chunk;
    for (std::size_t k = i; k < std::min(i + kChunk, size_); ++k) chunk.emplace_back(block, &(*block)[k]);
    chunks_.push_back(std::make_shared<const Chunk>(std::move(chunk)));
  }
  for (std::size_t i = 0; i < size_; ++i) {
    const std::string& id = (*block)[i].id;
    const std::uint64_t hash = hashOf(id);
    Bucket& bucket = buckets[hash & (buckets.size() - 1)];
    const bool is_known = std::any_of(bucket.begin(), bucket.end(), [&](const Entry& entry) {
      return entry.hash == hash && (*block)[entry.at].id == id;
    });
    if (is_known && !twin) twin = id;
    bucket.push_back({hash, i});
  }
  for (std::size_t i = 0; i < buckets.size(); ++i)
    buckets_[i] = std::make_shared<const Bucket>(std::move(buckets[i]));
}

std::optional<std::size_t> Obstacles::find(std::string_view id) const {
  if (empty()) return std::nullopt;
  const std::uint64_t hash = hashOf(id);
  for (const Entry& entry : *buckets_[hash & (buckets_.size() - 1)])
    if (entry.hash == hash && (*this)[entry.at].id == id) return entry.at;
  return std::nullopt;
}

Obstacles Obstacles::with(Obstacle obstacle) const {
  if (size_ >= 4 * kPerBucket * std::max<std::size_t>(buckets_.size(), 1) || buckets_.empty()) {
    // More buckets are due: make the table anew.
    std::vector<Obstacle> all(begin(), end());
    all.push_back(std::move(obstacle));
    std::optional<std::string> no_twin;
    return {std::move(all), no_twin};
  }
  Obstacles result = *this;
  result.indexAt(obstacle.id, size_);
  result.put(result.size_++, std::make_shared<const Obstacle>(std::move(obstacle)));
  return result;
}

Obstacles Obstacles::withBox(std::size_t i, const OrientedBox& box) const {
  Obstacles result = *this;
  result.put(i, std::make_shared<const Obstacle>(Obstacle{(*this)[i].id, box}));
  return result;
}

Obstacles Obstacles::without(std::size_t i) const {
  Obstacles result = *this;
  const std::size_t last = size_ - 1;
  result.forget((*this)[i].id, i);
  if (i != last) {
    result.forget((*this)[last].id, last);
    result.indexAt((*this)[last].id, i);
    result.put(i, pointer(last));
  }
  Chunk shorter = *result.chunks_.back();
  shorter.pop_back();
  if (shorter.empty())
    result.chunks_.pop_back();
  else
    result.chunks_.back() = std::make_shared<const Chunk>(std::move(shorter));
  --result.size_;
  return result;
}

std::vector<Obstacles::Change> Obstacles::changes(const Obstacles& before, const Obstacles& after) {
  static const Pointer kNone;
  const auto at = [](const Obstacles& all, std::size_t i) -> const Pointer& {
    return i < all.size_ ? all.pointer(i) : kNone;
  };
  std::vector<Change> changes;
  for (std::size_t c = 0; c < std::max(before.chunks_.size(), after.chunks_.size()); ++c) {
    const bool both = c < before.chunks_.size() && c < after.chunks_.size();
    if (both && before.chunks_[c] == after.chunks_[c]) continue;
    for (std::size_t i = c * kChunk; i < (c + 1) * kChunk; ++i)
      if (at(before, i) != at(after, i)) changes.push_back({at(before, i), at(after, i)});
  }
  return changes;
}

std::shared_ptr<const Obstacles::Bucket>& Obstacles::bucketOf(std::uint64_t hash) {
  return buckets_[hash & (buckets_.size() - 1)];
}

void Obstacles::put(std::size_t i, Pointer obstacle) {
  if (i / kChunk == chunks_.size()) chunks_.push_back(std::make_shared<const Chunk>());
  std::shared_ptr<const Chunk>& chunk = chunks_[i / kChunk];
  Chunk changed = *chunk;
  changed.resize(std::max(changed.size(), i % kChunk + 1));
  changed[i % kChunk] = std::move(obstacle);
  chunk = std::make_shared<const Chunk>(std::move(changed));
}

void Obstacles::indexAt(std::string_view id, std::size_t at) {
  const std::uint64_t hash = hashOf(id);
  Bucket changed = *bucketOf(hash);
  changed.push_back({hash, at});
  bucketOf(hash) = std::make_shared<const Bucket>(std::move(changed));
}

void Obstacles::forget(std::string_view id, std::size_t at) {
  const std::uint64_t hash = hashOf(id);
  Bucket changed = *bucketOf(hash);
  std::erase_if(changed, [at](const Entry& entry) { return entry.at == at; });
  bucketOf(hash) = std::make_shared<const Bucket>(std::move(changed));
}

}  // namespace underway
