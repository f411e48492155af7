#include "apps/plan_table.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "apps/table.hpp"
#include "apps/terminal.hpp"

namespace underway {
namespace {

/// Blue, green, yellow, magenta, cyan: by priority.
std::string_view colourOf(ModeId mode) {
  static constexpr std::array<std::string_view, kMaxModes> kColours{"34", "32", "33", "35", "36"};
  return kColours[mode % kColours.size()];
}

std::string kindOf(const PlanDocument& document, const Motion& motion) {
  switch (motion.kind) {
    case MotionKind::kTranslate:
      return std::string(name(motion.sense)) + " " + fixed(length(motion), 3) + " m";
    case MotionKind::kTurn:
      return "turn " + std::string(motion.angle_rad > 0.0 ? "+" : "") + fixed(motion.angle_rad, 3) + " rad";
    case MotionKind::kSwitch:
      return "switch to " + modeName(document, motion.to_mode);
  }
  return "?";
}

std::string clearanceOf(const Closeness& closeness) {
  const bool is_capped = !closeness.nearest && closeness.clearance_m >= kClearanceCap_m;
  return (is_capped ? ">= " : "") + fixed(closeness.clearance_m, 3);
}

Table tableOf(const PlanDocument& document, const Plan& plan) {
  constexpr auto kRight = Table::Align::kRight;
  Table table({{"#", kRight},
               {"mode"},
               {"motion"},
               {"from x,y,yaw"},
               {"to x,y,yaw"},
               {"s", kRight},
               {"clearance m", kRight},
               {"headroom m", kRight},
               {"nearest"}});
  for (std::size_t i = 0; i < plan.segments.size(); ++i) {
    const auto& [motion, duration_s, closeness] = plan.segments[i];
    table.add({{std::to_string(i + 1)},
               {modeName(document, motion.mode), colourOf(motion.mode)},
               {kindOf(document, motion)},
               {shortText(motion.from)},
               {shortText(motion.to)},
               {fixed(duration_s, 1)},
               {clearanceOf(closeness)},
               {closeness.headroom_m ? fixed(*closeness.headroom_m, 3) : "-"},
               {closeness.nearest ? closeness.nearest->id : "-"}});
  }
  return table;
}

/// "frontal 3.20 m, crawl 1.10 m": the modes that move, in order of priority.
std::string metresByMode(const PlanDocument& document, const Plan& plan) {
  std::vector<double> metres(document.mode_names.size(), 0.0);
  for (const Segment& segment : plan.segments)
    if (segment.motion.mode < metres.size()) metres[segment.motion.mode] += length(segment.motion);
  std::string text;
  for (std::size_t mode = 0; mode < metres.size(); ++mode)
    if (metres[mode] > 0.0)
      text += (text.empty() ? "" : ", ") + document.mode_names[mode] + " " + fixed(metres[mode], 2) + " m";
  return text;
}

std::string totalsOf(const PlanDocument& document, const Plan& plan) {
  if (plan.segments.empty()) return "The robot is there already.\n";
  const auto closest = std::min_element(
      plan.segments.begin(), plan.segments.end(),
      [](const Segment& a, const Segment& b) { return a.closeness.clearance_m < b.closeness.clearance_m; });
  const std::string metres = metresByMode(document, plan);
  std::string text = "Total " + fixed(plan.total_time_s, 1) + " s, " + fixed(plan.length_m, 2) + " m" +
                     (metres.empty() ? "" : " (" + metres + ")") + ", least clearance " +
                     clearanceOf(closest->closeness) + " m. Policy " +
                     std::string(name(document.request.policy));
  const PlanStats& stats = plan.stats;
  if (stats.nodes > 0)  // what is left of an older plan was not looked for
    text += "; roadmap of " + std::to_string(stats.nodes) + " nodes and " + std::to_string(stats.edges) +
            " edges, " + fixed(stats.build_ms, 0) + " ms; query " + fixed(stats.query_us / 1e3, 1) +
            " ms, certificate " + fixed(stats.certify_us / 1e3, 1) + " ms";
  return text + ".\n";
}

std::string describeFailure(const Error& error, bool with_colours) {
  const bool is_stale = error.code == ErrorCode::kStaleRevision;  // none was asked for, but whether one holds
  std::string text = is_stale ? "Stale: " + printable(error.message) + ".\n"
                              : "No plan: " + std::string(name(error.code)) + ".\n";
  if (error.blocking.empty()) return text;
  constexpr auto kRight = Table::Align::kRight;
  Table table({{"in the way"}, {"mode"}, {"of"}, {"needs m", kRight}, {"has m", kRight}});
  for (const Blocking& one : error.blocking) {
    const bool is_told = !one.of.empty();  // how much is missing
    table.add({{one.obstacle},
               {one.mode},
               {is_told ? one.of : "-"},
               {is_told ? fixed(one.needs_m, 3) : "-"},
               {is_told ? fixed(one.has_m, 3) : "-"}});
  }
  return text + table.text(with_colours);
}

/// Without "-0.000".
std::string rounded(double number) {
  const std::string text = fixed(number, 3);
  return text == "-0.000" ? "0.000" : text;
}

/// Which of several goals it is, and how the plan was chosen; empty where there was no choice.
std::string choicesOf(const PlanDocument& document, const Plan& plan) {
  std::string text;
  const std::size_t goals = 1 + document.request.other_goals.size();
  if (goals > 1)
    text += "To goal " + std::to_string(plan.goal_index + 1) + " of " + std::to_string(goals) + ": " +
            shortText(plan.goal) + ".\n";
  if (document.choice)
    text += std::string(document.choice->is_new ? "A new plan: " : "No new plan: ") + document.choice->why +
            ".\n";
  return text;
}

}  // namespace

std::string describe(const PlanDocument& document, bool with_colours) {
  if (!document.answer) return describeFailure(document.answer.error(), with_colours);
  const Plan& plan = *document.answer;
  const std::string table = plan.segments.empty() ? "" : tableOf(document, plan).text(with_colours);
  return table + totalsOf(document, plan) + choicesOf(document, plan);
}

std::string shortText(const Pose& pose) {
  return rounded(pose.x) + "," + rounded(pose.y) + "," + rounded(pose.yaw);
}

std::string modeName(const PlanDocument& document, ModeId mode) {
  return mode < document.mode_names.size() ? document.mode_names[mode] : "?";
}

}  // namespace underway
