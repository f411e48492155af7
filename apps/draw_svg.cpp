#include "apps/draw_svg.hpp"

#include <algorithm>
#include <cmath>

#include "apps/draw_layers.hpp"
#include "apps/svg.hpp"
#include "apps/table.hpp"

namespace underway {
namespace {

constexpr double kMargin_px = 24.0;
constexpr double kLegend_px = 270.0;
constexpr double kLargestMap_px = 1000.0;
constexpr double kLeastHeight_px = 330.0;  // the legend's
constexpr double kScaleBar_px = 44.0;      // room below the map

struct Area {
  Range x;
  Range y;
};

/// The bounds seen from above, upright in the picture however they are turned.
Area areaOf(const Bounds& bounds) {
  const std::array<Point, 4> corners = bounds.corners();
  Area area{{corners[0].x, corners[0].x}, {corners[0].y, corners[0].y}};
  for (const Point corner : corners)
    area = {hull(area.x, {corner.x, corner.x}), hull(area.y, {corner.y, corner.y})};
  return area;
}

/// The area and a point outside of it, unless that lies so far out that the map would become small.
Area including(const Area& area, Point point) {
  const double reach = 0.25 * std::max(area.x.length(), area.y.length());
  const Area grown{area.x.grown(reach), area.y.grown(reach)};
  const bool is_near =
      point.x >= grown.x.min && point.x <= grown.x.max && point.y >= grown.y.min && point.y <= grown.y.max;
  return is_near ? Area{hull(area.x, {point.x, point.x}), hull(area.y, {point.y, point.y})} : area;
}

/// 1, 2 or 5 times a power of ten: the largest such length that is no longer than `most_m`.
double roundLength(double most_m) {
  const double power = std::pow(10.0, std::floor(std::log10(most_m)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most_m) return factor * power;
  return power;
}

std::string drawScaleBar(Point at_px, double px_per_m) {
  constexpr double kLongest_px = 180.0;
  const double bar_m = roundLength(kLongest_px / px_per_m);
  const double end_px = at_px.x + bar_m * px_per_m;
  const std::string y = svgNumber(at_px.y);
  const std::string text = bar_m >= 1.0 ? fixed(bar_m, 0) + " m" : svgNumber(100.0 * bar_m) + " cm";
  return "<path fill=\"none\" stroke=\"#46515e\" stroke-width=\"1.5\" d=\"M" + svgNumber(at_px.x) + " " +
         svgNumber(at_px.y - 5.0) + "V" + y + "H" + svgNumber(end_px) + "v-5\"/>\n" +
         svgLabel({end_px + 8.0, at_px.y}, text, "font-size=\"12\" fill=\"#46515e\"");
}

std::string page(double width_px, double height_px, const std::string& content) {
  const std::string size = svgNumber(width_px) + " " + svgNumber(height_px);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\" width=\"" +
         svgNumber(width_px) + "\" height=\"" + svgNumber(height_px) +
         "\" font-family=\"Helvetica, Arial, sans-serif\">\n" +
         "<defs><pattern id=\"low\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\" "
         "patternTransform=\"rotate(45)\"><rect width=\"8\" height=\"8\" fill=\"#f4e9d3\"/>"
         "<rect width=\"2\" height=\"8\" fill=\"#d9c190\"/></pattern></defs>\n" +
         "<rect width=\"100%\" height=\"100%\" fill=\"#f5f7f9\"/>\n" + content + "</svg>\n";
}

}  // namespace

std::string drawSvg(const Picture& picture) {
  Area area = areaOf(picture.world.bounds());
  if (picture.document != nullptr) {
    area = including(area, picture.document->request.start.position());
    for (const Goal& goal : goalsOf(picture.document->request)) area = including(area, goal.at);
  }
  const double px_per_m = kLargestMap_px / std::max(area.x.length(), 1.3 * area.y.length());
  const View view{{area.x.min, area.y.max}, px_per_m, {kMargin_px, kMargin_px}};
  const double map_width_px = area.x.length() * px_per_m;
  const double map_height_px = area.y.length() * px_per_m;
  const double width_px = map_width_px + kLegend_px + 3.0 * kMargin_px;
  const double height_px = std::max(map_height_px + kScaleBar_px, kLeastHeight_px) + kMargin_px;
  const Point legend_px{map_width_px + 2.0 * kMargin_px, kMargin_px + 16.0};
  return page(width_px, height_px,
              drawFloor(picture, view) + drawObstacles(picture, view) + drawRoadmap(picture, view) +
                  drawPlan(picture, view) +
                  drawScaleBar({kMargin_px, kMargin_px + map_height_px + 28.0}, px_per_m) +
                  drawLegend(picture, legend_px, kLegend_px));
}

}  // namespace underway
