#pragma once

#include <string>
#include <vector>

#include "geometry/pose.hpp"

namespace underway {

/// One line of a chart.
struct Series {
  std::string label;  ///< in the legend; lines without one are not in it
  std::string colour;
  bool is_dashed = false;
  std::vector<Point> points;  ///< in the chart's own units
};

/// Lines over axes with ticks.
struct Chart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;
  bool is_to_scale = false;  ///< one unit is as long along x as along y
};

/// Where a chart is drawn [px].
struct Frame {
  Point top_left;
  double width = 0.0;
  double height = 0.0;
};

/// As SVG elements. Points that are not finite are left out.
[[nodiscard]] std::string drawChart(const Chart& chart, const Frame& frame);

/// A whole SVG file of charts, side by side in rows of two.
[[nodiscard]] std::string drawCharts(const std::vector<Chart>& charts, const std::string& title);

}  // namespace underway
