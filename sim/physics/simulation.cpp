#include "sim/physics/simulation.hpp"

#include <mujoco/mujoco.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>

#include "sim/physics/shapes.hpp"

namespace underway::physics {
namespace {

constexpr int kStepsPerSample = 5;
constexpr double kRest_s = 1.0;
constexpr std::array kNeeded{"LAnkleRoll", "RAnkleRoll", "LHipPitch", "RHipPitch"};

std::string nameOf(const mjModel& model, mjtObj kind, int id) {
  const char* name = mj_id2name(&model, kind, id);
  return name ? name : "";
}

/// Where a joint turns, in the frame of the ground.
const double* anchor(const mjModel& model, const mjData& data, const char* joint) {
  return data.xanchor + 3 * mj_name2id(&model, mjOBJ_JOINT, joint);
}

Pose below(const mjModel& model, const mjData& data, const char* left, const char* right, double yaw) {
  const double* l = anchor(model, data, left);
  const double* r = anchor(model, data, right);
  return {0.5 * (l[0] + r[0]), 0.5 * (l[1] + r[1]), yaw};
}

/// The torso's frame: x out of the chest, y left, z towards the head.
const double* torsoAxes(const mjModel& model, const mjData& data) {
  return data.xmat + 9 * mj_name2id(&model, mjOBJ_BODY, "torso");
}

/// Also face down, where the chest points nowhere: from the left side.
double heading(const double* axes) { return std::atan2(-axes[1], axes[4]); }

/// The speed at which a shape slides where it touches.
double slidingSpeed(const mjModel& model, const mjData& data, const mjContact& contact, int geom) {
  double velocity[6];
  mj_objectVelocity(&model, &data, mjOBJ_GEOM, geom, velocity, 0);
  double arm[3];
  double turning[3];
  mju_sub3(arm, contact.pos, data.geom_xpos + 3 * geom);
  mju_cross(turning, velocity, arm);
  mju_addTo3(turning, velocity + 3);
  const double normal = mju_dot3(turning, contact.frame);
  return std::sqrt(std::max(0.0, mju_dot3(turning, turning) - normal * normal));
}

/// MuJoCo starts anew, without a word, when numbers run away.
bool hasDiverged(const mjData& data) {
  return data.warning[mjWARN_BADQPOS].number + data.warning[mjWARN_BADQVEL].number +
             data.warning[mjWARN_BADQACC].number >
         0;
}

}  // namespace

Expected<Simulation> Simulation::make(const std::filesystem::path& robot, const Scene& scene,
                                      const Conditions& conditions) {
  auto model = makeModel(robot, scene, conditions.friction);
  if (!model) return tl::unexpected(model.error());
  for (const char* joint : kNeeded)
    if (mj_name2id(model->get(), mjOBJ_JOINT, joint) < 0)
      return fail(ErrorCode::kInvalidRobot,
                  fmt::format("{}: no joint {}; a robot to be measured needs it", robot.string(), joint));
  Data data(mj_makeData(model->get()));
  return Simulation(std::move(*model), std::move(data), conditions);
}

Simulation::Simulation(Model model, Data data, const Conditions& conditions)
    : model_(std::move(model)),
      data_(std::move(data)),
      conditions_(conditions),
      targets_rad_(model_->nu, 0.0) {
  std::mt19937_64 random(conditions.seed);
  std::uniform_real_distribution<double> off(-conditions.servo_error_rad, conditions.servo_error_rad);
  for (int servo = 0; servo < model_->nu; ++servo) servo_errors_rad_.push_back(off(random));
  imu_drift_radps_ =
      std::uniform_real_distribution<double>(-conditions.imu_drift_radps, conditions.imu_drift_radps)(random);
}

std::vector<int> Simulation::servosOf(const gait::JointTable& table) const {
  std::vector<int> servos;
  for (const std::string& joint : table.joints()) {
    // Both hips' yaw-pitch is one motor, which the left one's name stands for.
    const char* name = joint == "RHipYawPitch" ? "LHipYawPitch" : joint.c_str();
    servos.push_back(mj_name2id(model_.get(), mjOBJ_ACTUATOR, name));
    if (servos.back() < 0) throw std::invalid_argument("the robot has no joint " + joint + " to play");
  }
  return servos;
}

void Simulation::aim(const gait::JointTable& table, double time_s, std::span<const int> servos) {
  const std::vector<double> wanted = table.sample(time_s);
  for (std::size_t i = 0; i < servos.size(); ++i) {
    const double most = model_->actuator_user[servos[i] * model_->nuser_actuator] * model_->opt.timestep;
    double& target = targets_rad_[servos[i]];
    target += std::clamp(wanted[i] - target, -most, most);
  }
  for (int servo = 0; servo < model_->nu; ++servo)
    data_->ctrl[servo] = targets_rad_[servo] + servo_errors_rad_[servo];
}

void Simulation::start(const gait::JointTable& table, Posture posture, const Pose& pose) {
  std::mt19937_64 random(conditions_.seed + 1);
  const auto off = [&](double most) { return std::uniform_real_distribution<double>(-most, most)(random); };
  const double yaw = pose.yaw + off(conditions_.start_error_rad);
  const double pitch = posture == Posture::kLying ? 0.5 * std::numbers::pi : 0.0;
  mj_resetData(model_.get(), data_.get());
  std::ranges::fill(targets_rad_, 0.0);
  const auto servos = servosOf(table);
  const auto angles = table.angles(0);
  for (std::size_t i = 0; i < servos.size(); ++i) {
    targets_rad_[servos[i]] = angles[i];
    data_->qpos[model_->jnt_qposadr[mj_name2id(model_.get(), mjOBJ_JOINT, table.joints()[i].c_str())]] =
        angles[i];
  }
  const double turn[4] = {std::cos(0.5 * yaw), 0.0, 0.0, std::sin(0.5 * yaw)};
  const double lean[4] = {std::cos(0.5 * pitch), 0.0, std::sin(0.5 * pitch), 0.0};
  mju_mulQuat(data_->qpos + 3, turn, lean);
  mj_kinematics(model_.get(), data_.get());
  const Pose at = frame(posture);
  data_->qpos[0] += pose.x + off(conditions_.start_error_m) - at.x;
  data_->qpos[1] += pose.y + off(conditions_.start_error_m) - at.y;
  data_->qpos[2] -= enclose(*model_, *data_, {}).z.min;
  hold(kRest_s, posture);
  imu_zero_rad_ += imuHeading();
}

void Simulation::carry(const Pose& by) {
  mj_forward(model_.get(), data_.get());
  const Pose from = frame(Posture::kStanding);
  const Pose root = compose(compose(from, by), relative(from, {data_->qpos[0], data_->qpos[1], 0.0}));
  data_->qpos[0] = root.x;
  data_->qpos[1] = root.y;
  const double turn[4] = {std::cos(0.5 * by.yaw), 0.0, 0.0, std::sin(0.5 * by.yaw)};
  double turned[4];
  mju_mulQuat(turned, turn, data_->qpos + 3);
  std::copy_n(turned, 4, data_->qpos + 3);
}

Recording Simulation::play(const gait::JointTable& table, Posture frame_of) {
  mj_forward(model_.get(), data_.get());
  return play(table, frame(frame_of));
}

Recording Simulation::play(const gait::JointTable& table, const Pose& frame) {
  mj_forward(model_.get(), data_.get());
  Recording recording;
  recording.frame = frame;
  const auto servos = servosOf(table);
  const auto steps = std::lround(table.duration() / model_->opt.timestep);
  recording.samples.push_back(sample(recording.frame));
  for (long done = 0; done < steps; ++done) {
    aim(table, table.time(0) + static_cast<double>(done + 1) * model_->opt.timestep, servos);
    step(recording);
    if ((done + 1) % kStepsPerSample != 0 && done + 1 != steps) continue;
    recording.samples.push_back(sample(recording.frame));
    recording.samples.back().time_s = recording.duration_s;
  }
  if (hasDiverged(*data_)) throw std::runtime_error("physics diverged: what MuJoCo computed is void");
  return recording;
}

Recording Simulation::hold(double seconds, Posture frame_of) {
  gait::JointTable nothing({});
  nothing.append(0.0, {});
  nothing.append(seconds, {});
  return play(nothing, frame_of);
}

void Simulation::step(Recording& recording) {
  mj_step(model_.get(), data_.get());
  const double dt = model_->opt.timestep;
  recording.duration_s += dt;
  for (int servo = 0; servo < model_->nu; ++servo) {
    const double torque = data_->actuator_force[servo];
    Effort& effort = recording.efforts[nameOf(*model_, mjOBJ_ACTUATOR, servo)];
    effort.square_nm2s += torque * torque * dt;
    effort.peak_nm = std::max(effort.peak_nm, std::abs(torque));
    if (std::abs(torque) >= 0.999 * model_->actuator_forcerange[2 * servo + 1]) effort.saturated_s += dt;
  }
  recordContacts(recording);
}

void Simulation::recordContacts(Recording& recording) const {
  constexpr double kBears_n = 1.0;
  std::map<int, double> sliding_mps;  // by shape: a capsule may touch in two points, a box in four
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    if (contact.exclude != 0 || contact.efc_address < 0) continue;
    const auto isWorlds = [&](int geom) { return model_->geom_bodyid[geom] == 0; };
    const int other = isWorlds(contact.geom1) ? contact.geom1 : contact.geom2;
    const int shape = isWorlds(contact.geom1) ? contact.geom2 : contact.geom1;
    const std::string met = nameOf(*model_, mjOBJ_GEOM, other);
    const auto touch = [&] { return nameOf(*model_, mjOBJ_GEOM, shape) + " on " + met; };
    if (!isWorlds(other)) recording.self_touches.insert(touch());
    if (isWorlds(other) && met != "floor") recording.touches.insert(touch());
    double force[6];
    mj_contactForce(model_.get(), data_.get(), i, force);
    if (met == "floor" && force[0] > kBears_n)
      sliding_mps[shape] = std::max(sliding_mps[shape], slidingSpeed(*model_, *data_, contact, shape));
  }
  for (const auto& [shape, speed] : sliding_mps)
    recording.slips_m[nameOf(*model_, mjOBJ_GEOM, shape)] += speed * model_->opt.timestep;
}

