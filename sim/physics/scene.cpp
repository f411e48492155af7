#include "sim/physics/scene.hpp"

#include <mujoco/mujoco.h>
#include <spdlog/fmt/fmt.h>

#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "geometry/read/bytes.hpp"

namespace underway::physics {
namespace {

constexpr const char* kRobotName = "robot.xml";
constexpr const char* kSceneName = "scene.xml";
constexpr std::size_t kMostBytes = 1 << 20;

std::string obstacleText(const OrientedBox& box, std::size_t number, double friction) {
  return fmt::format(R"(<geom name="obstacle {}" type="box" pos="{} {} {}" size="{} {} {}" euler="{} {} {}")",
                     number, box.center_m.x, box.center_m.y, box.center_m.z, 0.5 * box.size_m.x,
                     0.5 * box.size_m.y, 0.5 * box.size_m.z, box.rpy_rad.x, box.rpy_rad.y, box.rpy_rad.z) +
         fmt::format(R"( priority="1" friction="{}" rgba="0.6 0.5 0.4 1"/>)", friction);
}

/// Gravity as the ground's frame sees it.
std::array<double, 3> gravity(const Ground& ground) {
  constexpr double kGravity_mps2 = 9.81;
  const double x = -std::sin(ground.uphill_rad);
  const double y = -std::sin(ground.leftward_rad);
  return {kGravity_mps2 * x, kGravity_mps2 * y, -kGravity_mps2 * std::sqrt(1.0 - x * x - y * y)};
}

/// What belongs to the scene has priority: its friction is the contact's.
std::string sceneText(const Scene& scene, double friction) {
  const auto [x, y, z] = gravity(scene.ground);
  std::string obstacles;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    obstacles += obstacleText(scene.obstacles[i], i, friction);
  return fmt::format(
      R"(<mujoco><include file="{}"/><compiler eulerseq="XYZ"/><option gravity="{} {} {}"/><worldbody>)"
      R"(<geom name="floor" type="plane" size="0 0 1" priority="1" friction="{}"/>{}</worldbody></mujoco>)",
      kRobotName, x, y, z, friction, obstacles);
}

/// MuJoCo's files in memory.
class Files {
 public:
  Files() : vfs_(std::make_unique<mjVFS>()) { mj_defaultVFS(vfs_.get()); }
  ~Files() { mj_deleteVFS(vfs_.get()); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  void add(const char* name, const std::string& text) {
    mj_makeEmptyFileVFS(vfs_.get(), name, static_cast<int>(text.size()));
    std::memcpy(vfs_->filedata[mj_findFileVFS(vfs_.get(), name)], text.data(), text.size());
  }
  [[nodiscard]] const mjVFS* get() const { return vfs_.get(); }

 private:
  std::unique_ptr<mjVFS> vfs_;
};

}  // namespace

void ModelDeleter::operator()(mjModel* model) const { mj_deleteModel(model); }
void DataDeleter::operator()(mjData* data) const { mj_deleteData(data); }

Expected<Model> makeModel(const std::filesystem::path& robot, const Scene& scene, double friction) {
  const auto text = readBytes(robot, kMostBytes, ErrorCode::kInvalidRobot);
  if (!text) return tl::unexpected(text.error());
  mju_user_warning = [](const char*) {};  // counted in mjData; never printed
  Files files;
  files.add(kRobotName, *text);
  files.add(kSceneName, sceneText(scene, friction));
  std::array<char, 500> complaint{};
  Model model(mj_loadXML(kSceneName, files.get(), complaint.data(), static_cast<int>(complaint.size())));
  if (!model)
    return fail(ErrorCode::kInvalidRobot,
                fmt::format("{}: MuJoCo cannot make a model of it ({}); correct the file", robot.string(),
                            complaint.data()));
  return model;
}

}  // namespace underway::physics
