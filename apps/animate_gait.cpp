#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "apps/draw_gait.hpp"
#include "apps/svg.hpp"
#include "gait/nao.hpp"
#include "gait/rest.hpp"

namespace underway {
namespace {

using namespace gait;

/// The lines of the figure, as points on links [m].
struct Joint {
  const char* link;
  Eigen::Vector3d at;
};
using Limb = std::vector<Joint>;

std::vector<Limb> limbsOf(const char* side, const char* small) {
  const auto link = [](const char* prefix, const char* name) {
    static std::set<std::string> names;  // the names live as long as the program
    return names.insert(std::string(prefix).append(name)).first->c_str();
  };
  const char* foot = link(small, "_ankle");
  return {{{foot, {0.0935, 0.0, -0.0452}},
           {foot, {-0.05, 0.0, -0.0452}},
           {foot, {0.0, 0.0, 0.0}},
           {foot, {0.0935, 0.0, -0.0452}}},
          {{foot, {0.0, 0.0, 0.0}},
           {link(side, "Tibia"), {0.0, 0.0, 0.0}},
           {link(side, "Thigh"), {0.0, 0.0, 0.0}}},
          {{link(side, "Bicep"), {0.0, 0.0, 0.0}},
           {link(side, "ForeArm"), {0.0, 0.0, 0.0}},
           {link(small, "_wrist"), {0.1, 0.0, 0.0}}}};
}

nlohmann::json pointOf(const Eigen::Vector3d& p) {
  const auto mm = [](double m) { return std::round(1e4 * m) / 10.0; };
  return {mm(p.x()), mm(p.z())};
}

/// One frame: limbs, trunk and head, seen from the side [mm].
nlohmann::json frameOf(const Rest& rest, const Placements& placements, const std::vector<Limb>& limbs) {
  const Eigen::Isometry3d world = rest.placement();
  const auto at = [&](const Joint& joint) {
    return pointOf(world * (placements[*nao().findLink(joint.link)] * joint.at));
  };
  nlohmann::json lines = nlohmann::json::array();
  for (const Limb& limb : limbs) {
    nlohmann::json line = nlohmann::json::array();
    for (const Joint& joint : limb) line.push_back(at(joint));
    lines.push_back(line);
  }
  lines.push_back({at({"torso", {0.0, 0.0, -0.085}}), at({"torso", {0.0, 0.0, 0.1265}})});
  return {{"lines", lines}, {"head", at({"Head", {0.0, 0.0, 0.0535}})}, {"mass", pointOf(rest.mass_center)}};
}

std::vector<double> poseOf(const JointTable& motion, std::size_t row) {
  std::vector<double> pose;
  for (const std::string& joint : nao().joints()) pose.push_back(motion.angles(row)[*motion.find(joint)]);
  return pose;
}

constexpr const char* kPage = R"html(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>TITLE</title><style>
body{font-family:sans-serif;margin:1.5em;color:#222}canvas{width:100%;border:1px solid #ccc;background:#fff}
input{width:60%;vertical-align:middle}button{font-size:1em;margin-right:1em}</style></head><body>
<h2>TITLE</h2><canvas id="view" width="1400" height="480"></canvas>
<p><button id="play">pause</button><input id="when" type="range" min="0" step="1"><span id="text"></span></p>
<p>Seen from its left: the left limbs are blue, behind them the right ones are orange. The dot is the centre of mass; the lower line is the floor, the grid 100 mm.</p>
<script>
const motion = MOTION;
const view = document.getElementById('view'), g = view.getContext('2d');
const when = document.getElementById('when'), button = document.getElementById('play');
when.max = motion.frames.length - 1; when.value = 0;
const all = motion.frames.flatMap(f => f.lines.flat());
const left = Math.min(...all.map(p => p[0])) - 60, right = Math.max(...all.map(p => p[0])) + 120;
const top_ = Math.max(300, ...all.map(p => p[1] + 90));
const scale = Math.min(view.width / (right - left), (view.height - 20) / top_);
const X = x => (x - left) * scale, Z = z => view.height - 15 - z * scale;
function stroke(points, colour, width) {
  g.strokeStyle = colour; g.lineWidth = width; g.lineCap = g.lineJoin = 'round'; g.beginPath();
  points.forEach((p, i) => i ? g.lineTo(X(p[0]), Z(p[1])) : g.moveTo(X(p[0]), Z(p[1]))); g.stroke();
}
function draw(i) {
  const f = motion.frames[i]; g.clearRect(0, 0, view.width, view.height);
  for (let x = Math.ceil(left / 100) * 100; x < right; x += 100) stroke([[x, 0], [x, top_]], '#eee', 1);
  for (let z = 100; z < top_; z += 100) stroke([[left, z], [right, z]], '#eee', 1);
  stroke([[left, 0], [right, 0]], '#555', 2);
  f.lines.slice(3, -1).forEach(line => stroke(line, '#e8590c', 8)); // the far side, wider: seen behind the near one
  stroke(f.lines.at(-1), '#444', 9);
  f.lines.slice(0, 3).forEach(line => stroke(line, '#3b6fd4', 4));
  g.fillStyle = '#444'; g.beginPath(); g.arc(X(f.head[0]), Z(f.head[1]), 61 * scale, 0, 7); g.fill();
  g.fillStyle = '#c2255c'; g.beginPath(); g.arc(X(f.mass[0]), Z(f.mass[1]), 5, 0, 7); g.fill();
  document.getElementById('text').textContent = ' ' + motion.times[i].toFixed(2) + ' s';
}
let playing = true, start = null;
button.onclick = () => { playing = !playing; start = null; button.textContent = playing ? 'pause' : 'play'; };
when.oninput = () => { playing = false; button.textContent = 'play'; draw(+when.value); };
function tick(now) {
  if (playing) {
    if (start === null) start = now - 1000 * (motion.times[+when.value] - motion.times[0]);
    const length = motion.times[motion.times.length - 1] - motion.times[0];
    const t = motion.times[0] + ((now - start) / 1000) % (length + 0.8);
    let i = motion.times.findIndex(x => x >= t); if (i < 0) i = motion.times.length - 1;
    when.value = i; draw(i);
  }
  requestAnimationFrame(tick);
}
draw(0); requestAnimationFrame(tick);
</script></body></html>
)html";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

}  // namespace

std::string animateGait(const std::string& title, const JointTable& motion) {
  constexpr double kFaceDown_rad = 0.5 * std::numbers::pi;
  std::vector<Limb> limbs = limbsOf("L", "l");
  for (Limb& limb : limbsOf("R", "r")) limbs.push_back(std::move(limb));
  const std::vector<Rest> rests = settleAll(nao(), motion, kFaceDown_rad);
  nlohmann::json page{{"times", nlohmann::json::array()}, {"frames", nlohmann::json::array()}};
  for (std::size_t row = 0; row < motion.rows(); ++row) {
    page["times"].push_back(motion.time(row));
    page["frames"].push_back(frameOf(rests[row], placementsOf(nao(), poseOf(motion, row)), limbs));
  }
  return replaced(replaced(kPage, "TITLE", svgText(title)), "MOTION", page.dump());
}

}  // namespace underway
