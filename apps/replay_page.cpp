#include <string>

#include "apps/replay.hpp"
#include "apps/svg.hpp"

namespace underway {
namespace {

constexpr const char* kStyle = R"css(
:root{color-scheme:light dark;--page:#fafaf8;--ink:#222;--dim:#6b6b6b;--line:#d6d6d2;--floor:#fff;--tall:#5b6068;
--over:#8fb3e8;--low:#c9a227;--new:#e8590c;--stand:#1971c2;--lie:#2f9e44;--beam:#d6336c;--seen:#f08c00;--true:#222;
--bad:#c92a2a}
@media(prefers-color-scheme:dark){:root{--page:#17181a;--ink:#e6e6e3;--dim:#9a9a96;--line:#3a3b3e;--floor:#212327;
--tall:#9aa1ab;--over:#4a6a9c;--low:#b08e1e;--new:#ff8c42;--stand:#4dabf7;--lie:#69db7c;--beam:#f783ac;--seen:#ffc078;
--true:#f1f3f5;--bad:#ff8787}}
*{box-sizing:border-box}body{font:15px/1.45 system-ui,sans-serif;margin:0 auto;padding:1rem 1.25rem;max-width:1500px;
background:var(--page);color:var(--ink)}h1{font-size:1.25rem;margin:0}p{margin:.15rem 0 .8rem;color:var(--dim)}
#above{display:flex;gap:1.25rem;flex-wrap:wrap}#room{flex:3 1 520px;min-width:0}#side{flex:1 1 220px}
canvas{display:block;width:100%;border:1px solid var(--line);border-radius:4px;background:var(--floor)}
dl{display:grid;grid-template-columns:auto 1fr;gap:.1rem .8rem;margin:0 0 1rem}dt{color:var(--dim)}
dd{margin:0;font-variant-numeric:tabular-nums}#state{font-size:1.3rem;font-weight:600}
#bar{display:flex;gap:.8rem;align-items:center;margin:.8rem 0}#bar input{flex:1}button,select{font:inherit;
color:inherit;background:var(--floor);border:1px solid var(--line);border-radius:4px;padding:.2rem .7rem}
.key{display:flex;align-items:center;gap:.5rem;font-size:.87rem;color:var(--dim)}
.key i{width:1.5rem;height:.7rem;border-radius:2px;flex:none}
)css";

constexpr const char* kBody = R"html(
<div id="above"><div id="room"><canvas id="world"></canvas></div><div id="side">
<div id="state"></div><dl id="facts"></dl><div id="legend"></div></div></div>
<div id="bar"><button id="play">play</button><input id="when" type="range" min="0" step="1" value="0"
aria-label="time"><span id="clock"></span><select id="speed" aria-label="speed"><option value="1">1 x</option>
<option value="4">4 x</option><option value="10" selected>10 x</option><option value="40">40 x</option></select></div>
<canvas id="plots"></canvas>
)html";

/// The data laid out for playing: columns summed up, looks and surprises by tick.
constexpr const char* kRead = R"js(
const run = JSON.parse(document.getElementById('run').textContent);
const summed = c => { let s = 0; return c.map(d => s += d); };
const columns = t => Object.fromEntries(Object.entries(t).map(([k, c]) => [k, summed(c)]));
const truth = columns(run.truth), belief = columns(run.belief);
const ticks = truth.tick.length;
// At each tick of the truth, the index of the belief, plan, look and surprises that hold then.
const lastUpTo = (when, tick) => { let i = -1; const out = tick.map(t => { while (i + 1 < when.length && when[i + 1] <= t) ++i; return i; }); return out; };
const beliefAt = lastUpTo(belief.tick, truth.tick);
const planAt = lastUpTo(run.plans.map(p => p.tick), truth.tick);
const lookAt = lastUpTo(run.looks.map(l => l[0]), truth.tick);
const seenAt = lastUpTo(run.surprises.map(s => s.tick), truth.tick);
const seconds = i => run.tick_s * (truth.tick[i] - truth.tick[0]);
const digits = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
const ranges = text => { const out = []; for (let i = 0; i + 1 < text.length; i += 2) {
  const cm = 64 * digits.indexOf(text[i]) + digits.indexOf(text[i + 1]); out.push(cm === 4095 ? Infinity : 10 * cm); } return out; };
const bodyAt = (mode, x, y, yaw) => { const [a, b, c, d] = run.modes[mode].body, s = Math.sin(yaw / 1000), k = Math.cos(yaw / 1000);
  return [[b, d], [a, d], [a, c], [b, c]].map(([u, v]) => [x + k * u - s * v, y + s * u + k * v]); };
)js";

/// The world from above.
constexpr const char* kWorld = R"js(
const $ = id => document.getElementById(id);
const ink = name => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
const fit = (canvas, width, height) => { const r = window.devicePixelRatio || 1; canvas.width = width * r; canvas.height = height * r;
  canvas.style.height = height + 'px'; const g = canvas.getContext('2d'); g.setTransform(r, 0, 0, r, 0, 0); g.lineJoin = g.lineCap = 'round'; return g; };
const xs = run.bounds.map(p => p[0]), ys = run.bounds.map(p => p[1]);
const left = Math.min(...xs), right = Math.max(...xs), low = Math.min(...ys), high = Math.max(...ys);
let g, scale, X, Y, wide, tall;
function layWorld() {
  const room = $('room').clientWidth, edge = 14;
  scale = Math.min((room - 2 * edge) / (right - left), 640 / (high - low)); wide = room; tall = (high - low) * scale + 2 * edge;
  g = fit($('world'), wide, tall);
  const off = (wide - (right - left) * scale) / 2;
  X = x => off + (x - left) * scale; Y = y => tall - edge - (y - low) * scale;
}
function path(points, closed) { g.beginPath(); points.forEach((p, i) => i ? g.lineTo(X(p[0]), Y(p[1])) : g.moveTo(X(p[0]), Y(p[1]))); if (closed) g.closePath(); }
function area(points, fill, stroke, width, dash) { path(points, true);
  if (fill) { g.fillStyle = fill; g.fill(); } if (stroke) { g.strokeStyle = stroke; g.lineWidth = width || 1; g.setLineDash(dash || []); g.stroke(); g.setLineDash([]); } }
function line(points, stroke, width, dash) { path(points, false); g.strokeStyle = stroke; g.lineWidth = width; g.setLineDash(dash || []); g.stroke(); g.setLineDash([]); }
function dot(p, radius, fill) { g.beginPath(); g.arc(X(p[0]), Y(p[1]), radius, 0, 2 * Math.PI); g.fillStyle = fill; g.fill(); }
function arrow(p, yaw, length, colour) { const c = Math.cos(yaw / 1000), s = Math.sin(yaw / 1000), tip = [p[0] + length * c, p[1] + length * s];
  line([p, tip], colour, 2); line([-2.6, 2.6].map(a => [tip[0] + .35 * length * Math.cos(yaw / 1000 + a), tip[1] + .35 * length * Math.sin(yaw / 1000 + a)]).flatMap((q, i) => i ? [q] : [q, tip]), colour, 2); }
function drawObstacles() {
  for (const o of run.obstacles) { const colour = ink(o.unmapped ? 'new' : o.kind);
    g.globalAlpha = o.kind === 'over' ? .35 : o.kind === 'low' ? .65 : .9; area(o.outline, colour);
    g.globalAlpha = 1; area(o.outline, null, colour, 1.2, o.kind === 'over' ? [6, 4] : null); }
}
function drawPlan(plan, alpha, done) {
  g.globalAlpha = alpha;
  plan.segments.forEach((s, k) => { const colour = ink(run.modes[s.to_mode].low || run.modes[s.mode].low ? 'lie' : 'stand');
    if (s.kind === 1) dot(s.from, 3, colour); else line([s.from, s.to], colour, s.kind === 2 ? 6 : k < done ? 1.5 : 3); });
  g.globalAlpha = 1;
}
function drawLook(i) {
  const b = beliefAt[i], l = lookAt[i]; if (b < 0 || l < 0 || truth.tick[i] - run.looks[l][0] > 10) return;
  const yaw = belief.yaw[b] / 1000, step = run.beams.step_rad * run.beams.each, first = run.beams.first_rad + step / 2 - run.beams.step_rad / 2;
  g.fillStyle = ink('beam');
  ranges(run.looks[l][1]).forEach((r, k) => { if (!isFinite(r)) return; const a = yaw + first + k * step;
    g.fillRect(X(belief.x[b] + r * Math.cos(a)) - 1.2, Y(belief.y[b] + r * Math.sin(a)) - 1.2, 2.4, 2.4); });
}
function drawSeen(i) {
  if (seenAt[i] < 0) return; g.fillStyle = ink('seen'); g.globalAlpha = .75; const half = Math.max(2, 25 * scale);
  for (const [x, y] of run.surprises[seenAt[i]].cells) g.fillRect(X(x) - half, Y(y) - half, 2 * half, 2 * half);
  g.globalAlpha = 1;
}
function drawRobot(i) {
  const mode = truth.mode[i], colour = ink(run.modes[mode].low ? 'lie' : 'stand'), at = [truth.x[i], truth.y[i]];
  const trail = []; for (let k = 0; k <= i; k += 2) trail.push([truth.x[k], truth.y[k]]); trail.push(at);
  line(trail, ink('true'), 1.2);
  const body = bodyAt(mode, truth.x[i], truth.y[i], truth.yaw[i]);
  g.globalAlpha = .55; area(body, colour); g.globalAlpha = 1; area(body, null, ink('true'), 1.5);
  arrow(at, truth.yaw[i], 220, ink('true'));
  const b = beliefAt[i]; if (b >= 0) area(bodyAt(mode, belief.x[b], belief.y[b], belief.yaw[b]), null, ink('dim'), 1.4, [4, 3]);
}
function drawWorld(i) {
  g.clearRect(0, 0, wide, tall); area(run.bounds, null, ink('line'), 1.5);
  drawObstacles();
  for (let k = 0; k < planAt[i]; ++k) drawPlan(run.plans[k], .22, 0);
  if (planAt[i] >= 0) drawPlan(run.plans[planAt[i]], .85, beliefAt[i] < 0 ? 0 : belief.segment[beliefAt[i]]);
  for (const [x, y, yaw] of run.goals) { dot([x, y], 5, ink('true')); if (yaw !== null) arrow([x, y], yaw, 260, ink('true')); }
  drawSeen(i); drawLook(i); drawRobot(i);
}
)js";

