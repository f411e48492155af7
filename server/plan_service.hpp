#pragma once

#include <chrono>
#include <cstddef>
#include <memory>

#include "server/domain.hpp"
#include "server/served.hpp"

namespace underway {

struct PlanServiceSettings {
  std::size_t threads = 0;        ///< that plan; 0: as many as the machine has
  std::size_t most_queued = 64;   ///< requests that wait, at least 1; beyond, they are answered `busy`
  std::size_t most_robots = 128;  ///< robots that are connected at once; the one silent longest gives way
  std::chrono::milliseconds hold{2000};  ///< how long a reply waits for its client's reader to be matched
};

/// Answers plan requests over DDS (idl/underway.idl) until it is destroyed.
///
/// Every request gets exactly one final reply, also when it is malformed (`invalid_request`), late
/// (`timeout`), one too many (`busy`) or overtaken by the end (`cancelled`). A resent request gets the same
/// reply again and is planned once. Deadlines count from arrival. A handler that ignores its deadline or its
/// stop token delays the reply or the end. Thread safety: stop() and wait() from any thread; the handler is
/// called from `threads` threads.
class PlanService {
 public:
  /// Errors: kInvalidRobot when the wire cannot carry what is served, kInternal when DDS refuses.
  [[nodiscard]] static Expected<PlanService> start(std::shared_ptr<const Domain> domain, Served served,
                                                   PlanHandler handler,
                                                   const PlanServiceSettings& settings = {});
  /// Stops and waits.
  ~PlanService();
  PlanService(PlanService&&) noexcept;
  PlanService& operator=(PlanService&&) noexcept;

  /// Asks the service to end: handlers are told to stop, what waits is answered `cancelled`. Returns at once;
  /// not for signal handlers.
  void stop();
  /// Waits until the service has ended. An error if DDS failed before stop() was called.
  [[nodiscard]] Expected<void> wait() const;

 private:
  struct State;
  explicit PlanService(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace underway
