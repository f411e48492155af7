#include "bench/local_run.hpp"

namespace underway::bench {

PureRun drivePurely(const PureRoom& room, const std::shared_ptr<const Robot>& robot, PureSettings settings,
                    std::uint64_t seed, double limit_s, const Watch& watch) {
  sim::SimulatedRobot body(room.world, robot, room.start, 0, seed);
  settings.seed = seed;
  Godzila godzila(settings, robot->modes.front().body_m, standingLimits(*robot), Beams{});
  PureRun run;
  while (body.now_s() < limit_s && !run.has_arrived && !run.has_collided) {
    const Senses& senses = body.sense();
    const auto drive = godzila.tick(*senses.scan, bearingOf(room.goal, senses.pose->pose));
    body.step({drive.velocity, std::nullopt});
    run.has_collided = body.truth().has_collided;
    run.is_disputed = body.truth().is_disputed;
    // Its own word, and true: noise may tell it so a little early.
    run.has_arrived = drive.state == Godzila::State::kArrived;
    if (watch) watch(body, drive.state);
  }
  run.has_arrived = run.has_arrived && distance(body.truth().pose.position(), room.goal) <
                                           settings.godzila.goal_stopping_radius_m + 0.05;
  run.time_s = body.now_s();
  run.traps = godzila.traps();
  return run;
}

}  // namespace underway::bench