/// Clearance and speed over time, under a band of the states.
constexpr const char* kPlots = R"js(
const stateColours = {idle: 'line', settling: 'line', walking: 'stand', aligning: 'low', 'going down': 'lie', crawling: 'lie',
  'getting up': 'lie', arrived: 'true', blocked: 'new', lost: 'bad', fallen: 'bad', stalled: 'bad'};
let h, plotWide; const plotTall = 260, from = 78, last = Math.max(seconds(ticks - 1), .1);
const T = s => from + s / last * (plotWide - from - 14);
function axis(top, bottom, most, unit, title) {
  h.font = '12px system-ui, sans-serif'; h.textAlign = 'right'; h.fillStyle = ink('dim'); h.strokeStyle = ink('line'); h.lineWidth = 1;
  for (const share of [0, .5, 1]) { const y = bottom - share * (bottom - top);
    h.beginPath(); h.moveTo(from, y); h.lineTo(plotWide - 14, y); h.stroke(); h.fillText(+(share * most).toPrecision(3) + ' ' + unit, from - 6, y + 4); }
  h.fillText(title, plotWide - 14, top - 5);
}
function curve(values, top, bottom, most, colour) {
  h.strokeStyle = colour; h.lineWidth = 1.5; h.beginPath();
  values.forEach((v, i) => { const x = T(seconds(i)), y = bottom - Math.min(v / most, 1) * (bottom - top); i ? h.lineTo(x, y) : h.moveTo(x, y); }); h.stroke();
}
const speeds = truth.speed.map((_, i) => { let sum = 0, n = 0; for (let k = Math.max(0, i - 4); k <= Math.min(ticks - 1, i + 4); ++k, ++n) sum += truth.speed[k]; return sum / n / 1000; });
const clearances = truth.clearance.map(c => c / 1000);
const nice = v => { const p = Math.pow(10, Math.floor(Math.log10(v))); return [1, 2, 5, 10].map(f => f * p).find(f => f >= v); };
function drawPlots(i) {
  h.clearRect(0, 0, plotWide, plotTall);
  for (let k = 0; k < ticks;) { let e = k; const s = beliefAt[k] < 0 ? 0 : belief.state[beliefAt[k]];
    while (e < ticks && (beliefAt[e] < 0 ? 0 : belief.state[beliefAt[e]]) === s) ++e;
    h.fillStyle = ink(stateColours[run.states[s]] || 'line'); h.fillRect(T(seconds(k)), 6, Math.max(1, T(seconds(Math.min(e, ticks - 1))) - T(seconds(k))), 8); k = e; }
  const c = .5, v = nice(speeds.reduce((a, b) => Math.max(a, b), .02));
  axis(38, 128, c, 'm', 'true clearance, up to 0.5 m'); axis(158, 236, v, 'm/s', 'true speed');
  curve(clearances, 38, 128, c, ink('stand')); curve(speeds, 158, 236, v, ink('lie'));
  h.fillStyle = ink('dim'); h.textAlign = 'center';
  const step = [1, 2, 5, 10, 20, 30, 60, 120, 300, 600].find(s => last / s <= 12) || 1200;
  for (let s = 0; s <= last; s += step) h.fillText(s + ' s', T(s), 253);
  h.textAlign = 'left'; let told = -Infinity;
  run.plans.forEach((p, k) => { const x = T(run.tick_s * (p.tick - truth.tick[0])); h.strokeStyle = ink('dim'); h.lineWidth = 1; h.setLineDash([3, 3]);
    h.beginPath(); h.moveTo(x, 18); h.lineTo(x, 236); h.stroke(); h.setLineDash([]);
    if (k > 0 && x > told + 46) { h.fillText('plan ' + (k + 1), x + 4, 148); told = x; } });
  h.strokeStyle = ink('bad'); h.lineWidth = 1.5; h.beginPath(); h.moveTo(T(seconds(i)), 4); h.lineTo(T(seconds(i)), 238); h.stroke();
}
)js";

