#pragma once

#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/box.hpp"

namespace underway {

/// Something solid, with an id that stays the same through changes of the world.
struct Obstacle {
  std::string id;
  OrientedBox box;
  bool operator==(const Obstacle&) const = default;
};

/// A world's obstacles: a table that never changes, and makes changed copies of itself that share with it all
/// that did not change. A change copies one pointer for about twenty obstacles: 2 us for 10,000.
///
/// Order is that of making; removing an obstacle puts the last one in its place.
///
/// Thread safety: const members may be called from any number of threads.
class Obstacles {
 public:
  using Pointer = std::shared_ptr<const Obstacle>;

  Obstacles() = default;
  /// Ids must be unique; the first that is not is written to `twin`, and the table is then of no use.
  Obstacles(std::vector<Obstacle> obstacles, std::optional<std::string>& twin);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const Pointer& pointer(std::size_t i) const { return (*chunks_[i / kChunk])[i % kChunk]; }
  [[nodiscard]] const Obstacle& operator[](std::size_t i) const { return *pointer(i); }
  /// Where an id is; empty if it is not here.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view id) const;

  /// With one more; its id must be new.
  [[nodiscard]] Obstacles with(Obstacle obstacle) const;
  /// With another box for the i-th.
  [[nodiscard]] Obstacles withBox(std::size_t i, const OrientedBox& box) const;
  /// Without the i-th.
  [[nodiscard]] Obstacles without(std::size_t i) const;

  /// An obstacle that differs between two tables; null where it is not there.
  struct Change {
    Pointer before;
    Pointer after;
  };
  /// What leads from one table to another. Quick where they share; an obstacle that only changed its place
  /// may be listed as gone and come.
  [[nodiscard]] static std::vector<Change> changes(const Obstacles& before, const Obstacles& after);

  class Iterator {
   public:
    // NOLINTBEGIN(readability-identifier-naming): the standard library's names
    using iterator_category = std::input_iterator_tag;
    using value_type = Obstacle;
    using difference_type = std::ptrdiff_t;
    using pointer = const Obstacle*;
    using reference = const Obstacle&;
    // NOLINTEND(readability-identifier-naming)
    Iterator(const Obstacles& all, std::size_t at) : all_(&all), at_(at) {}
    reference operator*() const { return (*all_)[at_]; }
    pointer operator->() const { return &(*all_)[at_]; }
    Iterator& operator++() { return ++at_, *this; }
    Iterator operator++(int) { return {*all_, at_++}; }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    const Obstacles* all_;
    std::size_t at_;
  };
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size_}; }

 private:
  static constexpr std::size_t kChunk = 64;
  using Chunk = std::vector<Pointer>;  // of kChunk; the last one may hold fewer
  struct Entry {
    std::uint64_t hash;
    std::size_t at;
  };
  using Bucket = std::vector<Entry>;

  [[nodiscard]] std::shared_ptr<const Bucket>& bucketOf(std::uint64_t hash);
  void put(std::size_t i, Pointer obstacle);
  void indexAt(std::string_view id, std::size_t at);
  void forget(std::string_view id, std::size_t at);

  std::size_t size_ = 0;
  std::vector<std::shared_ptr<const Chunk>> chunks_;
  std::vector<std::shared_ptr<const Bucket>> buckets_;  // by the id's hash; a power of two of them
};

}  // namespace underway
