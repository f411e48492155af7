#include "planner/planner.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "planner/answer.hpp"
#include "planner/concurrent_proof.hpp"
#include "planner/grow.hpp"
#include "planner/interrupt.hpp"

namespace underway {

namespace {

/// What a query answers with, from its beginning to its end.
struct Snapshot {
  std::shared_ptr<const Planning> planning;
  std::shared_ptr<const Roadmap> roadmap;  // empty before anything has grown
  std::shared_ptr<const LinkIndex> index;  // of the roadmap; empty until a change needs it
};

std::string timeoutMessage(Planner::Clock::duration took, const Roadmap* roadmap,
                           const std::optional<Pose>& nearest) {
  const std::string reached =
      nearest ? fmt::format("; the nearest pose that was reached is ({:.2f} m, {:.2f} m, {:.2f} rad)",
                            nearest->x, nearest->y, nearest->yaw)
              : "";
  return fmt::format(
      "no plan found in {:.1f} s, with {} batches of roadmap{}; there may be none: give it more time, "
      "or look at the places with `underway query`",
      std::chrono::duration<double>(took).count(), roadmap ? roadmap->batches : 0U, reached);
}

/// Where a goal stands among those of a request that has it.
std::uint32_t indexOf(const Goal& goal, const Request& request) {
  const std::vector<Goal> goals = goalsOf(request);
  return static_cast<std::uint32_t>(std::find(goals.begin(), goals.end(), goal) - goals.begin());
}

/// What a failure to reach some of the goals asked for says of the others; empty if there are none.
std::string leftOut(std::size_t goals, std::size_t tried) {
  if (goals == tried) return {};
  return fmt::format("; of {} goals {} were not tried, for they were given twice or cannot be stood at",
                     goals, goals - tried);
}

}  // namespace

/// The snapshot that answers first, those that have grown further, and the growth behind them. One hard
/// question makes that grow on and on, and on a large roadmap every answer takes longer: so a question goes
/// from one to the next larger until it is answered, and a change of the world leaves the first alone.
/// Whoever grows holds `growing`; whoever makes a snapshot out of the last one holds `changing`; whoever
/// reads or publishes them holds `published`, for no longer than a copy of their pointers takes.
struct Planner::State {
  State(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot, GrowthSettings s)
      : settings(s),
        snapshot{std::make_shared<const Planning>(
                     std::make_shared<const Checker>(std::move(world), std::move(robot))),
                 nullptr, nullptr},
        growth(snapshot.planning->checker, settings) {}

  [[nodiscard]] Snapshot current() const {
    const std::lock_guard lock(published);
    return snapshot;
  }

  void publish(Snapshot next) {
    const std::lock_guard lock(published);
    snapshot = std::move(next);
    further.clear();
  }

  /// What there is to try after another: the first of another world, or the next larger of the same.
  [[nodiscard]] std::optional<Snapshot> nextAfter(const Snapshot& tried) const {
    const std::lock_guard lock(published);
    const auto is_larger = [&](const Snapshot& other) {
      return other.roadmap->batches > tried.roadmap->batches;
    };
    if (snapshot.planning != tried.planning || is_larger(snapshot)) return snapshot;
    const auto next = std::find_if(further.begin(), further.end(), is_larger);
    return next == further.end() ? std::nullopt : std::optional(*next);
  }

  /// What has answered a hard question answers first from now on, unless it has grown far beyond what covers
  /// the floor.
  void prefer(const Snapshot& answered) {
    const std::lock_guard lock(published);
    const std::uint32_t batches = answered.roadmap->batches;
    if (answered.planning != snapshot.planning || batches <= snapshot.roadmap->batches ||
        batches > most_first)
      return;
    snapshot = answered;
    std::erase_if(further, [&](const Snapshot& other) { return other.roadmap->batches <= batches; });
  }

  /// Publishes the roadmap as grown, in the world as it is now, to answer first or after all others; for what
  /// comes last another world needs none of it. When interrupted it is left to who comes next.
  enum class Place { kFirst, kLast };
  void publishGrowth(Place place, Interrupt& interrupt) {
    auto grown = growth.freeze(interrupt);
    if (!grown) return;
    auto roadmap = std::make_shared<const Roadmap>(std::move(*grown));
    const std::uint32_t most = kMostOfCover * growth.batchesToCover();
    const std::lock_guard lock(changing);
    const Snapshot before = current();
    if (before.planning->checker != growth.checker()) {
      if (place == Place::kLast) return;
      Repair repair;
      roadmap = revalidated(*roadmap, before.planning->fastest, *before.planning->checker, repair);
    }
    Snapshot next{before.planning, std::move(roadmap), nullptr};
    if (place == Place::kFirst) publish(next);
    const std::lock_guard publishing(published);
    most_first = most;
    if (place == Place::kLast) further.push_back(std::move(next));
  }

