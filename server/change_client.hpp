#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/world_change.hpp"
#include "planner/repair.hpp"
#include "server/client_settings.hpp"
#include "server/domain.hpp"

namespace underway {

/// What is to become of a server's world.
struct ChangeQuestion {
  std::string robot;                      ///< who asks; see isRobotName
  std::vector<WorldChange> changes = {};  ///< all of them or none; empty: only tell how the world is
  std::uint64_t if_revision = 0;          ///< 0, or the revision that the world must have
};

/// How a world is.
struct WorldNow {
  std::string map_name;
  std::uint64_t revision = 0;
  std::string hash;
  std::size_t obstacles = 0;
};

struct ChangeAnswer {
  WorldNow world;  ///< after the changes, or as it is if there were none
  Expected<Repair>
      repaired;          ///< of the roadmap, or why nothing was changed: kStaleRevision, kInvalidRequest, ...
  double took_ms = 0.0;  ///< making the changes and looking again
};

/// Asks a server to change its world over DDS. Thread safety: none; one client a thread.
class ChangeClient {
 public:
  /// Errors: kInternal when DDS refuses.
  [[nodiscard]] static Expected<ChangeClient> open(std::shared_ptr<const Domain> domain,
                                                   const PlanClientSettings& settings = {});
  ~ChangeClient();
  ChangeClient(ChangeClient&&) noexcept;
  ChangeClient& operator=(ChangeClient&&) noexcept;

  /// Errors: kInvalidRequest for a question that cannot be sent; kNoServer, kTimeout, kInternal as
  /// PlanClient.
  [[nodiscard]] Expected<ChangeAnswer> ask(const ChangeQuestion& question,
                                           std::chrono::milliseconds patience = std::chrono::seconds(30));

  /// How many servers would get a question now; of more than one, the first to reply answers it. Those that
  /// have been discovered: none right after open(); one that was killed counts for about 1 s more.
  [[nodiscard]] std::size_t servers() const;

 private:
  struct State;
  explicit ChangeClient(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace underway
