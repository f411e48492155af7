#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "geometry/checker.hpp"
#include "planner/plan.hpp"
#include "planner/repair.hpp"
#include "planner/roadmap.hpp"
#include "planner/roadmap_load.hpp"
#include "planner/settings.hpp"

namespace underway {

/// Told while the roadmap grows: the share that is done, 0..1. Must not call the planner.
using Progress = std::function<void(double)>;

/// Plans in one world for one robot, on a shared roadmap that grows when a query needs it and is repaired
/// when the world changes.
///
/// Thread safety: all members may be called from any number of threads. A query uses the snapshot it started
/// with; growth and repair publish a new one.
class Planner {
 public:
  using Clock = std::chrono::steady_clock;

  Planner(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot,
          GrowthSettings settings = {});
  ~Planner();

  /// Takes a roadmap that `save` kept, in place of growing one: publishes it and grows on from it when a
  /// query needs more. Every way of it is looked at anew, in the world as it is now. Errors: kInvalidRequest
  /// with a sentence, for a file that does not fit or lies (roadmap_load.hpp), and when there is a roadmap
  /// already.
  Expected<Loaded> load(std::string_view bytes);
  /// The roadmap as it is now, with the world it is of, for `load`; empty before anything has grown.
  [[nodiscard]] std::string save() const;

  /// Grows the roadmap until it covers the floor (GrowthSettings) or the deadline passes, and publishes what
  /// has grown. Goes on where it stopped, also after `load`.
  void prepare(Clock::time_point deadline, const Progress& progress = {}, const std::stop_token& stop = {});

  /// A certified plan to the best of the request's goals, or why there is none: start or all goals in
  /// collision or out of bounds, kNoPathExists with what is to blame, kTimeout with the nearest pose that was
  /// reached, kCancelled, kInvalidRequest. Goals that cannot be stood at are left out as long as there are
  /// others; that no path exists is told only if none leads to any of the rest. Plan and error name the world
  /// they are about. If there is no roadmap yet it grows one first, for half of the time at most (and tells
  /// `progress`). If the roadmap does not hold a plan, it grows until there is one, it is proven that there
  /// is none, which a second thread tries, or the deadline passes.
  [[nodiscard]] Expected<Plan> plan(const Request& request, Clock::time_point deadline,
                                    const std::stop_token& stop = {}, const Progress& progress = {});
  /// The same without trying to prove anything.
  [[nodiscard]] Expected<Plan> findPlan(const Request& request, Clock::time_point deadline,
                                        const std::stop_token& stop = {}, const Progress& progress = {});

  /// Moves on to another revision of the world. The roadmap keeps its places and links; those that the
  /// changes may touch are looked at again. Queries that have begun end in the world they began in.
  Repair update(std::shared_ptr<const World> revision);

  /// The roadmap as it is now; empty before `prepare` and the first plan.
  [[nodiscard]] std::shared_ptr<const Roadmap> roadmap() const;
  /// Of the world as it is now.
  [[nodiscard]] std::shared_ptr<const Checker> checker() const;

 private:
  enum class Proving { kNo, kYes };
  [[nodiscard]] Expected<Plan> plan(const Request& request, Clock::time_point deadline,
                                    const std::stop_token& stop, const Progress& progress, Proving proving);
  /// `asked` becomes what was asked for in the end (`admitted`), `world` the one the answer is about.
  [[nodiscard]] Expected<Plan> plan(Expected<Request>& asked, std::shared_ptr<const Checker>& world,
                                    Clock::time_point deadline, const std::stop_token& stop,
                                    const Progress& progress, Proving proving);

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace underway