Pose Simulation::frame(Posture posture) const {
  const double yaw = heading(torsoAxes(*model_, *data_));
  return posture == Posture::kLying ? below(*model_, *data_, "LHipPitch", "RHipPitch", yaw)
                                    : below(*model_, *data_, "LAnkleRoll", "RAnkleRoll", yaw);
}

Sample Simulation::sample(const Pose& frame_of_boxes) const {
  const double* axes = torsoAxes(*model_, *data_);
  return {.standing = frame(Posture::kStanding),
          .lying = frame(Posture::kLying),
          .pitch_rad = std::atan2(std::hypot(axes[2], axes[5]), axes[8]),
          .roll_rad = std::asin(std::clamp(axes[7], -1.0, 1.0)),
          .hip_height_m = anchor(*model_, *data_, "LHipPitch")[2],
          .box = enclose(*model_, *data_, frame_of_boxes),
          .positions = {data_->qpos, data_->qpos + model_->nq},
          .torques_nm = {data_->actuator_force, data_->actuator_force + model_->nu}};
}

double Simulation::angle(const std::string& joint) const {
  const int id = mj_name2id(model_.get(), mjOBJ_JOINT, joint.c_str());
  if (id < 0) throw std::invalid_argument("the robot has no joint " + joint);
  return data_->qpos[model_->jnt_qposadr[id]];
}

double Simulation::imuHeading() const {
  const double true_rad = heading(torsoAxes(*model_, *data_));
  return normalizedAngle(true_rad + imu_drift_radps_ * data_->time - imu_zero_rad_);
}

Sample Simulation::now() const { return sample({}); }

}  // namespace underway::physics
