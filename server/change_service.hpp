#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "planner/change.hpp"
#include "server/domain.hpp"

namespace underway {

struct ChangeServiceSettings {
  std::size_t most_clients = 128;        ///< that are connected at once; the one silent longest gives way
  std::chrono::milliseconds hold{2000};  ///< how long a reply waits for its client's reader to be matched
};

/// Changes a planner's world as it is asked to over DDS (idl/underway.idl), and publishes the world's state
/// when it starts and after each change, until it is destroyed.
///
/// Requests are carried out one after the other, in the order they come, beside whatever the planner is asked
/// meanwhile. Each gets exactly one final reply; a resent one gets the same reply again and is carried out
/// once. What is stopped is answered `cancelled`. Nothing else may change the planner's world meanwhile.
/// Thread safety: stop() and wait() from any thread.
class ChangeService {
 public:
  /// Told of each request that was carried out or refused, on the service's thread.
  using Log = std::function<void(std::size_t changes, const World& world, const Expected<Changed>& outcome)>;

  /// Errors: kInternal when DDS refuses.
  [[nodiscard]] static Expected<ChangeService> start(std::shared_ptr<const Domain> domain,
                                                     std::shared_ptr<Planner> planner, Log log = {},
                                                     const ChangeServiceSettings& settings = {});
  /// Stops and waits.
  ~ChangeService();
  ChangeService(ChangeService&&) noexcept;
  ChangeService& operator=(ChangeService&&) noexcept;

  /// Asks the service to end. Returns at once; not for signal handlers.
  void stop();
  /// Waits until the service has ended. An error if DDS failed before stop() was called.
  [[nodiscard]] Expected<void> wait() const;

 private:
  struct State;
  explicit ChangeService(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace underway
