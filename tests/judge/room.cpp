#include "tests/judge/room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "tests/judge/passage.hpp"

namespace judge {
namespace {

constexpr double kCap_m = 1.0;     // clearances are told up to this
constexpr double kAbove_m = 1e-6;  // a clearance may be this much above the truth: rounding
constexpr double kBelow_m = 1e-3;  // and this much below
constexpr double kNearest_m = 2e-3;

template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  text.precision(9);
  (text << ... << parts);
  return text.str();
}

/// The map as each slab sees it, cut once.
class Views {
 public:
  explicit Views(const Scene& scene) : scene_(scene) {}
  const View& of(const Passage& passage) {
    const auto slab = std::pair(passage.z_min, passage.z_max);
    auto found = views_.find(slab);
    if (found == views_.end()) found = views_.emplace(slab, viewOf(scene_, slab.first, slab.second)).first;
    return found->second;
  }

 private:
  const Scene& scene_;
  std::map<std::pair<double, double>, View> views_;
};

/// How far a segment is from what it sees: of the body itself, and widened by drift. Without drift they are
/// the same.
struct Gap {
  double body_m = 0.0;
  double widened_m = 0.0;
};

Gap gapOf(const Passage& passage, const View& view) {
  const double body_m = leastDistance(passage.course, view, kCap_m);
  const bool drifts = passage.widened.body.y_max != passage.course.body.y_max ||
                      passage.widened.body.x_max != passage.course.body.x_max;
  return {body_m, drifts ? leastDistance(passage.widened, view, kCap_m) : body_m};
}

class RoomJudge {
 public:
  RoomJudge(const Document& document, const Scene& scene, const RobotFile& robot, Verdict& verdict)
      : document_(document), scene_(scene), robot_(robot), verdict_(verdict), views_(scene) {}

  void judge() {
    for (std::size_t i = 0; i < document_.segments.size(); ++i) {
      const Segment& segment = document_.segments[i];
      const Passage passage = passageOf(segment, scene_, robot_);
      const View& view = views_.of(passage);
      gaps_.push_back(gapOf(passage, view));
      where_ = sentence("segment ", i, " (", segment.kind, " in ", segment.mode, ")");
      if (!staysInside(passage.widened, scene_.bounds)) complain("leaves the bounds");
      judgeClearance(segment, gaps_.back());
      judgeNearest(segment, passage, view);
      judgeHeadroom(segment, passage);
    }
    judgeMargins();
  }

  [[nodiscard]] bool touches(const Pose& pose, const std::string& mode) {
    const Passage passage = standing(pose, mode, scene_, robot_);
    return leastDistance(passage.course, views_.of(passage), kCap_m) <= 0.0;
  }
  [[nodiscard]] bool isOutside(const Pose& pose, const std::string& mode) {
    return !staysInside(standing(pose, mode, scene_, robot_).course, scene_.bounds);
  }

 private:
  template <class... Parts>
  void complain(const Parts&... parts) {
    verdict_.violations.push_back(sentence(where_, ": ", parts...));
  }

  void judgeClearance(const Segment& segment, const Gap& gap) {
    const double claim_m = segment.clearance_m;
    if (claim_m > gap.body_m + kAbove_m)
      complain("clearance_m is ", claim_m, ", the truth is ", gap.body_m);
    else if (claim_m < gap.widened_m - kBelow_m - kAbove_m)
      complain("clearance_m is ", claim_m, ", more than 1 mm below the truth, ", gap.widened_m);
    else if (gap.widened_m < gap.body_m - kBelow_m)
      verdict_.notes.push_back(sentence(where_, ": clearance_m is read ",
                                        claim_m > gap.widened_m + kAbove_m ? "without" : "with",
                                        " the drift"));
  }

  /// The pieces known by an id; an id the scenario does not know can only name cells of its map.
  [[nodiscard]] View named(const std::string& id, const View& view) const {
    const auto is_it = [&](const Box& box) { return box.id == id; };
    const bool known = std::any_of(scene_.boxes.begin(), scene_.boxes.end(), is_it);
    View pieces;
    for (const View::Piece& piece : view.pieces)
      if (scene_.boxes[piece.box].id == (known ? id : "")) pieces.pieces.push_back(piece);
    return pieces;
  }

  void judgeNearest(const Segment& segment, const Passage& passage, const View& view) {
    if (!segment.nearest) {
      if (segment.clearance_m < kCap_m)
        complain("nearest is null at a clearance of ", segment.clearance_m, " m");
      return;
    }
    const View pieces = named(segment.nearest->id, view);
    if (pieces.pieces.empty()) return complain("sees no obstacle \"", segment.nearest->id, "\"");
    const Gap gap = gapOf(passage, pieces);
    if (!isBetween(segment.clearance_m, gap, kNearest_m))
      complain("nearest \"", segment.nearest->id, "\" is at ", gap.body_m, " m, not at ",
               segment.clearance_m);
    double off_m = kCap_m;
    for (const View::Piece& piece : pieces.pieces)
      off_m = std::min(off_m, distance(segment.nearest->at, piece.footprint));
    if (off_m > kNearest_m) complain("nearest point is ", off_m, " m off \"", segment.nearest->id, "\"");
    const Polygon point{segment.nearest->at};
    const Gap to_point{leastDistance(passage.course, point), leastDistance(passage.widened, point)};
    if (!isBetween(segment.clearance_m, to_point, kNearest_m))
      complain("nearest point is at ", to_point.body_m, " m, not at ", segment.clearance_m);
  }

