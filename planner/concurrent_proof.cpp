#include "planner/concurrent_proof.hpp"

#include <utility>

#include "planner/impossible.hpp"

namespace underway {

ConcurrentProof::ConcurrentProof(std::shared_ptr<const Checker> checker, const Request& request,
                                 const GrowthSettings& settings, Interrupt::Clock::time_point deadline,
                                 std::stop_source search)
    : checker_(std::move(checker)),
      request_(request),
      thread_([this, settings, deadline, search](const std::stop_token& stop) mutable {
        Interrupt interrupt(deadline, stop);
        found_ = provenImpossible(*checker_, request_, settings, interrupt, interrupt);
        is_over_ = true;
        if (found_) search.request_stop();
      }) {}

std::optional<Error> ConcurrentProof::end() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  return std::move(found_);
}

}  // namespace underway
