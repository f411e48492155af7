#pragma once

#include <ctime>

#include <chrono>
#include <functional>

namespace underway::bench {

/// How long something takes [s].
[[nodiscard]] double secondsOf(const std::function<void()>& run);

/// Of a thread so far, this one's unless told otherwise; other programs do not lengthen it [s].
[[nodiscard]] double processorTime(clockid_t clock = CLOCK_THREAD_CPUTIME_ID);

/// Keeps a result from being optimised away.
void keep(std::size_t result);

struct Paired {
  double own_s;   ///< median of the rounds
  double peer_s;  ///< median of the rounds
  double ratio;   ///< median of peer / own, round by round
};

/// Times two ways of doing the same, in turn, so that a machine that slows down slows both.
[[nodiscard]] Paired inTurn(const std::function<void()>& own, const std::function<void()>& peer, int rounds);

/// The median time of some rounds [s].
[[nodiscard]] double medianOf(const std::function<void()>& run, int rounds);
/// The same of this thread's processor time, which others on the machine do not lengthen [s].
[[nodiscard]] double processorMedianOf(const std::function<void()>& run, int rounds);

}  // namespace underway::bench
