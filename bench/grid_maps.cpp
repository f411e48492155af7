#include "bench/grid_maps.hpp"

#include <algorithm>
#include <fstream>
#include <random>

#include "bench/random_geometry.hpp"

namespace underway::bench {
namespace {

namespace fs = std::filesystem;

void fill(Grid& grid, std::uint32_t left, std::uint32_t low, std::uint32_t width, std::uint32_t height,
          Cell cell) {
  for (std::uint32_t row = low; row < std::min(low + height, grid.height); ++row)
    for (std::uint32_t column = left; column < std::min(left + width, grid.width); ++column)
      grid.cells[std::size_t{row} * grid.width + column] = cell;
}

/// Offices of 4 x 5 m with doors and desks, and the ragged edges that a laser makes of them; nothing is known
/// of every third.
Grid drawnOffice() {
  constexpr std::uint32_t kRoom = 80;
  constexpr std::uint32_t kDepth = 100;
  Grid grid{1200, 900, 0.05, {}, {}};
  grid.cells.assign(std::size_t{grid.width} * grid.height, Cell::kFree);
  RandomGeometry random(7);
  for (std::uint32_t low = 0; low < grid.height; low += kDepth) {
    for (std::uint32_t left = 0; left < grid.width; left += kRoom) {
      if (random.oneOf(3) == 0) fill(grid, left, low, kRoom, kDepth, Cell::kUnknown);
      fill(grid, left, low, kRoom, 2, Cell::kOccupied);
      fill(grid, left, low, 2, kDepth, Cell::kOccupied);
      fill(grid, left + 20 + static_cast<std::uint32_t>(random.oneOf(30)), low, 18, 2, Cell::kFree);
      for (int i = 0; i < 120; ++i)
        fill(grid, left + static_cast<std::uint32_t>(random.oneOf(kRoom)),
             low + static_cast<std::uint32_t>(random.oneOf(6)),
             1 + static_cast<std::uint32_t>(random.oneOf(3)), 1, Cell::kOccupied);
      fill(grid, left + 30, low + 40, 28, 16, Cell::kOccupied);
    }
  }
  return grid;
}

void writePgm(const Grid& grid, std::uint32_t tiles, const fs::path& file) {
  std::ofstream out(file, std::ios::binary);
  out << "P5\n" << tiles * grid.width << ' ' << tiles * grid.height << "\n255\n";
  std::string line;
  for (std::uint32_t row = tiles * grid.height; row-- > 0;) {
    line.clear();
    for (std::uint32_t column = 0; column < grid.width; ++column) {
      const Cell cell = grid.at(column, row % grid.height);
      line += static_cast<char>(cell == Cell::kOccupied ? 0 : cell == Cell::kFree ? 254 : 205);
    }
    for (std::uint32_t tile = 0; tile < tiles; ++tile) out << line;
  }
}

/// A new folder for files that nobody wants to keep.
std::shared_ptr<const fs::path> scratchFolder() {
  const auto folder =
      fs::temp_directory_path() / ("underway_bench_" + std::to_string(std::random_device{}()));
  fs::create_directories(folder);
  return {new fs::path(folder), [](const fs::path* path) {
            std::error_code ignored;
            fs::remove_all(*path, ignored);
            delete path;
          }};
}

}  // namespace

Expected<GridMaps> GridMaps::make(const fs::path& file, std::optional<double> resolution_m) {
  if (file.empty()) return GridMaps("a drawn office 0.05 m", drawnOffice());
  MapOptions options;
  options.resolution_m = resolution_m;
  auto grid = readGrid(file, options);
  if (!grid) return tl::unexpected(grid.error());
  GridMaps maps(file.stem().string(), std::move(*grid));
  if (const auto map = readMap(maps.fourfold(), maps.options()); !map)
    return fail(map.error().code, file.string() + ", four times: " + map.error().message);
  return maps;
}

GridMaps::GridMaps(std::string name, Grid grid)
    : name_(std::move(name)),
      grid_(std::move(grid)),
      folder_(scratchFolder()),
      plain_(*folder_ / "plain.pgm"),
      fourfold_(*folder_ / "fourfold.pgm") {
  options_.resolution_m = grid_.resolution_m;
  writePgm(grid_, 1, plain_);
  writePgm(grid_, 2, fourfold_);
}

}  // namespace underway::bench
