#include "geometry/read/walls.hpp"

#include <algorithm>

namespace underway {
namespace {

/// The cells still to be covered, seen along the rows or, turned, along the columns.
class Uncovered {
 public:
  Uncovered(const Grid& grid, Unknown unknown, bool is_turned)
      : width_(grid.width), height_(grid.height), is_turned_(is_turned), open_(grid.cells.size()) {
    const bool unknown_blocks = unknown == Unknown::kOccupied;
    std::transform(grid.cells.begin(), grid.cells.end(), open_.begin(), [&](Cell cell) {
      return cell == Cell::kOccupied || (cell == Cell::kUnknown && unknown_blocks);
    });
  }

  [[nodiscard]] std::uint32_t lines() const { return is_turned_ ? width_ : height_; }
  [[nodiscard]] std::uint32_t lineLength() const { return is_turned_ ? height_ : width_; }
  [[nodiscard]] bool at(std::uint32_t line, std::uint32_t place) const {
    return open_[index(line, place)] != 0;
  }
  [[nodiscard]] bool isWhole(std::uint32_t line, std::uint32_t begin, std::uint32_t end) const {
    for (std::uint32_t place = begin; place < end; ++place)
      if (!at(line, place)) return false;
    return true;
  }

  /// The block of lines [first, last) and places [begin, end), covered from now on.
  CellBlock cover(std::uint32_t first, std::uint32_t last, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t line = first; line < last; ++line)
      for (std::uint32_t place = begin; place < end; ++place) open_[index(line, place)] = 0;
    if (is_turned_) return {first, begin, last - first, end - begin};
    return {begin, first, end - begin, last - first};
  }

 private:
  [[nodiscard]] std::size_t index(std::uint32_t line, std::uint32_t place) const {
    return is_turned_ ? std::size_t{place} * width_ + line : std::size_t{line} * width_ + place;
  }
  std::uint32_t width_;
  std::uint32_t height_;
  bool is_turned_;
  std::vector<char> open_;
};

/// Each block starts at the first uncovered cell, is as long as its line allows and then as many lines thick
/// as have that whole run. Linear: a look that fails costs at most the block's own length.
std::optional<std::vector<CellBlock>> greedyBlocks(Uncovered cells, std::size_t most) {
  std::vector<CellBlock> blocks;
  for (std::uint32_t line = 0; line < cells.lines(); ++line) {
    for (std::uint32_t begin = 0; begin < cells.lineLength(); ++begin) {
      if (!cells.at(line, begin)) continue;
      if (blocks.size() == most) return std::nullopt;
      std::uint32_t end = begin + 1;
      while (end < cells.lineLength() && cells.at(line, end)) ++end;
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
  return {"cells_c" + std::to_string(block.column) + "_r" + std::to_string(block.row),
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
