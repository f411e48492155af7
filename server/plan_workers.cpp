#include "server/plan_workers.hpp"

#include <exception>
#include <utility>

namespace underway {

PlanWorkers::PlanWorkers(PlanHandler handler, Finish finish, std::size_t threads, std::size_t most_queued)
    : handler_(std::move(handler)), finish_(std::move(finish)), most_queued_(most_queued) {
  for (std::size_t i = 0; i < threads; ++i)
    threads_.emplace_back([this](std::stop_token stopping) { work(std::move(stopping)); });
}

PlanWorkers::~PlanWorkers() { stop(); }

bool PlanWorkers::offer(Job job) {
  {
    const std::scoped_lock lock(mutex_);
    if (queue_.size() >= most_queued_) return false;
    queue_.push_back(std::move(job));
  }
  changed_.notify_one();
  return true;
}

void PlanWorkers::stop() {
  for (std::jthread& thread : threads_) thread.request_stop();
}

void PlanWorkers::work(std::stop_token stopping) {
  while (true) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stopping, [this] { return !queue_.empty(); });
    if (queue_.empty()) return;  // only when stopping
    const Job job = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    finish_(job, answer(job, stopping));
  }
}

Expected<Given> PlanWorkers::answer(const Job& job, std::stop_token stopping) const {
  if (stopping.stop_requested())
    return fail(ErrorCode::kCancelled, "the server is stopping: ask again later");
  if (std::chrono::steady_clock::now() >= job.deadline)
    return fail(ErrorCode::kTimeout, "the deadline passed while the request waited: allow more time");
  try {
    return handler_(job.asked, job.deadline, std::move(stopping));
  } catch (const std::exception& thrown) {
    return fail(ErrorCode::kInternal, std::string("the planner failed: ") + thrown.what());
  } catch (...) {
    return fail(ErrorCode::kInternal, "the planner failed for an unknown reason");
  }
}

}  // namespace underway
