#include "sim/physics/picture.hpp"

#include <mujoco/mujoco.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

namespace underway::physics {
namespace {

constexpr double kPxPerM = 500.0;
constexpr double kMargin_m = 0.05;
constexpr double kLabel_px = 16.0;

/// What all pictures show, along x and z [m].
struct Window {
  Range x;
  double height_m = 0.0;
  [[nodiscard]] double rowHeight() const { return (height_m + kMargin_m) * kPxPerM + kLabel_px; }
  [[nodiscard]] double px(double at_m) const { return (at_m - x.min) * kPxPerM; }
  [[nodiscard]] double pz(double at_m) const { return kLabel_px + (height_m - at_m) * kPxPerM; }
};

Window windowOf(std::span<const Sample> samples, const mjModel& model, const mjData& data) {
  Window window{samples.front().box.x, 0.0};
  for (const Sample& sample : samples) {
    const double back = std::min(sample.standing.x, sample.lying.x) - 0.35;
    const double front = std::max(sample.standing.x, sample.lying.x) + 0.45;
    window.x = hull(window.x, {back, front});
    window.height_m = std::max(window.height_m, sample.box.z.max + kMargin_m);
  }
  for (int geom = 0; geom < model.ngeom; ++geom)
    if (model.geom_bodyid[geom] == 0 && model.geom_type[geom] == mjGEOM_BOX)
      window.height_m =
          std::max(window.height_m, data.geom_xpos[3 * geom + 2] + model.geom_size[3 * geom + 2]);
  return window;
}

/// The outline of a box seen along y: its corners' hull is drawn as all of its edges.
std::string boxPath(const mjModel& model, const mjData& data, int geom, const Window& window) {
  std::string path;
  const auto corner = [&](int signs) {
    double local[3];
    for (int axis = 0; axis < 3; ++axis)
      local[axis] = ((signs >> axis) & 1 ? 1.0 : -1.0) * model.geom_size[3 * geom + axis];
    double p[3];
    mju_rotVecMat(p, local, data.geom_xmat + 9 * geom);
    mju_addTo3(p, data.geom_xpos + 3 * geom);
    return fmt::format("{:.1f} {:.1f}", window.px(p[0]), window.pz(p[2]));
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int signs = 0; signs < 8; ++signs)
      if (!((signs >> axis) & 1)) path += fmt::format("M{}L{}", corner(signs), corner(signs | (1 << axis)));
  return fmt::format(R"(<path d="{}" class="box"/>)", path);
}

std::string shapeElement(const mjModel& model, const mjData& data, int geom, const Window& window) {
  if (model.geom_type[geom] == mjGEOM_PLANE) return {};
  if (model.geom_type[geom] == mjGEOM_BOX) return boxPath(model, data, geom, window);
  const double* p = data.geom_xpos + 3 * geom;
  const double* axes = data.geom_xmat + 9 * geom;
  const double half = model.geom_type[geom] == mjGEOM_CAPSULE ? model.geom_size[3 * geom + 1] : 0.0;
  return fmt::format(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke-width="{:.1f}" class="{}"/>)",
                     window.px(p[0] - half * axes[2]), window.pz(p[2] - half * axes[8]),
                     window.px(p[0] + half * axes[2]) + 0.01, window.pz(p[2] + half * axes[8]),
                     2.0 * model.geom_size[3 * geom] * kPxPerM, p[1] > 0.0 ? "far" : "near");
}

std::string rowElement(const mjModel& model, const mjData& data, const Sample& sample, const Window& window) {
  std::string row;
  for (double x = std::ceil(window.x.min * 10.0) / 10.0; x < window.x.max; x += 0.1)
    row += fmt::format(R"(<path d="M{0:.1f} {1:.1f}V{2:.1f}" class="grid"/>)", window.px(x), window.pz(0.0),
                       window.pz(window.height_m));
  for (double z = 0.1; z < window.height_m; z += 0.1)
    row += fmt::format(R"(<path d="M0 {:.1f}H{:.1f}" class="grid"/>)", window.pz(z), window.px(window.x.max));
  row +=
      fmt::format(R"(<path d="M0 {:.1f}H{:.1f}" stroke="black"/>)", window.pz(0.0), window.px(window.x.max));
  for (int geom = 0; geom < model.ngeom; ++geom) row += shapeElement(model, data, geom, window);
  return row + fmt::format(R"(<text x="4" y="12">{:.2f} s, highest {:.0f} mm, torso {:.0f} deg</text>)",
                           sample.time_s, 1000.0 * sample.box.z.max, sample.pitch_rad * 180.0 / mjPI);
}

}  // namespace

std::vector<Sample> spread(const Recording& recording, std::size_t count) {
  std::vector<Sample> some;
  for (std::size_t i = 0; i < count; ++i)
    some.push_back(
        recording.samples.at(i * (recording.samples.size() - 1) / std::max<std::size_t>(1, count - 1)));
  return some;
}

std::string drawSide(const mjModel_& model, std::span<const Sample> samples) {
  if (samples.empty()) return "<svg xmlns=\"http://www.w3.org/2000/svg\"/>";
  const Data data(mj_makeData(&model));
  mj_kinematics(&model, data.get());
  const Window window = windowOf(samples, model, *data);
  std::string rows;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    mju_copy(data->qpos, samples[i].positions.data(), model.nq);
    mj_kinematics(&model, data.get());
    rows += fmt::format(R"svg(<g transform="translate(0 {:.1f})">{}</g>)svg",
                        static_cast<double>(i) * window.rowHeight(),
                        rowElement(model, *data, samples[i], window));
  }
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{:.0f}" height="{:.0f}"><style>)"
      R"(text{{font:12px sans-serif}}.grid{{stroke:#ddd}}.near,.far{{fill:none;stroke-linecap:round;stroke-opacity:.6}})"
      R"(.near{{stroke:#2e6da4}}.far{{stroke:#9cc4e4}}.box{{stroke:#333;fill:none;stroke-opacity:.6}}</style>)"
      R"(<rect width="100%" height="100%" fill="white"/>{}</svg>)",
      window.px(window.x.max), static_cast<double>(samples.size()) * window.rowHeight(), rows);
}

}  // namespace underway::physics
