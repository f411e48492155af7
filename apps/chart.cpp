#include "apps/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "apps/svg.hpp"

namespace underway {
namespace {

constexpr const char* kText = "font-family=\"sans-serif\" font-size=\"12\" fill=\"#333\"";
constexpr const char* kTitle =
    "font-family=\"sans-serif\" font-size=\"14\" font-weight=\"bold\" fill=\"#111\"";
constexpr double kLeft_px = 58.0;
constexpr double kRight_px = 12.0;
constexpr double kTop_px = 28.0;
constexpr double kBottom_px = 42.0;
constexpr double kLegendRow_px = 16.0;

struct Extent {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
  void add(double value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
  [[nodiscard]] double width() const { return max - min; }
};

/// 1, 2 or 5 times a power of ten, so that about `count` steps fill a width.
double niceStep(double width, double count) {
  const double raw = width / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power) return factor * power;
  return 10.0 * power;
}

bool isDrawable(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

class Drawing {
 public:
  Drawing(const Chart& chart, const Frame& frame) : chart_(chart), frame_(frame) {
    for (const Series& series : chart.series)
      for (const Point p : series.points)
        if (isDrawable(p)) {
          x_.add(p.x);
          y_.add(p.y);
        }
    if (!(x_.width() >= 0.0)) x_ = y_ = {0.0, 1.0};
    widen(x_, 0.0);
    widen(y_, 0.06);
    area_ = {frame.top_left.x + kLeft_px, frame.top_left.y + kTop_px + legendHeight()};
    width_ = frame.width - kLeft_px - kRight_px;
    height_ = frame.top_left.y + frame.height - kBottom_px - area_.y;
    if (chart.is_to_scale) equalise();
  }

  [[nodiscard]] std::string text() const { return axes() + lines() + labels(); }

 private:
  static void widen(Extent& extent, double share) {
    const double by = extent.width() > 0.0 ? share * extent.width() : 0.5;
    extent.min -= by;
    extent.max += by;
  }

  void equalise() {
    const double px_per_unit = std::min(width_ / x_.width(), height_ / y_.width());
    const double spare_x = width_ / px_per_unit - x_.width();
    const double spare_y = height_ / px_per_unit - y_.width();
    x_ = {x_.min - 0.5 * spare_x, x_.max + 0.5 * spare_x};
    y_ = {y_.min, y_.max + spare_y};
  }

  [[nodiscard]] Point place(Point p) const {
    return {area_.x + (p.x - x_.min) / x_.width() * width_,
            area_.y + height_ - (p.y - y_.min) / y_.width() * height_};
  }

  static std::string line(Point from, Point to, const char* colour) {
    return "<line x1=\"" + svgNumber(from.x) + "\" y1=\"" + svgNumber(from.y) + "\" x2=\"" + svgNumber(to.x) +
           "\" y2=\"" + svgNumber(to.y) + "\" stroke=\"" + colour + "\"/>\n";
  }

  [[nodiscard]] std::string axes() const {
    std::string text;
    const double step_x = niceStep(x_.width(), 6.0);
    const double step_y = niceStep(y_.width(), 5.0);
    for (double x = std::ceil(x_.min / step_x) * step_x; x <= x_.max + 1e-9 * step_x; x += step_x) {
      const double at = place({x, 0.0}).x;
      text += line({at, area_.y}, {at, area_.y + height_}, "#e4e4e4");
      text += svgLabel({at, area_.y + height_ + 15.0}, tick(x, step_x),
                       std::string(kText) + " text-anchor=\"middle\"");
    }
    for (double y = std::ceil(y_.min / step_y) * step_y; y <= y_.max + 1e-9 * step_y; y += step_y) {
      const double at = place({0.0, y}).y;
      text += line({area_.x, at}, {area_.x + width_, at}, "#e4e4e4");
      text +=
          svgLabel({area_.x - 6.0, at + 4.0}, tick(y, step_y), std::string(kText) + " text-anchor=\"end\"");
    }
    text += line({area_.x, area_.y}, {area_.x, area_.y + height_}, "#888");
    return text + line({area_.x, area_.y + height_}, {area_.x + width_, area_.y + height_}, "#888");
  }

  static std::string tick(double value, double step) {
    return std::abs(value) < 1e-9 * step ? "0" : svgNumber(value);
  }

  [[nodiscard]] std::string lines() const {
    std::string text;
    for (const Series& series : chart_.series) {
      std::string data;
      for (const Point p : series.points) {
        if (!isDrawable(p)) continue;
        const Point at = place(p);
        data += data.empty() ? 'M' : 'L';
        data += svgNumber(at.x) + " " + svgNumber(at.y);
      }
      text += "<path fill=\"none\" stroke=\"" + series.colour + "\" stroke-width=\"1.6\"" +
              (series.is_dashed ? " stroke-dasharray=\"5 3\"" : "") + " d=\"" + data + "\"/>\n";
    }
    return text;
  }

  /// Entries in rows of three.
  [[nodiscard]] std::size_t legendEntries() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(chart_.series, [](const Series& s) { return !s.label.empty(); }));
  }
  [[nodiscard]] double legendHeight() const {
    return kLegendRow_px * static_cast<double>((legendEntries() + 2) / 3);
  }

