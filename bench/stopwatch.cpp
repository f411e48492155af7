#include "bench/stopwatch.hpp"

#include <time.h>

#include <atomic>
#include <vector>

#include "bench/report.hpp"

namespace underway::bench {

double secondsOf(const std::function<void()>& run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void keep(std::size_t result) {
  static std::atomic<std::size_t> kept = 0;
  kept.store(result, std::memory_order_relaxed);
}

Paired inTurn(const std::function<void()>& own, const std::function<void()>& peer, int rounds) {
  std::vector<double> own_s, peer_s, ratio;
  for (int round = 0; round < rounds; ++round) {
    own_s.push_back(secondsOf(own));
    peer_s.push_back(secondsOf(peer));
    ratio.push_back(peer_s.back() / own_s.back());
  }
  return {quantile(own_s, 0.5), quantile(peer_s, 0.5), quantile(ratio, 0.5)};
}

double medianOf(const std::function<void()>& run, int rounds) {
  std::vector<double> seconds;
  seconds.reserve(static_cast<std::size_t>(rounds));
  for (int round = 0; round < rounds; ++round) seconds.push_back(secondsOf(run));
  return quantile(seconds, 0.5);
}

double processorTime(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double processorMedianOf(const std::function<void()>& run, int rounds) {
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round) {
    const double start_s = processorTime();
    run();
    seconds.push_back(processorTime() - start_s);
  }
  return quantile(seconds, 0.5);
}

}  // namespace underway::bench
