#pragma once

#include <memory>

#include "local/mission.hpp"

namespace underway {

/// A PlanSource that never waits: it asks another one on a thread of its own and says kBusy until the answer
/// is there, so that the robot is watched over meanwhile. A question from another place than the one under
/// way is asked anew when that one has ended. When the last copy goes, the answer under way is waited for.
/// The other source is called by one thread at a time.
[[nodiscard]] PlanSource asking(PlanSource source);

}  // namespace underway
