#include "bench/peers/forked.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <stdexcept>

namespace underway::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kGrace_s = 0.5;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Reads one sample; false at the end of the pipe.
bool readSample(int pipe, Sample& sample) {
  auto* bytes = reinterpret_cast<char*>(&sample);
  for (std::size_t has = 0; has < sizeof sample;) {
    const ssize_t got = read(pipe, bytes + has, sizeof sample - has);
    if (got <= 0) return false;
    has += static_cast<std::size_t>(got);
  }
  return true;
}

void writeSample(int pipe, const Sample& sample) {
  // Less than a pipe's atomic size, so that threads do not mix theirs.
  if (write(pipe, &sample, sizeof sample) != static_cast<ssize_t>(sizeof sample)) _exit(1);
}

}  // namespace

Run runForked(double limit_s, const std::function<void(const std::function<void(Sample)>&)>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe to a process of the peer's own");
  const Clock::time_point start = Clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process of the peer's own");
  if (child == 0) {
    close(ends[0]);
    work([&](Sample sample) { writeSample(ends[1], sample); });
    _exit(0);  // nothing of the parent's is to be tidied up twice
  }
  close(ends[1]);
  Run run;
  while (true) {
    const double left_s = limit_s + kGrace_s - secondsSince(start);
    pollfd waiting{ends[0], POLLIN, 0};
    if (left_s <= 0.0 || poll(&waiting, 1, static_cast<int>(left_s * 1e3) + 1) == 0) {
      run.was_killed = true;
      kill(child, SIGKILL);
      break;
    }
    Sample sample;
    if (!readSample(ends[0], sample)) break;
    if (run.progress.empty() || sample.cost_s < run.progress.back().cost_s) run.progress.push_back(sample);
  }
  close(ends[0]);
  waitpid(child, nullptr, 0);
  run.took_s = secondsSince(start);
  return run;
}

}  // namespace underway::bench
