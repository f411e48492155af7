#include "gait/crawl/gait_file.hpp"

#include <algorithm>

#include "gait/json_fields.hpp"

namespace underway::gait {
namespace {

using Json = nlohmann::ordered_json;

Cubic cubicOf(JsonFields& fields, const char* key) {
  Cubic cubic;
  std::ranges::copy(fields.numbers(key, cubic.c.size()), cubic.c.begin());
  return cubic;
}

PushShape pushOf(JsonFields fields, JsonFields& owner) {
  PushShape push{cubicOf(fields, "theta3_rad"), cubicOf(fields, "theta4_rad"), cubicOf(fields, "alpha_rad")};
  owner.take(fields);
  return push;
}

CrawlTimes timesOf(JsonFields fields, JsonFields& owner) {
  CrawlTimes times{fields.positive("extension"), fields.positive("push"), fields.positive("lowering")};
  owner.take(fields);
  return times;
}

LyingShape lyingOf(JsonFields fields, JsonFields& owner) {
  LyingShape lying;
  const std::string lowering = fields.text("lowering");
  if (lowering != "spread" && lowering != "slide") fields.refuse("lowering", "must be spread or slide");
  lying.lowering = lowering == "slide" ? Lowering::kSlide : Lowering::kSpread;
  lying.shoulder_height_m = fields.positive("shoulder_height_m");
  lying.knee_rad = fields.number("knee_rad");
  lying.hip_rad = fields.number("hip_rad");
  lying.back_rad = fields.number("back_rad");
  lying.arm_rise_rad = fields.number("arm_rise_rad");
  lying.head_rad = fields.number("head_rad");
  owner.take(fields);
  return lying;
}

Json toJson(const LyingShape& lying) {
  return {{"lowering", lying.lowering == Lowering::kSlide ? "slide" : "spread"},
          {"shoulder_height_m", lying.shoulder_height_m},
          {"knee_rad", lying.knee_rad},
          {"hip_rad", lying.hip_rad},
          {"back_rad", lying.back_rad},
          {"arm_rise_rad", lying.arm_rise_rad},
          {"head_rad", lying.head_rad}};
}

}  // namespace

std::string toJson(const GaitFile& file) {
  const CrawlGait& gait = file.gait;
  const Json json{
      {"name", gait.name},
      {"about", file.about},
      {"for_push_s", {file.for_push_s_least, file.for_push_s_most}},
      {"toe_to_elbow_m", gait.toe_to_elbow_m},
      {"spread_m", gait.spread_m},
      {"turn_rad", gait.turn_rad},
      {"push",
       {{"theta3_rad", gait.push.knee.c}, {"theta4_rad", gait.push.hip.c}, {"alpha_rad", gait.push.alpha.c}}},
      {"times_s",
       {{"extension", gait.times.extension_s},
        {"push", gait.times.push_s},
        {"lowering", gait.times.lowering_s}}},
      {"lying", toJson(gait.lying)}};
  return json.dump(1) + "\n";
}

GaitExpected<GaitFile> gaitFromJson(std::string_view text, const std::string& where) {
  const auto json = parseJson(text, where);
  if (!json) return tl::unexpected(json.error());
  JsonFields fields(*json, where);
  GaitFile file;
  file.gait.name = fields.text("name");
  file.about = fields.text("about");
  const auto range = fields.numbers("for_push_s", 2);
  if (!(0.0 < range[0] && range[0] <= range[1]))
    fields.refuse("for_push_s", "must be [least, most], above 0");
  file.for_push_s_least = range[0];
  file.for_push_s_most = range[1];
  file.gait.toe_to_elbow_m = fields.positive("toe_to_elbow_m");
  file.gait.spread_m = fields.number("spread_m");
  file.gait.turn_rad = fields.number("turn_rad");
  file.gait.push = pushOf(fields.object("push"), fields);
  file.gait.times = timesOf(fields.object("times_s"), fields);
  file.gait.lying = lyingOf(fields.object("lying"), fields);
  if (const auto fault = fields.fault()) return tl::unexpected(*fault);
  return file;
}

}  // namespace underway::gait
