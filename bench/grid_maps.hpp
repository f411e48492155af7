#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "geometry/grid.hpp"

namespace underway::bench {

/// A large grid map, and one of four times its area, as image files that go when this goes.
class GridMaps {
 public:
  /// From a map file, or of an office that is drawn here if none is given. Errors: as of readGrid and
  /// readMap.
  [[nodiscard]] static Expected<GridMaps> make(const std::filesystem::path& file,
                                               std::optional<double> resolution_m);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::size_t cells() const { return grid_.cells.size(); }
  [[nodiscard]] const std::filesystem::path& plain() const { return plain_; }
  [[nodiscard]] const std::filesystem::path& fourfold() const { return fourfold_; }
  /// With which to read them.
  [[nodiscard]] const MapOptions& options() const { return options_; }

 private:
  GridMaps(std::string name, Grid grid);
  std::string name_;
  Grid grid_;
  MapOptions options_;
  std::shared_ptr<const std::filesystem::path> folder_;  // removed with the last copy
  std::filesystem::path plain_;
  std::filesystem::path fourfold_;
};

}  // namespace underway::bench