  [[nodiscard]] static bool isBetween(double claim_m, const Gap& gap, double tolerance_m) {
    return claim_m <= gap.body_m + tolerance_m && claim_m >= gap.widened_m - tolerance_m;
  }

  /// What hangs over an edge of the body may or may not count: within 1 mm, as the way is sampled.
  void judgeHeadroom(const Segment& segment, const Passage& passage) {
    Course inner = passage.course;
    inner.body = inner.body.grown(-kSample_m, -kSample_m);
    Course outer = passage.widened;
    outer.body = outer.body.grown(kSample_m, kSample_m);
    const double most_m = headroom(inner, scene_, passage.z_max);
    const double least_m = headroom(outer, scene_, passage.z_max);
    const double claim_m = segment.headroom_m.value_or(std::numeric_limits<double>::infinity());
    if (claim_m > most_m + kAbove_m || claim_m < least_m - kAbove_m)
      complain("headroom_m is ", claim_m, ", the truth is ", most_m);
  }

  /// From the start until the margin is reached, and from where it is lost for the last time to the goal, the
  /// body may be as close as the start and the goal are.
  void judgeMargins() {
    const double margin_m = robot_.margin_m;
    const auto is_close = [&](const Gap& gap) { return gap.widened_m < margin_m - kAbove_m; };
    const Pose end = document_.segments.empty() ? document_.start : document_.segments.back().to;
    const double at_start_m = closenessOf(document_.start, document_.start_mode);
    const double at_goal_m = closenessOf(end, document_.goal_mode);
    where_ = "start";
    if (at_start_m <= 0.0) complain("touches an obstacle");
    if (isOutside(document_.start, document_.start_mode)) complain("is outside the bounds");

    const std::size_t count = gaps_.size();
    std::size_t leaving = 0;
    while (leaving < count && is_close(gaps_[leaving])) ++leaving;
    std::size_t entering = count;
    while (entering > 0 && is_close(gaps_[entering - 1])) --entering;
    for (std::size_t i = 0; i < count; ++i) {
      where_ =
          sentence("segment ", i, " (", document_.segments[i].kind, " in ", document_.segments[i].mode, ")");
      double allowed_m = margin_m;
      if (i < leaving) allowed_m = std::min(allowed_m, at_start_m);
      if (i >= entering) allowed_m = std::min(allowed_m, at_goal_m);
      if (gaps_[i].widened_m <= 0.0)
        complain("touches an obstacle");
      else if (gaps_[i].widened_m < allowed_m - kAbove_m)
        complain("comes as close as ", gaps_[i].widened_m, " m, allowed are ", allowed_m);
      else if (is_close(gaps_[i]) && i > 0 && i + 1 < count)
        verdict_.notes.push_back(sentence(where_, ": is below the margin as its start or goal is"));
    }
  }

  [[nodiscard]] double closenessOf(const Pose& pose, const std::string& mode) {
    const Passage passage = standing(pose, mode, scene_, robot_);
    return leastDistance(passage.course, views_.of(passage), kCap_m);
  }

  const Document& document_;
  const Scene& scene_;
  const RobotFile& robot_;
  Verdict& verdict_;
  Views views_;
  std::vector<Gap> gaps_;
  std::string where_;
};

}  // namespace

void judgeRoom(const Document& document, const Scene& scene, const RobotFile& robot, Verdict& verdict) {
  RoomJudge(document, scene, robot, verdict).judge();
}

void judgeRefusal(const Document& document, const Scene& scene, const RobotFile& robot, Verdict& verdict) {
  const auto complain = [&](const std::string& what) { verdict.violations.push_back("plan: " + what); };
  if (document.message.empty()) complain("says no without a message");
  if (!document.segments.empty()) complain("says no and has segments");
  // A robot or a mode that is refused has no body to look at.
  if (robot.findMode(document.start_mode) == nullptr || robot.findMode(document.goal_mode) == nullptr) return;
  RoomJudge room(document, scene, robot, verdict);
  const Pose goal{document.goal.x, document.goal.y, document.goal_yaw.value_or(0.0)};
  if (document.status == "start_in_collision" && !room.touches(document.start, document.start_mode))
    complain("says start_in_collision, but the start touches nothing");
  if (document.status == "start_out_of_bounds" && !room.isOutside(document.start, document.start_mode))
    complain("says start_out_of_bounds, but the start is inside");
  // A goal without yaw would have to be judged at every heading.
  if (!document.goal_yaw) return;
  if (document.status == "goal_in_collision" && !room.touches(goal, document.goal_mode))
    complain("says goal_in_collision, but the goal touches nothing");
  if (document.status == "goal_out_of_bounds" && !room.isOutside(goal, document.goal_mode))
    complain("says goal_out_of_bounds, but the goal is inside");
}

}  // namespace judge
