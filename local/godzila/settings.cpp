#include "local/godzila/settings.hpp"

namespace underway {

GodzilaSettings table7() {
  GodzilaSettings settings;
  settings.goal_stopping_radius_m = 0.3;
  settings.least_speed = -0.4;
  settings.most_speed = 0.4;
  settings.least_turn = -0.2;
  settings.most_turn = 0.2;
  settings.clearance_threshold_m = 0.3;
  settings.obstacle_threshold_m = 3.0;
  settings.goal_attraction = 100.0;
  settings.obstacle_repulsion = 20.0;
  settings.obstacle_attraction = 0.0;
  settings.bearing_ratio = 1.0;
  settings.inertia = 15.0;
  settings.velocity_gain = 5.0;
  settings.forward_repulsion = 5.0;
  settings.turn_braking = 3.0;
  settings.bearing_width_rad = 0.05;
  return settings;
}

GodzilaSettings tuned() { return {}; }

}  // namespace underway