  [[nodiscard]] std::string labels() const {
    const double middle = area_.x + 0.5 * width_;
    std::string text =
        svgLabel({frame_.top_left.x + kLeft_px, frame_.top_left.y + 18.0}, chart_.title, kTitle);
    text += svgLabel({middle, area_.y + height_ + 33.0}, chart_.x_label,
                     std::string(kText) + " text-anchor=\"middle\"");
    const Point side{frame_.top_left.x + 13.0, area_.y + 0.5 * height_};
    text += svgLabel(side, chart_.y_label,
                     std::string(kText) + " text-anchor=\"middle\" transform=\"rotate(-90 " +
                         svgNumber(side.x) + " " + svgNumber(side.y) + ")\"");
    std::size_t entry = 0;
    for (const Series& series : chart_.series) {
      if (series.label.empty()) continue;
      const Point at{area_.x + static_cast<double>(entry % 3) * width_ / 3.0,
                     frame_.top_left.y + kTop_px + 8.0 + kLegendRow_px * static_cast<double>(entry / 3)};
      text += "<line x1=\"" + svgNumber(at.x) + "\" y1=\"" + svgNumber(at.y) + "\" x2=\"" +
              svgNumber(at.x + 18.0) + "\" y2=\"" + svgNumber(at.y) + "\" stroke=\"" + series.colour +
              "\" stroke-width=\"2\"" + (series.is_dashed ? " stroke-dasharray=\"5 3\"" : "") + "/>\n";
      text += svgLabel({at.x + 23.0, at.y + 4.0}, series.label, kText);
      ++entry;
    }
    return text;
  }

  const Chart& chart_;
  const Frame& frame_;
  Extent x_;
  Extent y_;
  Point area_;
  double width_ = 0.0;
  double height_ = 0.0;
};

}  // namespace

std::string drawChart(const Chart& chart, const Frame& frame) { return Drawing(chart, frame).text(); }

std::string drawCharts(const std::vector<Chart>& charts, const std::string& title) {
  constexpr double kWidth_px = 560.0;
  constexpr double kHeight_px = 360.0;
  constexpr double kHead_px = 34.0;
  const double width = 2.0 * kWidth_px;
  const double height = kHead_px + kHeight_px * static_cast<double>((charts.size() + 1) / 2);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + svgNumber(width) +
                     "\" height=\"" + svgNumber(height) +
                     "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  text += svgLabel({16.0, 23.0}, title, kTitle);
  for (std::size_t i = 0; i < charts.size(); ++i)
    text += drawChart(charts[i], {{kWidth_px * static_cast<double>(i % 2),
                                   kHead_px + kHeight_px * static_cast<double>(i / 2)},
                                  kWidth_px,
                                  kHeight_px});
  return text + "</svg>\n";
}

}  // namespace underway
