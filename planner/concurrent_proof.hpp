#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/plan.hpp"
#include "planner/settings.hpp"

namespace underway {

/// Tries to prove that no plan answers a request (`provenImpossible`), on a thread of its own, while somebody
/// looks for one: neither waits for the other. All members are called by the one who looks.
class ConcurrentProof {
 public:
  /// Until the deadline passes. When it has found a proof it stops `search`.
  ConcurrentProof(std::shared_ptr<const Checker> checker, const Request& request,
                  const GrowthSettings& settings, Interrupt::Clock::time_point deadline,
                  std::stop_source search);
  ConcurrentProof(const ConcurrentProof&) = delete;
  ConcurrentProof& operator=(const ConcurrentProof&) = delete;

  /// Of which world, and what was asked.
  [[nodiscard]] const std::shared_ptr<const Checker>& checker() const { return checker_; }
  [[nodiscard]] const Request& request() const { return request_; }
  /// Whether it has ended by itself.
  [[nodiscard]] bool isOver() const { return is_over_; }
  /// Gives up, which takes less than a millisecond. The proof, if it had found one; what its thread has
  /// thrown is thrown here.
  [[nodiscard]] std::optional<Error> end();

 private:
  std::shared_ptr<const Checker> checker_;
  Request request_;
  std::atomic<bool> is_over_ = false;
  std::optional<Error> found_;  // the thread's, until it has ended; so is what follows
  std::exception_ptr thrown_;
  std::jthread thread_;
};

}  // namespace underway
