#include "apps/stand_in.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace underway {

Expected<void> StandIn::live(const std::stop_token& stop, const Watch& watch) {
  using Seconds = std::chrono::duration<double>;
  const double tick_s = settings_.rate > 0.0 ? sim::SimulatedRobot::kTick_s / settings_.rate : 0.0;
  const auto length = std::chrono::duration_cast<Clock::duration>(Seconds(tick_s));
  Clock::time_point end_of_tick = Clock::now();
  while (!stop.stop_requested()) {
    ++tick_;
    end_of_tick = std::max(end_of_tick + length, Clock::now());
    const Senses& senses = robot_.sense();
    if (const auto told = end_->tell(tick_, senses); !told) return told;
    const auto command = settings_.is_in_step ? answerTo(senses, stop) : commandBy(end_of_tick, stop);
    if (!command) return tl::unexpected(command.error());
    if (stop.stop_requested()) break;
    robot_.step(*command);
    if (watch) watch(tick_, robot_, !settings_.is_in_step && watchdog_.isSilent(tick_));
    if (settings_.is_in_step) std::this_thread::sleep_until(end_of_tick);
  }
  return {};
}

/// Waits for the command that answers this tick; tells again what may have got lost.
Expected<Command> StandIn::answerTo(const Senses& senses, const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kAgain{50};
  while (!stop.stop_requested()) {
    const auto heard = end_->hear(Clock::now() + kAgain);
    if (!heard) return tl::unexpected(heard.error());
    if (*heard && (*heard)->tick == tick_) return (*heard)->command;
    if (!*heard)
      if (const auto told = end_->tell(tick_, senses); !told) return tl::unexpected(told.error());
  }
  return Command{};
}

/// Listens until the tick ends.
Expected<Command> StandIn::commandBy(Clock::time_point end_of_tick, const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kLook{50};  // whether to stop
  while (!stop.stop_requested() && Clock::now() < end_of_tick) {
    const auto heard = end_->hear(std::min(end_of_tick, Clock::now() + kLook));
    if (!heard) return tl::unexpected(heard.error());
    if (*heard) watchdog_.hear(tick_, (*heard)->command);
  }
  return watchdog_.at(tick_);
}

}  // namespace underway
