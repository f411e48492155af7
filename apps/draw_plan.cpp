#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "apps/draw_layers.hpp"
#include "geometry/convex.hpp"

namespace underway {
namespace {

/// The box's footprint when the body frame stands at a pose, counter-clockwise from the rear right corner.
std::array<Point, 4> footprint(const BodyBox& body, const Pose& at) {
  return {transform(at, {body.x.min, body.y.min}), transform(at, {body.x.max, body.y.min}),
          transform(at, {body.x.max, body.y.max}), transform(at, {body.x.min, body.y.max})};
}

void addSweep(PathData& path, const Robot& robot, const Motion& motion) {
  const BodyBox& body = robot.modes[motion.mode].body_m;
  if (motion.kind == MotionKind::kSwitch) {
    if (const Switch* change = robot.findSwitch(motion.mode, motion.to_mode))
      path.polygon(footprint(change->body_m, motion.from));
    return;
  }
  if (motion.kind == MotionKind::kTranslate) {
    const auto begin = footprint(body, motion.from);
    const auto end = footprint(body, motion.to);
    std::vector<Point> both(begin.begin(), begin.end());
    both.insert(both.end(), end.begin(), end.end());
    path.polygon(convexHull(std::move(both)));
    return;
  }
  constexpr double kStep_rad = 0.05;
  constexpr double kMostSteps = 130.0;
  const double steps = std::min(std::ceil(std::abs(motion.angle_rad) / kStep_rad), kMostSteps);
  for (double i = 0.0; i <= steps; i += 1.0) {
    const double angle = steps == 0.0 ? 0.0 : motion.angle_rad * i / steps;
    path.polygon(footprint(body, {motion.from.x, motion.from.y, motion.from.yaw + angle}));
  }
}

std::string quotedFill(std::string_view colour) { return "fill=\"" + std::string(colour) + "\""; }
std::string quotedStroke(std::string_view colour) { return "stroke=\"" + std::string(colour) + "\""; }

/// All sweeps of a mode in one path, so that they unite and lie evenly faint.
std::string drawSweeps(const Plan& plan, const Robot& robot, const View& view) {
  std::string text;
  for (std::size_t mode = 0; mode < robot.modes.size(); ++mode) {
    PathData path(view);
    for (const Segment& segment : plan.segments)
      if (segment.motion.mode == mode) addSweep(path, robot, segment.motion);
    text += path.element(quotedFill(colourOf(static_cast<ModeId>(mode))) + " fill-opacity=\"0.13\"");
  }
  return text;
}

/// An arrow head half way along a line, if the line has room for it.
std::string drawArrow(Point from_px, Point to_px, std::string_view colour) {
  constexpr double kLeastLength_px = 26.0;
  constexpr double kHalf_px = 6.0;
  if (distance(from_px, to_px) < kLeastLength_px) return {};
  const Pose middle{(from_px.x + to_px.x) / 2.0, (from_px.y + to_px.y) / 2.0,
                    std::atan2(to_px.y - from_px.y, to_px.x - from_px.x)};
  std::string points;
  for (const Point local :
       {Point{kHalf_px, 0.0}, Point{-kHalf_px, kHalf_px * 0.8}, Point{-kHalf_px, -kHalf_px * 0.8}}) {
    const Point corner = transform(middle, local);
    points += svgNumber(corner.x) + "," + svgNumber(corner.y) + " ";
  }
  points.pop_back();
  return "<polygon points=\"" + points + "\" " + quotedFill(colour) + "/>\n";
}

std::string drawWay(const Plan& plan, const View& view) {
  std::string lines;
  std::string marks;
  for (const auto& [motion, duration_s, closeness] : plan.segments) {
    const std::string_view colour = colourOf(motion.mode);
    const Point from = view.toPicture(motion.from.position());
    const Point to = view.toPicture(motion.to.position());
    const std::string dashes = motion.kind == MotionKind::kSwitch ? " stroke-dasharray=\"2 5\"" : "";
    PathData path(view);
    if (motion.kind != MotionKind::kTurn) path.line(motion.from.position(), motion.to.position());
    lines += path.element("fill=\"none\" stroke-width=\"3\" stroke-linecap=\"round\" " +
                          quotedStroke(colour) + dashes);
    if (motion.kind == MotionKind::kTranslate) marks += drawArrow(from, to, colour);
    marks += "<circle cx=\"" + svgNumber(to.x) + "\" cy=\"" + svgNumber(to.y) +
             "\" r=\"2.6\" fill=\"#fff\" " + quotedStroke(colourOf(motion.to_mode)) +
             " stroke-width=\"1.6\"/>\n";
  }
  return lines + marks;
}

/// The body's outline with its front edge drawn thick: where the robot looks.
std::string drawBody(const Robot& robot, ModeId mode, const Pose& at, const View& view) {
  if (mode >= robot.modes.size()) return {};
  const std::array<Point, 4> corners = footprint(robot.modes[mode].body_m, at);
  PathData outline(view);
  outline.polygon(corners);
  PathData front(view);
  front.line(corners[1], corners[2]);
  const std::string stroke = quotedStroke(colourOf(mode));
  return outline.element("fill=\"none\" stroke-width=\"1.3\" " + stroke) +
         front.element("stroke-width=\"3.5\" stroke-linecap=\"round\" " + stroke);
}

std::string drawSwitches(const Plan& plan, const Robot& robot, const View& view) {
  std::string text;
  for (const Segment& segment : plan.segments) {
    const Motion& motion = segment.motion;
    // A switch that moves nothing (frontal to lateral) would only draw the same body twice.
    const bool is_seen = motion.kind == MotionKind::kSwitch && motion.from != motion.to;
    if (is_seen)
      text +=
          drawBody(robot, motion.mode, motion.from, view) + drawBody(robot, motion.to_mode, motion.to, view);
  }
  return text;
}

std::string drawMark(Point at_px, std::string_view letter, std::string_view colour) {
  return "<circle cx=\"" + svgNumber(at_px.x) + "\" cy=\"" + svgNumber(at_px.y) + "\" r=\"9\" " +
         quotedFill(colour) + " stroke=\"#fff\" stroke-width=\"1.5\"/>\n" +
         svgLabel({at_px.x, at_px.y + 4.2}, letter,
                  "font-size=\"12\" font-weight=\"bold\" fill=\"#fff\" text-anchor=\"middle\"");
}

std::string drawBlocking(const Error& error, const World& world, const View& view) {
  std::unordered_set<std::string_view> ids;
  for (const Blocking& blocking : error.blocking) ids.insert(blocking.obstacle);
  PathData path(view);
  for (const Obstacle& obstacle : world.obstacles()) {
    if (!ids.contains(obstacle.id)) continue;
    std::vector<Point> points;
    for (const Vec3& corner : corners(obstacle.box)) points.push_back({corner.x, corner.y});
    path.polygon(convexHull(std::move(points)));
  }
  return path.element("fill=\"#c62828\" fill-opacity=\"0.35\" stroke=\"#c62828\" stroke-width=\"2\"");
}

}  // namespace

std::string drawPlan(const Picture& picture, const View& view) {
  if (picture.document == nullptr) return {};
  const PlanDocument& document = *picture.document;
  const Request& request = document.request;
  const Robot& robot = picture.robot;
  std::string text;
  Pose goal{request.goal.x, request.goal.y, request.goal_yaw.value_or(0.0)};
  if (document.answer) {
    const Plan& plan = *document.answer;
    text += drawSweeps(plan, robot, view) + drawSwitches(plan, robot, view) + drawWay(plan, view);
    goal = plan.goal;
  } else {
    text += drawBlocking(document.answer.error(), picture.world, view);
  }
  const std::size_t led_to = document.answer ? document.answer->goal_index : 0;
  const std::vector<Goal> goals = goalsOf(request);
  for (std::size_t i = 0; i < goals.size(); ++i)
    if (i != led_to || !document.answer)
      text += drawMark(view.toPicture(goals[i].at), "G", document.answer ? "#b98a86" : "#b3261e");
  const bool knows_goal_yaw = document.answer || request.goal_yaw;
  text += drawBody(robot, request.start_mode, request.start, view);
  if (knows_goal_yaw) text += drawBody(robot, goals.at(led_to).mode, goal, view);
  return text + drawMark(view.toPicture(request.start.position()), "S", "#1b7f3b") +
         drawMark(view.toPicture(goal.position()), "G", "#b3261e");
}

}  // namespace underway
