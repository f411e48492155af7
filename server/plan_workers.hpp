#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "server/question.hpp"
#include "server/served.hpp"

namespace underway {

/// One request to be planned.
struct Job {
  RequestId id;
  std::string partition;
  Asked asked;
  std::chrono::steady_clock::time_point deadline;
};

/// Threads that plan, behind a bounded queue. Every job that was taken is finished exactly once, also when
/// stopped. Thread safety: offer() and stop() from any thread.
class PlanWorkers {
 public:
  /// Called from the workers' threads.
  using Finish = std::function<void(const Job&, Expected<Given>)>;

  PlanWorkers(PlanHandler handler, Finish finish, std::size_t threads, std::size_t most_queued);
  /// Stops and waits for the workers; what is queued is finished first.
  ~PlanWorkers();

  /// False if the queue is full.
  [[nodiscard]] bool offer(Job job);
  /// Tells the handlers to stop. From here on, jobs are finished as kCancelled.
  void stop();

 private:
  void work(std::stop_token stopping);
  [[nodiscard]] Expected<Given> answer(const Job& job, std::stop_token stopping) const;

  PlanHandler handler_;
  Finish finish_;
  std::size_t most_queued_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Job> queue_;
  std::vector<std::jthread> threads_;  ///< last: they use all of the above
};

}  // namespace underway
