#include "apps/svg.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace underway {
namespace {

double cross(Point o, Point a, Point b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }

double signedArea(std::span<const Point> polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += cross(polygon[0], polygon[i], polygon[(i + 1) % polygon.size()]);
  return area;
}

/// The text with bytes that are no UTF-8 replaced. The JSON library knows how.
std::string validUtf8(std::string_view text) {
  using Json = nlohmann::json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

}  // namespace

std::string svgNumber(double number) {
  std::array<char, 400> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.2f", number);
  std::string text = buffer.data();
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string svgText(std::string_view text) {
  std::string escaped;
  for (const char c : validUtf8(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

PathData& PathData::polygon(std::span<const Point> p_world) {
  if (p_world.size() < 3) return *this;
  std::vector<Point> points(p_world.begin(), p_world.end());
  if (signedArea(points) < 0.0) std::reverse(points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point at = view_.toPicture(points[i]);
    data_ += i == 0 ? 'M' : i == 1 ? 'L' : ' ';
    data_ += svgNumber(at.x) + ' ' + svgNumber(at.y);
  }
  data_ += 'z';
  return *this;
}

PathData& PathData::line(Point from_world, Point to_world) {
  const Point from = view_.toPicture(from_world);
  const Point to = view_.toPicture(to_world);
  data_ += 'M';
  data_ += svgNumber(from.x) + ' ' + svgNumber(from.y);
  data_ += 'L';
  data_ += svgNumber(to.x) + ' ' + svgNumber(to.y);
  return *this;
}

std::string PathData::element(std::string_view attributes) const {
  if (empty()) return {};
  return "<path " + std::string(attributes) + " d=\"" + data_ + "\"/>\n";
}

std::string svgLabel(Point at_px, std::string_view text, std::string_view attributes) {
  return "<text x=\"" + svgNumber(at_px.x) + "\" y=\"" + svgNumber(at_px.y) + "\" " +
         std::string(attributes) + ">" + svgText(text) + "</text>\n";
}

}  // namespace underway
