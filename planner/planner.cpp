#include "planner/planner.hpp"

#include <spdlog/fmt/fmt.h>

#include <atomic>
#include <mutex>
#include <optional>

#include "planner/answer.hpp"
#include "planner/grow.hpp"
#include "planner/interrupt.hpp"

namespace underway {

/// The roadmap that answers now, and the growth behind it. Whoever grows holds `growing`; whoever reads or
/// publishes the snapshot holds `published`, for no longer than a copy of the pointer takes.
struct Planner::State {
  State(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot, GrowthSettings settings)
      : checker(std::move(world), std::move(robot)), planning(checker), growth(checker, settings) {}

  [[nodiscard]] std::shared_ptr<const Roadmap> current() const {
    const std::lock_guard lock(published);
    return snapshot;
  }

  /// Publishes the roadmap as grown.
  void publish() {
    auto shared = std::make_shared<const Roadmap>(growth.freeze());
    const std::lock_guard lock(published);
    snapshot = std::move(shared);
  }

  /// Waits for its turn to grow; not owned when the deadline passes or the request is stopped first.
  [[nodiscard]] std::unique_lock<std::timed_mutex> turnToGrow(Interrupt& interrupt) {
    std::unique_lock lock(growing, std::defer_lock);
    while (!interrupt.isDueNow() && !lock.try_lock_for(kPatience)) continue;
    return lock;
  }

  /// Grows until the floor is covered or `growing_time` is due, and publishes that, unless there is a roadmap
  /// already.
  void cover(Interrupt& growing_time, Interrupt& interrupt, const Progress& progress) {
    if (current()) return;
    const auto lock = turnToGrow(interrupt);
    if (!lock || current()) return;
    const auto started = Clock::now();
    const std::uint32_t wanted = growth.batchesToCover();
    do {
      growth.addBatch();
      if (progress) progress(static_cast<double>(growth.batches()) / wanted);
    } while (growth.batches() < wanted && !growing_time.isDueNow());
    build_ms = std::chrono::duration<double, std::milli>(Clock::now() - started).count();
    publish();
  }

  /// Something better than a roadmap that was not enough: what another thread has published meanwhile, or
  /// this one grown by a fifth, or as far as it comes by the deadline.
  void growBeyond(const Roadmap& roadmap, Interrupt& interrupt) {
    const auto lock = turnToGrow(interrupt);
    if (!lock || current()->batches > roadmap.batches) return;
    const std::uint32_t wanted = growth.batches() + 1 + growth.batches() / 5;
    while (growth.batches() < wanted && !interrupt.isDueNow()) growth.addBatch();
    if (growth.batches() > roadmap.batches) publish();
  }

  static constexpr std::chrono::milliseconds kPatience{5};  // between looks at deadline and stop

  Checker checker;
  Planning planning;
  std::timed_mutex growing;
  Growth growth;
  std::atomic<double> build_ms = 0.0;
  mutable std::mutex published;
  std::shared_ptr<const Roadmap> snapshot;
};

Planner::Planner(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot,
                 GrowthSettings settings)
    : state_(std::make_unique<State>(std::move(world), std::move(robot), settings)) {}
Planner::~Planner() = default;

std::shared_ptr<const Roadmap> Planner::roadmap() const { return state_->current(); }
const Checker& Planner::checker() const { return state_->checker; }

void Planner::prepare(Clock::time_point deadline, const Progress& progress, const std::stop_token& stop) {
  Interrupt growing_time(deadline, stop);
  Interrupt interrupt(Clock::time_point::max(), stop);
  state_->cover(growing_time, interrupt, progress);
}

Expected<Plan> Planner::plan(const Request& request, Clock::time_point deadline, const std::stop_token& stop,
                             const Progress& progress) {
  if (const auto refused = refusal(state_->checker, request)) return tl::unexpected(*refused);
  const auto started = Clock::now();
  Interrupt interrupt(deadline, stop);
  // Half the time at most goes into a good roadmap; the rest is left for a query that needs more of it.
  Interrupt growing_time(started + (deadline - started) / 2, stop);
  std::optional<Error> fault;  // of a plan that failed its certificate: another roadmap may hold a better one
  std::optional<Pose> nearest;
  if (!interrupt.isDueNow()) state_->cover(growing_time, interrupt, progress);
  while (const auto roadmap = interrupt.isDueNow() ? nullptr : state_->current()) {
    auto found = answer(state_->planning, *roadmap, request, interrupt);
    if (found.plan) {
      found.plan->stats.build_ms = state_->build_ms;
      return std::move(*found.plan);
    }
    if (found.fault) fault = found.fault;
    if (found.nearest) nearest = found.nearest;
    state_->growBeyond(*roadmap, interrupt);
  }
  if (interrupt.isStopped())
    return fail(ErrorCode::kCancelled, "the request was cancelled before a plan was found");
  if (fault) return tl::unexpected(*fault);
  const auto roadmap = state_->current();
  return fail(
      ErrorCode::kTimeout,
      fmt::format("no plan found in {:.1f} s, with {} batches of roadmap{}; there may be none: give it more "
                  "time, or look at the places with `underway query`",
                  std::chrono::duration<double>(Clock::now() - started).count(),
                  roadmap ? roadmap->batches : 0U,
                  nearest ? fmt::format("; the nearest that was reached is ({:.2f} m, {:.2f} m, {:.2f} rad)",
                                        nearest->x, nearest->y, nearest->yaw)
                          : ""));
}

}  // namespace underway
