#include <algorithm>
#include <limits>

#include "apps/draw_layers.hpp"
#include "apps/plan_table.hpp"
#include "apps/table.hpp"

namespace underway {
namespace {

constexpr double kLine_px = 20.0;
constexpr std::string_view kSmall = "font-size=\"12\" fill=\"#46515e\"";
constexpr std::string_view kRight = "font-size=\"12\" fill=\"#46515e\" text-anchor=\"end\"";

/// Writes line after line, downwards.
class Column {
 public:
  Column(Point at_px, double width_px) : at_(at_px), width_px_(width_px) {}

  void heading(std::string_view text) {
    line(text, "font-size=\"17\" font-weight=\"bold\" fill=\"#1d2630\"");
  }
  void line(std::string_view text, std::string_view attributes = kSmall) {
    text_ += svgLabel(at_, text, attributes);
    at_.y += kLine_px;
  }
  /// A sample of how it is painted, what it is, and numbers at the right edge.
  void key(std::string_view paint, std::string_view what, std::string_view numbers = {}) {
    text_ += "<rect x=\"" + svgNumber(at_.x) + "\" y=\"" + svgNumber(at_.y - 11.0) +
             "\" width=\"22\" height=\"13\" " + std::string(paint) + "/>\n";
    name(what, numbers);
  }
  /// The same with a sample of a thin line.
  void lineKey(std::string_view stroke, std::string_view what, std::string_view numbers = {}) {
    text_ += "<path d=\"M" + svgNumber(at_.x) + " " + svgNumber(at_.y - 1.0) + "l22 -7\" " +
             std::string(stroke) + "/>\n";
    name(what, numbers);
  }
  void gap() { at_.y += kLine_px / 2.0; }
  /// Broken between words; a picture has no room for more than twelve lines.
  void paragraph(std::string_view text) {
    constexpr std::size_t kCharacters = 38;
    for (int lines = 0; !text.empty() && lines < 12; ++lines) {
      std::size_t end = text.size() <= kCharacters ? text.size() : text.rfind(' ', kCharacters);
      if (end == std::string_view::npos || end == 0) end = std::min(kCharacters, text.size());
      line(text.substr(0, end));
      text.remove_prefix(std::min(text.size(), text.find_first_not_of(' ', end)));
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void name(std::string_view what, std::string_view numbers) {
    text_ += svgLabel({at_.x + 32.0, at_.y}, what, kSmall);
    if (!numbers.empty()) text_ += svgLabel({at_.x + width_px_, at_.y}, numbers, kRight);
    at_.y += kLine_px;
  }

  Point at_;
  double width_px_;
  std::string text_;
};

std::string solid(std::string_view colour) { return "fill=\"" + std::string(colour) + "\""; }

void writeModes(Column& column, const Plan& plan, const Robot& robot) {
  for (std::size_t mode = 0; mode < robot.modes.size(); ++mode) {
    double metres = 0.0;
    double seconds = 0.0;
    for (const Segment& segment : plan.segments) {
      if (segment.motion.mode != mode || segment.motion.kind == MotionKind::kSwitch) continue;
      metres += length(segment.motion);
      seconds += segment.duration_s;
    }
    if (seconds > 0.0)
      column.key(solid(colourOf(static_cast<ModeId>(mode))), robot.modes[mode].name,
                 fixed(metres, 2) + " m, " + fixed(seconds, 1) + " s");
  }
  double switching_s = 0.0;
  for (const Segment& segment : plan.segments)
    if (segment.motion.kind == MotionKind::kSwitch) switching_s += segment.duration_s;
  if (switching_s > 0.0)
    column.key("fill=\"none\" stroke=\"#46515e\" stroke-dasharray=\"2 4\"", "switching",
               fixed(switching_s, 1) + " s");
}

void writePlan(Column& column, const Plan& plan, const Robot& robot) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Segment& segment : plan.segments) least_m = std::min(least_m, segment.closeness.clearance_m);
  column.line(fixed(plan.total_time_s, 1) + " s, " + fixed(plan.length_m, 2) + " m",
              "font-size=\"14\" font-weight=\"bold\" fill=\"#1d2630\"");
  if (!plan.segments.empty()) column.line("least clearance " + fixed(least_m, 3) + " m");
  column.gap();
  writeModes(column, plan, robot);
  column.gap();
}

void writeObstacles(Column& column, const World& world, const Robot& robot) {
  std::array<bool, 3> is_there{};
  std::string free_modes;  // that fit under or over something that blocks others
  std::array<bool, kMaxModes> is_free{};
  for (const Obstacle& obstacle : world.obstacles()) {
    const Blocks blocks = blocksOf(obstacle, world, robot);
    is_there[static_cast<std::size_t>(blocks)] = true;
    if (blocks != Blocks::kSome) continue;
    for (std::size_t mode = 0; mode < std::min(robot.modes.size(), kMaxModes); ++mode)
      is_free[mode] |= !isSeenBy(obstacle, robot.modes[mode], world.floorZ());
  }
  for (std::size_t mode = 0; mode < std::min(robot.modes.size(), kMaxModes); ++mode)
    if (is_free[mode]) free_modes += (free_modes.empty() ? "" : ", ") + robot.modes[mode].name;
  const auto has = [&](Blocks blocks) { return is_there[static_cast<std::size_t>(blocks)]; };
  if (has(Blocks::kEvery)) column.key(paintOf(Blocks::kEvery), "blocks every mode");
  if (has(Blocks::kSome)) column.key(paintOf(Blocks::kSome), "free for " + free_modes + " only");
  if (has(Blocks::kNone)) column.key(paintOf(Blocks::kNone), "blocks no mode");
}

}  // namespace

std::string drawLegend(const Picture& picture, Point at_px, double width_px) {
  Column column(at_px, width_px);
  column.heading(picture.world.name());
  const std::string robot = "robot " + picture.robot.name;
  if (picture.document == nullptr) {
    column.line(robot);
  } else {
    column.line(robot + ", policy " + std::string(name(picture.document->request.policy)));
    column.gap();
    if (picture.document->answer) {
      writePlan(column, *picture.document->answer, picture.robot);
    } else {
      const Error& error = picture.document->answer.error();
      column.line("no plan: " + std::string(name(error.code)),
                  "font-size=\"14\" font-weight=\"bold\" fill=\"#b3261e\"");
      column.paragraph(error.message);
      column.gap();
      if (!error.blocking.empty())
        column.key("fill=\"#c62828\" fill-opacity=\"0.35\" stroke=\"#c62828\"", "in the way");
      column.gap();
    }
  }
  writeObstacles(column, picture.world, picture.robot);
  if (picture.roadmap != nullptr) {
    column.lineKey("stroke=\"#8d99a6\" stroke-width=\"1\"", "roadmap",
                   std::to_string(picture.roadmap->node_count) + " nodes, " +
                       std::to_string(picture.roadmap->edge_count) + " edges");
  }
  return column.text();
}

}  // namespace underway
