#pragma once

#include <chrono>
#include <cstddef>
#include <memory>

#include "planner/plan_document.hpp"
#include "server/client_settings.hpp"
#include "server/domain.hpp"
#include "server/question.hpp"

namespace underway {

/// Asks a plan server over DDS. Needs no robot file: the reply names the modes.
/// Thread safety: none; one client a thread. Clients of one process share its Domain.
class PlanClient {
 public:
  /// Errors: kInternal when DDS refuses.
  [[nodiscard]] static Expected<PlanClient> open(std::shared_ptr<const Domain> domain,
                                                 const PlanClientSettings& settings = {});
  ~PlanClient();
  PlanClient(PlanClient&&) noexcept;
  PlanClient& operator=(PlanClient&&) noexcept;

  /// The document that planning on the spot would have given: a plan, or the server's reason for none.
  ///
  /// Waits up to `patience` for the reply, and within it up to the discovery time for a server; resends until
  /// answered. Errors: kInvalidRequest for a question that cannot be sent or names an unknown mode; kNoServer
  /// if there is none or it went away; kTimeout if the reply does not come in time; kInternal for a malformed
  /// reply or a failure of DDS.
  [[nodiscard]] Expected<PlanDocument> ask(const Question& question, std::chrono::milliseconds patience);

  /// With enough patience for the question's deadline and the way there and back.
  [[nodiscard]] Expected<PlanDocument> ask(const Question& question);

  /// How many servers would get a question now; of more than one, the first to reply answers it. Those that
  /// have been discovered: none right after open(); one that was killed counts for about 1 s more.
  [[nodiscard]] std::size_t servers() const;
  /// Waits until there is one. Errors: kNoServer if there is none by then; kInternal.
  [[nodiscard]] Expected<void> findServer(std::chrono::steady_clock::time_point until);

 private:
  struct State;
  explicit PlanClient(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace underway
