#pragma once

#include <functional>

#include "bench/peers/peer.hpp"

namespace underway::bench {

/// Runs work in a process of its own and gathers what it tells of its progress; ends it when it is still
/// there at the limit and a while. The time begins with the work.
[[nodiscard]] Run runForked(double limit_s,
                            const std::function<void(const std::function<void(Sample)>&)>& work);

}  // namespace underway::bench