  Repair update(std::shared_ptr<const World> world) {
    const std::lock_guard lock(changing);
    Snapshot next = current();
    const std::shared_ptr<const Checker> before = next.planning->checker;
    const auto checker = std::make_shared<const Checker>(before->at(std::move(world)));
    next.planning = std::make_shared<const Planning>(checker);
    Repair repair;
    if (next.roadmap) {
      if (!next.index) next.index = std::make_shared<const LinkIndex>(*next.roadmap, checker->robot());
      const auto changes = Obstacles::changes(before->world().obstacles(), checker->world().obstacles());
      const bool is_other_room = before->world().bounds() != checker->world().bounds() ||
                                 before->world().floorZ() != checker->world().floorZ();
      next.roadmap = is_other_room ? revalidated(*next.roadmap, next.planning->fastest, *checker, repair)
                                   : repaired(*next.roadmap, *next.index, next.planning->fastest, *checker,
                                              changes, repair);
    }
    publish(std::move(next));
    return repair;
  }

  /// Waits for its turn to grow; not owned when the deadline passes or the request is stopped first.
  [[nodiscard]] std::unique_lock<std::timed_mutex> turnToGrow(Interrupt& interrupt) {
    std::unique_lock lock(growing, std::defer_lock);
    // By the system's clock, since the thread sanitizer does not know of waits by the steady one.
    const auto soon = [] { return std::chrono::system_clock::now() + kPatience; };
    while (!interrupt.isDueNow() && !lock.try_lock_until(soon())) continue;
    return lock;
  }

  Expected<Loaded> load(std::string_view bytes) {
    const std::lock_guard lock(growing);
    if (current().roadmap)
      return fail(ErrorCode::kInvalidRequest, "there is a roadmap already: load one before the first plan");
    followWorld();
    const Checker& checker = *growth.checker();
    const Expected<LoadedRoadmap> loaded =
        underway::load(bytes, keyOf(checker, settings), Stances(checker, Policy::kFastest), checker);
    if (!loaded) return tl::unexpected(loaded.error());
    growth.takeOver(loaded->roadmap);
    Interrupt never(Clock::time_point::max(), {});
    publishGrowth(Place::kFirst, never);
    return loaded->how;
  }

  [[nodiscard]] std::string save() const {
    const Snapshot now = current();
    return now.roadmap ? toBytes(*now.roadmap, keyOf(*now.planning->checker, settings)) : std::string{};
  }

  /// Grows until the floor is covered or `growing_time` is due, and publishes that, unless there is a roadmap
  /// already that is enough.
  enum class Enough { kAny, kCovering };
  void cover(Enough enough, Interrupt& growing_time, Interrupt& interrupt, const Progress& progress) {
    if (enough == Enough::kAny && current().roadmap) return;
    const auto lock = turnToGrow(interrupt);
    if (!lock || (enough == Enough::kAny && current().roadmap)) return;
    followWorld();
    const auto started = Clock::now();
    const std::uint32_t wanted = growth.batchesToCover();
    if (current().roadmap && (growth.batches() >= wanted || growing_time.isDueNow())) return;
    do {
      if (!growth.addBatch(interrupt)) return;
      if (progress) progress(static_cast<double>(growth.batches()) / wanted);
    } while (growth.batches() < wanted && !growing_time.isDueNow());
    build_ms = build_ms + std::chrono::duration<double, std::milli>(Clock::now() - started).count();
    publishGrowth(Place::kFirst, interrupt);
  }

  /// Something better than what was not enough: the world has changed, another query has made it grow
  /// meanwhile or before, or now it grows on. Growth that the deadline cuts off goes on with the next query.
  Snapshot beyond(const Snapshot& tried, Interrupt& interrupt) {
    const auto lock = turnToGrow(interrupt);
    if (!lock) return tried;
    if (auto better = nextAfter(tried)) return *std::move(better);
    followWorld();
    const std::uint32_t wanted = tried.roadmap->batches + kLeastStep + tried.roadmap->batches / 2;
    while (growth.batches() < wanted)
      if (!growth.addBatch(interrupt)) return tried;
    publishGrowth(Place::kLast, interrupt);
    return nextAfter(tried).value_or(tried);
  }

  /// What grows next grows in the world as it is now, from the snapshot: what had grown beyond it is large,
  /// and was for questions of another world.
  void followWorld() {
    const Snapshot now = current();
    if (now.planning->checker == growth.checker()) return;
    growth.moveTo(now.planning->checker, now.roadmap ? *now.roadmap : Roadmap{});
  }

  static constexpr std::chrono::milliseconds kPatience{5};  // between looks at deadline and stop
  static constexpr std::uint32_t kMostOfCover = 8;          // times the batches that cover the floor
  static constexpr std::uint32_t kLeastStep = 4;            // batches: less takes as long, for answers

