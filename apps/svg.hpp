#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/pose.hpp"

namespace underway {

/// From the map frame [m] to a picture whose y axis points down [px].
struct View {
  Point top_left;  ///< of what is shown, in the map frame [m]
  double px_per_m = 1.0;
  Point offset_px;  ///< where `top_left` comes to lie
  [[nodiscard]] Point toPicture(Point p_world) const {
    return {offset_px.x + (p_world.x - top_left.x) * px_per_m,
            offset_px.y + (top_left.y - p_world.y) * px_per_m};
  }
};

/// A number as SVG reads it, to 0.01, without trailing zeros.
[[nodiscard]] std::string svgNumber(double number);

/// Text inside an element or attribute: escaped, control characters and bytes that are no UTF-8 replaced.
[[nodiscard]] std::string svgText(std::string_view text);

/// The `d` of a <path>: many shapes in one element keep files small.
class PathData {
 public:
  explicit PathData(const View& view) : view_(view) {}

  /// A closed polygon, in the map frame. Always drawn in the same sense, so that overlapping ones unite.
  PathData& polygon(std::span<const Point> p_world);
  PathData& line(Point from_world, Point to_world);
  [[nodiscard]] bool empty() const { return data_.empty(); }
  [[nodiscard]] const std::string& text() const { return data_; }
  /// The whole element, or nothing when the path is empty. `attributes` as SVG has them.
  [[nodiscard]] std::string element(std::string_view attributes) const;

 private:
  View view_;
  std::string data_;
};

/// A <text> element.
[[nodiscard]] std::string svgLabel(Point at_px, std::string_view text, std::string_view attributes);

}  // namespace underway