constexpr const char* kPlay = R"js(
let now = 0, playing = false, since = null;
function facts(i) {
  const b = beliefAt[i], plan = run.plans[planAt[i]], m = v => (v / 1000).toFixed(2) + ' m';
  $('state').textContent = b < 0 ? 'idle' : run.states[belief.state[b]];
  const off = b < 0 ? 0 : Math.hypot(truth.x[i] - belief.x[b], truth.y[i] - belief.y[b]);
  const rows = [['mode', run.modes[truth.mode[i]].name], ['segment', plan && b >= 0 ? Math.min(belief.segment[b] + 1, plan.segments.length) + ' of ' + plan.segments.length : '-'],
    ['plan', plan ? planAt[i] + 1 + ' of ' + run.plans.length + ', ' + m(plan.length) : '-'], ['clearance', (truth.clearance[i] / 1000).toFixed(3) + ' m'],
    ['speed', speeds[i].toFixed(3) + ' m/s'], ['belief is off by', (off / 10).toFixed(1) + ' cm']];
  $('facts').replaceChildren(...rows.flatMap(([k, v]) => { const t = document.createElement('dt'), d = document.createElement('dd'); t.textContent = k; d.textContent = v; return [t, d]; }));
  $('clock').textContent = seconds(i).toFixed(1) + ' s';
}
function show(i) { now = Math.max(0, Math.min(ticks - 1, i)); $('when').value = now; drawWorld(now); drawPlots(now); facts(now); }
function lay() { layWorld(); plotWide = document.body.clientWidth - 40; h = fit($('plots'), plotWide, plotTall); show(now); }
function setPlaying(is) { playing = is; since = null; $('play').textContent = is ? 'pause' : 'play'; if (is) { if (now >= ticks - 1) now = 0; requestAnimationFrame(step); } }
function step(t) { if (!playing) return; if (since === null) since = t - 1000 * seconds(now) / $('speed').value;
  const s = (t - since) / 1000 * $('speed').value; let i = now; while (i < ticks - 1 && seconds(i) < s) ++i;
  show(i); if (i >= ticks - 1) setPlaying(false); else requestAnimationFrame(step); }
