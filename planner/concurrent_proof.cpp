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
        try {
          found_ = provenImpossible(*checker_, request_, settings, interrupt);
        } catch (...) {
          thrown_ = std::current_exception();
        }
        is_over_ = true;
        if (found_ || thrown_) search.request_stop();
      }) {}

std::optional<Error> ConcurrentProof::end() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  return std::exchange(found_, std::nullopt);
}

}  // namespace underway
