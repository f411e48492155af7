#include "bench/race_plots.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace underway::bench {
namespace {

constexpr double kWidth = 760.0;
constexpr double kHeight = 420.0;
constexpr double kLeft = 70.0;
constexpr double kRight = 150.0;  // for the legend
constexpr double kTop = 46.0;
constexpr double kBottom = 56.0;
constexpr int kSteps = 240;  // along the time axis
constexpr double kFirst_s = 1e-4;
// Told apart by people who do not see all colours (Okabe and Ito); ours is the first and the widest.
constexpr std::array kColours{"#000000", "#e69f00", "#56b4e9", "#009e73", "#d55e00", "#cc79a7"};

/// What a curve shows: its value at a time; nothing where it has none.
using Value = std::function<std::optional<double>(const std::string& planner, double time_s)>;

struct Axis {
  std::string title;
  std::string label;
  double least = 0.0;
  double most = 1.0;
  std::vector<double> ticks;
  bool is_percent = true;
};

class Plot {
 public:
  Plot(const Axis& axis, double limit_s) : axis_(axis), limit_s_(limit_s) {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        kWidth, kHeight);
    label(kLeft, 24.0, axis.title, "font-size=\"15\" font-weight=\"bold\"");
    drawGrid();
  }

  void curve(const std::string& name, std::size_t at, const Value& value) {
    const char* colour = kColours.at(at % kColours.size());
    std::string path;
    double end_y = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
      const double time_s = kFirst_s * std::pow(limit_s_ / kFirst_s, static_cast<double>(i) / kSteps);
      const auto v = value(name, time_s);
      if (!v) continue;
      const double before_y = end_y;
      end_y = y(*v);
      if (!path.empty()) path += fmt::format("L{:.1f} {:.1f}", x(time_s), before_y);  // in steps
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x(time_s), end_y);
    }
    const double width = name == kOwnName ? 3.0 : 1.8;
    text_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n", path, colour,
                         width);
    const double row = kTop + 14.0 + 20.0 * static_cast<double>(at);
    text_ += fmt::format("<path d=\"M{0} {1}h22\" stroke=\"{2}\" stroke-width=\"{3}\"/>\n",
                         kWidth - kRight + 14.0, row - 4.0, colour, width);
    label(kWidth - kRight + 42.0, row, path.empty() ? name + " (none)" : name, "");
  }

  std::string finish() { return text_ + "</svg>\n"; }

 private:
  [[nodiscard]] double x(double time_s) const {
    const double share = std::log(time_s / kFirst_s) / std::log(limit_s_ / kFirst_s);
    return kLeft + share * (kWidth - kLeft - kRight);
  }
  [[nodiscard]] double y(double value) const {
    const double share =
        (std::clamp(value, axis_.least, axis_.most) - axis_.least) / (axis_.most - axis_.least);
    return kHeight - kBottom - share * (kHeight - kTop - kBottom);
  }

  void label(double at_x, double at_y, const std::string& text, const std::string& attributes) {
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", at_x, at_y, attributes, text);
  }

  void drawGrid() {
    for (double decade = kFirst_s; decade <= limit_s_ * 1.0001; decade *= 10.0) {
      line(x(decade), kTop, x(decade), kHeight - kBottom);
      const std::string unit =
          decade < 0.9995 ? fmt::format("{:g} ms", decade * 1e3) : fmt::format("{:g} s", decade);
      label(x(decade), kHeight - kBottom + 20.0, unit, "text-anchor=\"middle\"");
    }
    for (const double tick : axis_.ticks) {
      line(kLeft, y(tick), kWidth - kRight, y(tick));
      const std::string text =
          axis_.is_percent ? fmt::format("{:g} %", tick * 100.0) : fmt::format("{:g}", tick);
      label(kLeft - 8.0, y(tick) + 4.0, text, "text-anchor=\"end\"");
    }
    label(0.5 * (kLeft + kWidth - kRight), kHeight - 12.0, "time since the world was in memory",
          "text-anchor=\"middle\"");
    const double middle = 0.5 * (kTop + kHeight - kBottom);
    label(18.0, middle, axis_.label,
          fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 18 {})\"", middle));
  }

  void line(double x1, double y1, double x2, double y2) {
    text_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#ddd\"/>\n", x1, y1, x2, y2);
  }

  const Axis& axis_;
  double limit_s_;
  std::string text_;
};

/// Our own first.
std::vector<std::string> plannersOf(const std::vector<Race>& races) {
  std::vector<std::string> names;
  for (const auto& [name, runs] : races.front().runs) names.push_back(name);
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name == kOwnName; });
  return names;
}

std::string plotted(const std::vector<Race>& races, const Axis& axis, double limit_s, const Value& value) {
  Plot plot(axis, limit_s);
  const auto names = plannersOf(races);
  for (std::size_t i = 0; i < names.size(); ++i) plot.curve(names[i], i, value);
  return plot.finish();
}

template <class TimeOf>
std::string plotShares(const std::vector<Race>& races, const char* title, double limit_s,
                       const TimeOf& time_of) {
  const Axis axis{title, "share of runs", 0.0, 1.0, {0.0, 0.25, 0.5, 0.75, 1.0}, true};
  return plotted(races, axis, limit_s, [&](const std::string& planner, double time_s) {
    double done = 0.0;
    double all = 0.0;
    for (const Race& race : races)
      for (const Run& run : race.runs.at(planner)) {
        const auto time = time_of(race, run);
        done += time && *time <= time_s ? 1.0 : 0.0;
        all += 1.0;
      }
    return std::optional(done / all);
  });
}

}  // namespace

std::string plotFirstPlan(const std::vector<Race>& races, double limit_s) {
  return plotShares(races, "Runs that have a plan", limit_s,
                    [](const Race&, const Run& run) { return firstTime(run); });
}

std::string plotWithinTenPercent(const std::vector<Race>& races, double limit_s) {
  return plotShares(races, "Runs whose plan is within 10 % of the oracle's", limit_s,
                    [](const Race& race, const Run& run) { return timeWithin(run, 1.1 * race.oracle_s); });
}

std::string plotCost(const std::vector<Race>& races, double limit_s) {
  const Axis axis{"Cost of the best plan so far, median of the runs",
                  "cost over the oracle's",
                  0.9,
                  2.0,
                  {1.0, 1.1, 1.25, 1.5, 1.75, 2.0},
                  false};
  return plotted(races, axis, limit_s, [&](const std::string& planner, double time_s) {
    std::vector<std::optional<double>> costs;  // a run without a plan costs infinitely much
    for (const Race& race : races)
      for (const Run& run : race.runs.at(planner)) {
        const auto cost = costAt(run, time_s);
        costs.push_back(cost ? std::optional(*cost / race.oracle_s) : std::nullopt);
      }
    const double median = quantileOf(costs, 0.5);
    return std::isfinite(median) ? std::optional(median) : std::nullopt;
  });
}

}  // namespace underway::bench
