#include "tests/judge/document.hpp"

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>

namespace judge {
namespace {

using Json = nlohmann::json;

/// Reads keys of one object, and tells of those that are not as they should be.
class Fields {
 public:
  Fields(const Json& object, std::string where, std::vector<std::string>& violations)
      : object_(object), where_(std::move(where)), violations_(violations) {
    if (!object_.is_object()) complain("is not an object");
  }

  [[nodiscard]] bool has(const char* key) const {
    return object_.is_object() && object_.contains(key) && !object_[key].is_null();
  }
  const Json& any(const char* key) {
    static const Json kNothing;
    if (object_.is_object() && object_.contains(key)) return object_[key];
    complain(std::string("lacks the key \"") + key + "\"");
    return kNothing;
  }
  double number(const char* key) {
    const Json& value = any(key);
    if (value.is_number()) return value.get<double>();
    return complain(std::string("\"") + key + "\" is not a number"), 0.0;
  }
  void count(const char* key) {
    if (!any(key).is_number_unsigned()) complain(std::string("\"") + key + "\" is not a whole number >= 0");
  }
  std::string text(const char* key) {
    const Json& value = any(key);
    if (value.is_string()) return value.get<std::string>();
    return complain(std::string("\"") + key + "\" is not a text"), std::string();
  }
  std::string filled(const char* key) {
    std::string value = text(key);
    if (value.empty()) complain(std::string("\"") + key + "\" is empty");
    return value;
  }
  std::string word(const char* key, std::initializer_list<std::string_view> known) {
    std::string value = text(key);
    if (std::find(known.begin(), known.end(), value) == known.end())
      complain(std::string("\"") + key + "\" is \"" + value + "\", which the format does not know");
    return value;
  }
  std::optional<double> numberOrNull(const char* key) {
    if (any(key).is_null()) return std::nullopt;
    return number(key);
  }
  Fields object(const char* key) { return {any(key), where_ + "." + key, violations_}; }
  Pose pose(const char* key) {
    Fields fields = object(key);
    return {fields.number("x"), fields.number("y"), fields.number("yaw")};
  }
  Vec2 point(const char* key) {
    Fields fields = object(key);
    return {fields.number("x"), fields.number("y")};
  }
  const Json& list(const char* key) {
    const Json& value = any(key);
    if (!value.is_array()) complain(std::string("\"") + key + "\" is not a list");
    return value;
  }

 private:
  void complain(const std::string& what) { violations_.push_back(where_ + ": " + what); }

  const Json& object_;
  std::string where_;
  std::vector<std::string>& violations_;
};

Segment segmentOf(Fields fields) {
  Segment segment;
  segment.kind = fields.word("kind", {"translate", "turn", "arc", "switch"});
  segment.mode = fields.filled("mode");
  segment.to_mode = segment.kind == "switch" ? fields.filled("to_mode") : segment.mode;
  if (segment.kind == "translate")
    segment.sense = fields.word("sense", {"forward", "backward", "left", "right"});
  if (segment.kind == "turn" || segment.kind == "arc") segment.angle_rad = fields.number("angle_rad");
  if (segment.kind == "arc") segment.center = fields.point("center");
  segment.from = fields.pose("from");
  segment.to = fields.pose("to");
  segment.duration_s = fields.number("duration_s");
  segment.clearance_m = fields.number("clearance_m");
  segment.headroom_m = fields.numberOrNull("headroom_m");
  if (!fields.any("nearest").is_null())
    segment.nearest = Nearest{fields.object("nearest").filled("id"), fields.point("nearest")};
  return segment;
}

void checkBlocking(Fields fields) {
  fields.filled("obstacle");
  fields.filled("mode");
  fields.word("of", {"height", "width", "length", "switch"});
  fields.number("needs_m");
  fields.number("has_m");
}

void checkStats(Fields fields) {
  for (const char* key : {"nodes", "edges", "batches"}) fields.count(key);
  for (const char* key : {"build_ms", "query_us", "certify_us"}) fields.number(key);
}

Document headOf(Fields& fields) {
  Document document;
  document.status = fields.word(
      "status", {"ok", "start_in_collision", "goal_in_collision", "start_out_of_bounds", "goal_out_of_bounds",
                 "no_path_exists", "timeout", "cancelled", "busy", "invalid_request", "invalid_map",
                 "invalid_robot", "stale_revision", "no_server", "internal"});
  document.message = fields.text("message");
  fields.word("policy", {"priority", "fastest", "safest"});
  document.robot = fields.text("robot");
  document.map = fields.text("map");
  fields.count("revision");
  fields.count("seed");
  fields.text("world_hash");
  fields.text("robot_hash");
  document.start = fields.pose("start");
  document.start_mode = fields.text("start_mode");
  document.goal = fields.point("goal");
  if (Fields goal = fields.object("goal"); goal.has("yaw")) document.goal_yaw = goal.number("yaw");
  document.goal_mode = fields.text("goal_mode");
  document.total_time_s = fields.number("total_time_s");
  document.length_m = fields.number("length_m");
  checkStats(fields.object("stats"));
  return document;
}

}  // namespace

std::optional<Document> readDocument(std::string_view text, std::vector<std::string>& violations) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) {
    violations.push_back("plan: is not JSON");
    return std::nullopt;
  }
  const std::size_t before = violations.size();
  Fields fields(json, "plan", violations);
  Document document = headOf(fields);
  const Json& segments = fields.list("segments");
  for (std::size_t i = 0; segments.is_array() && i < segments.size(); ++i)
    document.segments.push_back(segmentOf({segments[i], "segment " + std::to_string(i), violations}));
  if (document.status != "ok") {
    const Json& blocking = fields.list("blocking");
    for (std::size_t i = 0; blocking.is_array() && i < blocking.size(); ++i)
      checkBlocking({blocking[i], "blocking " + std::to_string(i), violations});
  }
  if (violations.size() > before) return std::nullopt;
  return document;
}

}  // namespace judge