  GrowthSettings settings;
  std::mutex changing;
  mutable std::mutex published;
  Snapshot snapshot;
  std::vector<Snapshot> further;  // for what it does not answer; of the same world, each larger than the last
  std::uint32_t most_first = 0;   // batches that a roadmap may have to answer first
  std::timed_mutex growing;
  Growth growth;
  std::atomic<double> build_ms = 0.0;
};

Planner::Planner(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot,
                 GrowthSettings settings)
    : state_(std::make_unique<State>(std::move(world), std::move(robot), settings)) {}
Planner::~Planner() = default;

std::shared_ptr<const Roadmap> Planner::roadmap() const { return state_->current().roadmap; }
std::shared_ptr<const Checker> Planner::checker() const { return state_->current().planning->checker; }
Expected<Loaded> Planner::load(std::string_view bytes) { return state_->load(bytes); }
std::string Planner::save() const { return state_->save(); }
Repair Planner::update(std::shared_ptr<const World> revision) { return state_->update(std::move(revision)); }

void Planner::prepare(Clock::time_point deadline, const Progress& progress, const std::stop_token& stop) {
  Interrupt growing_time(deadline, stop);
  Interrupt interrupt(Clock::time_point::max(), stop);
  state_->cover(State::Enough::kCovering, growing_time, interrupt, progress);
}

Expected<Plan> Planner::plan(const Request& request, Clock::time_point deadline, const std::stop_token& stop,
                             const Progress& progress) {
  return plan(request, deadline, stop, progress, Proving::kYes);
}

Expected<Plan> Planner::findPlan(const Request& request, Clock::time_point deadline,
                                 const std::stop_token& stop, const Progress& progress) {
  return plan(request, deadline, stop, progress, Proving::kNo);
}

Expected<Plan> Planner::plan(const Request& request, Clock::time_point deadline, const std::stop_token& stop,
                             const Progress& progress, Proving proving) {
  std::shared_ptr<const Checker> world = checker();
  Expected<Request> asked = request;
  Expected<Plan> answer = plan(asked, world, deadline, stop, progress, proving);
  if (answer) {
    answer->goal_index = indexOf(goalsOf(*asked)[answer->goal_index], request);
    return answer;
  }
  Error& error = answer.error();
  error.revision = world->world().revision();
  error.world_hash = world->world().hash();
  if (asked) error.message += leftOut(goalsOf(request).size(), goalsOf(*asked).size());
  return answer;
}

Expected<Plan> Planner::plan(Expected<Request>& asked, std::shared_ptr<const Checker>& world,
                             Clock::time_point deadline, const std::stop_token& stop,
                             const Progress& progress, Proving proving) {
  const Request request = *asked;
  asked = admitted(*world, request);
  if (!asked) return tl::unexpected(asked.error());
  const auto started = Clock::now();
  std::stop_source search;  // stopped with the request, or by a proof that there is nothing to find
  const std::stop_callback forward(stop, [&] { search.request_stop(); });
  Interrupt interrupt(deadline, search.get_token());
  // Half the time at most goes into a good roadmap; the rest is left for a query that needs more of it.
  Interrupt growing_time(started + (deadline - started) / 2, stop);
  if (!interrupt.isDueNow()) state_->cover(State::Enough::kAny, growing_time, interrupt, progress);
  Answer last;
  std::optional<ConcurrentProof> proof;
  const auto proven = [&]() -> std::optional<Error> {
    if (!proof) return std::nullopt;
    auto no = proof->end();
    if (no) world = proof->checker(), asked = proof->request();
    return no;
  };
  bool has_grown = false;
  Snapshot now = state_->current();
  while (now.roadmap && !interrupt.isDueNow()) {
    world = now.planning->checker;
    asked = admitted(*world, request);
    if (!asked) return tl::unexpected(asked.error());
    last = answer(*now.planning, *now.roadmap, *asked, interrupt);
    if (last.plan) {
      state_->prefer(now);
      last.plan->stats.build_ms = state_->build_ms;
      return *std::move(last.plan);
    }
    // What can be answered is mostly answered when the roadmap has grown a little: only then a proof is
    // tried. One that is under way goes on in the world it began in.
    const bool is_tried = proof && (!proof->isOver() || proof->checker() == world);
    if (proving == Proving::kYes && has_grown && !last.fault && !is_tried) {
      if (auto no = proven()) return tl::unexpected(*std::move(no));
      proof.emplace(world, *asked, state_->settings, deadline, search);
    }
    has_grown = true;
    now = state_->beyond(now, interrupt);
  }
  if (auto no = proven()) return tl::unexpected(*std::move(no));
  if (stop.stop_requested())
    return fail(ErrorCode::kCancelled, "the request was cancelled before a plan was found");
  if (last.fault) return tl::unexpected(*last.fault);
  return fail(ErrorCode::kTimeout, timeoutMessage(Clock::now() - started, now.roadmap.get(), last.nearest));
}

}  // namespace underway