$('legend').replaceChildren(...[['tall', 'blocks every mode'], ['over', 'hangs over: lying goes below'], ['low', 'below the lidar'],
  ['new', 'not in the map'], ['seen', 'seen, not in the map'], ['beam', 'lidar'], ['stand', 'standing; its plan'], ['lie', 'lying; its plan'], ['true', 'true way'], ['dim', 'believed body (dashed)']]
  .map(([colour, text]) => { const key = document.createElement('div'), box = document.createElement('i'); key.className = 'key'; box.style.background = 'var(--' + colour + ')'; key.append(box, text); return key; }));
$('when').max = ticks - 1; $('when').oninput = () => { setPlaying(false); show(+$('when').value); };
$('play').onclick = () => setPlaying(!playing); $('speed').onchange = () => { since = null; };
$('plots').onclick = e => { const s = (e.offsetX - from) / (plotWide - from - 14) * last; setPlaying(false); show(truth.tick.filter((_, i) => seconds(i) < s).length); };
addEventListener('keydown', e => { if (e.target.tagName === 'SELECT') return;
  if (e.key === ' ') { e.preventDefault(); setPlaying(!playing); } else if (e.key === 'ArrowRight') show(now + 10); else if (e.key === 'ArrowLeft') show(now - 10); });
addEventListener('resize', lay); matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => show(now));
lay();
)js";

/// A text in a script element must not end it.
std::string inScript(std::string text) {
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
    text.replace(at, 2, "<\\/");
  return text;
}

}  // namespace

std::string replayPage(const Replay& replay) {
  const std::string title = svgText(replay.title);
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n";
  page.append("<meta name=\"viewport\" content=\"width=device-width\">\n<title>").append(title);
  page.append("</title><style>").append(kStyle).append("</style></head><body>\n<h1>").append(title);
  page.append("</h1><p>").append(svgText(replay.outcome)).append("</p>").append(kBody);
  page.append("<script type=\"application/json\" id=\"run\">").append(inScript(replayData(replay)));
  page.append("</script>\n<script>").append(kRead).append(kWorld).append(kPlots).append(kPlay);
  return page.append("</script></body></html>\n");
}

}  // namespace underway
