#include "geometry/read/walls.hpp"

#include <algorithm>
#include <bit>

namespace underway {
namespace {

/// The cells still to be covered, a bit each, line by line: lines are rows or, turned, columns.
class Uncovered {
 public:
  Uncovered(const Grid& grid, Unknown unknown, bool is_turned)
      : lines_(is_turned ? grid.width : grid.height),
        length_(is_turned ? grid.height : grid.width),
        words_(length_ / kBits + 1),  // a word more than needed at most: looks never end beyond a line
        is_turned_(is_turned),
        bits_(std::size_t{lines_} * words_, 0) {
    const bool unknown_blocks = unknown == Unknown::kOccupied;
    const auto is_open = [&](Cell cell) {
      return cell == Cell::kOccupied || (cell == Cell::kUnknown && unknown_blocks);
    };
    // Square by square, so that what is read and what is written both stay in the cache.
    for (std::uint32_t first = 0; first < lines_; first += kBits)
      for (std::uint32_t begin = 0; begin < length_; begin += kBits)
        for (std::uint32_t line = first; line < std::min(first + kBits, lines_); ++line) {
          std::uint64_t bits = 0;
          for (std::uint32_t place = begin; place < std::min(begin + kBits, length_); ++place)
            bits |= std::uint64_t{is_open(is_turned ? grid.at(line, place) : grid.at(place, line))}
                    << (place - begin);
          word(line, begin) = bits;
        }
  }

  [[nodiscard]] std::uint32_t lines() const { return lines_; }
  [[nodiscard]] std::uint32_t lineLength() const { return length_; }

  /// The first place of a line, from one on, that is open or not; the line's length if there is none.
  [[nodiscard]] std::uint32_t find(bool open, std::uint32_t line, std::uint32_t from) const {
    const std::uint64_t flip = open ? 0 : ~std::uint64_t{0};
    std::uint64_t wanted = (word(line, from) ^ flip) & (~std::uint64_t{0} << (from % kBits));
    for (std::uint32_t place = from / kBits * kBits;; wanted = word(line, place) ^ flip) {
      if (wanted != 0) return std::min(place + static_cast<std::uint32_t>(std::countr_zero(wanted)), length_);
      place += kBits;
      if (place >= length_) return length_;
    }
  }
  [[nodiscard]] bool isWhole(std::uint32_t line, std::uint32_t begin, std::uint32_t end) const {
    bool whole = true;
    forEachWord(begin, end, [&](std::uint32_t place, std::uint64_t mask) {
      whole = whole && (word(line, place) & mask) == mask;
      return whole;
    });
    return whole;
  }

  /// The block of lines [first, last) and places [begin, end), covered from now on.
  CellBlock cover(std::uint32_t first, std::uint32_t last, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t line = first; line < last; ++line)
      forEachWord(begin, end, [&](std::uint32_t place, std::uint64_t mask) {
        word(line, place) &= ~mask;
        return true;
      });
    if (is_turned_) return {first, begin, last - first, end - begin};
    return {begin, first, end - begin, last - first};
  }

 private:
  static constexpr std::uint32_t kBits = 64;

  [[nodiscard]] std::uint64_t& word(std::uint32_t line, std::uint32_t place) {
    return bits_[std::size_t{line} * words_ + place / kBits];
  }
  [[nodiscard]] const std::uint64_t& word(std::uint32_t line, std::uint32_t place) const {
    return bits_[std::size_t{line} * words_ + place / kBits];
  }

  /// Calls `visit(place, mask)` for each word of places [begin, end), with the mask of those in it, while it
  /// returns true.
  template <class Visit>
  static void forEachWord(std::uint32_t begin, std::uint32_t end, const Visit& visit) {
    for (std::uint32_t place = begin; place < end; place = (place / kBits + 1) * kBits) {
      std::uint64_t mask = ~std::uint64_t{0} << (place % kBits);
      if (end / kBits == place / kBits) mask &= (std::uint64_t{1} << (end % kBits)) - 1;
      if (!visit(place, mask)) return;
    }
  }

  std::uint32_t lines_;
  std::uint32_t length_;
  std::uint32_t words_;  // of a line
  bool is_turned_;
  std::vector<std::uint64_t> bits_;
};

/// Each block starts at the first uncovered cell, is as long as its line allows and then as many lines thick
/// as have that whole run. Linear: a look that fails costs at most the block's own length.
std::optional<std::vector<CellBlock>> greedyBlocks(Uncovered cells, std::size_t most) {
  std::vector<CellBlock> blocks;
  for (std::uint32_t line = 0; line < cells.lines(); ++line) {
    std::uint32_t begin = 0;
    while ((begin = cells.find(true, line, begin)) < cells.lineLength()) {
      if (blocks.size() == most) return std::nullopt;
      const std::uint32_t end = cells.find(false, line, begin);
      std::uint32_t last = line + 1;
      while (last < cells.lines() && cells.isWhole(last, begin, end)) ++last;
      blocks.push_back(cells.cover(line, last, begin, end));
    }
  }
  return blocks;
}

}  // namespace

std::optional<std::vector<CellBlock>> blocksOf(const Grid& grid, Unknown unknown, std::size_t most) {
  auto along_rows = greedyBlocks(Uncovered(grid, unknown, false), most);
  auto along_columns = greedyBlocks(Uncovered(grid, unknown, true), along_rows ? along_rows->size() : most);
  if (along_columns && (!along_rows || along_columns->size() < along_rows->size())) return along_columns;
  return along_rows;
}

Obstacle wallOf(const Grid& grid, const CellBlock& block, double floor_z_m, double height_m) {
  const double cell = grid.resolution_m;
  const Point middle = transform(grid.origin, {(2.0 * block.column + block.columns) * cell / 2.0,
                                               (2.0 * block.row + block.rows) * cell / 2.0});
  return {"wall_" + std::to_string(block.column) + "_" + std::to_string(block.row),
          {.center_m = {middle.x, middle.y, floor_z_m + height_m / 2.0},
           .size_m = {block.columns * cell, block.rows * cell, height_m},
           .rpy_rad = {0.0, 0.0, grid.origin.yaw}}};
}

Expected<std::vector<Obstacle>> wallsOf(const Grid& grid, Unknown unknown, double floor_z_m, double height_m,
                                        const std::filesystem::path& file) {
  const auto blocks = blocksOf(grid, unknown, kMostWalls);
  if (!blocks)
    return fail(ErrorCode::kInvalidMap, file.string() + ": its occupied cells make more than " +
                                            std::to_string(kMostWalls) +
                                            " separate walls; crop the map or clean it of noise");
  std::vector<Obstacle> walls;
  walls.reserve(blocks->size());
  for (const CellBlock& block : *blocks) walls.push_back(wallOf(grid, block, floor_z_m, height_m));
  return walls;
}

Bounds boundsOf(const Grid& grid) {
  return {grid.origin, grid.width * grid.resolution_m, grid.height * grid.resolution_m};
}

}  // namespace underway
