#include "local/gait_runner.hpp"

#include <utility>

namespace underway {

GaitRunner::GaitRunner(std::shared_ptr<const Robot> robot, gait::CrawlPlayer player, ModeId mode)
    : robot_(std::move(robot)), player_(std::move(player)), mode_(mode), to_(mode) {}

std::optional<gait::JointTable> GaitRunner::tick(const Command& command, double heading_rad, double tick_s) {
  if (!motion_) begin(command, heading_rad);
  if (!motion_) return std::nullopt;
  const double from = motion_->time(0) + at_s_;
  auto part = motion_->part(from, from + tick_s);
  at_s_ += tick_s;
  constexpr double kEnd_s = 1e-9;
  if (at_s_ > motion_->duration() - kEnd_s) finish();
  return part;
}

void GaitRunner::begin(const Command& command, double heading_rad) {
  at_s_ = 0.0;
  if (command.change_to && *command.change_to != mode_) return changeTo(*command.change_to, heading_rad);
  const double top = robot_->modes[mode_].speed(Sense::kForward);
  if (!isLow(*robot_, mode_) || command.velocity.x_mps <= 0.0 || top <= 0.0) return;
  motion_ = player_.cycle(heading_rad, command.velocity.x_mps / top);
}

void GaitRunner::changeTo(ModeId to, double heading_rad) {
  if (robot_->findSwitch(mode_, to) == nullptr) return;  // it cannot: nothing happens
  to_ = to;
  if (isLow(*robot_, to) == isLow(*robot_, mode_))
    mode_ = to;  // one gait of the walking engine or another
  else
    motion_ = isLow(*robot_, to) ? player_.down(heading_rad) : player_.up();
}

void GaitRunner::finish() {
  if (isSwitching())
    mode_ = to_;
  else
    ++cycles_;
  motion_.reset();
}

CrawlSettings crawlSettingsOf(const gait::CrawlPlayer& player) {
  CrawlSettings settings;
  settings.stroke_m = player.advance();
  settings.kept = 1.0;
  settings.keeps_heading = true;
  return settings;
}

}  // namespace underway
