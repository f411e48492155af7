#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "server/client_settings.hpp"
#include "server/link.hpp"
#include "server/question.hpp"

namespace underway {

/// One topic of requests and the topic of their replies, as a client sees them. Thread safety: none.
class Conversation {
 public:
  using Clock = dds::Clock;
  /// Looks through what has come; true once it holds the reply to the request under way.
  using Find = std::function<bool(const dds::Loan&)>;

  /// Errors: kInternal when DDS refuses.
  [[nodiscard]] static Expected<Conversation> open(std::shared_ptr<const Domain> domain, const Topics& topics,
                                                   const PlanClientSettings& settings);

  /// For the next request.
  [[nodiscard]] const RequestId& nextId();
  /// The one under way.
  [[nodiscard]] const RequestId& id() const { return id_; }
  /// Sends a sample of the request's type, again and again until the reply is found. Errors: kNoServer if
  /// there is no server or it went away; kTimeout if the reply does not come in time; kInternal for a failure
  /// of DDS.
  [[nodiscard]] Expected<void> converse(const void* request, const std::string& robot,
                                        Clock::time_point until, const Find& find);
  /// How many servers hear the requests now, as far as they have been discovered. One that was killed counts
  /// for about 1 s more.
  [[nodiscard]] std::size_t servers() const;
  /// Waits for the first of them. Errors: kNoServer if there is none by then; kInternal.
  [[nodiscard]] Expected<void> findServer(Clock::time_point until);

 private:
  Conversation() = default;
  [[nodiscard]] Expected<void> listenFor(const std::string& robot);
  [[nodiscard]] bool hasServer() const { return servers() > 0; }
  Link link_;
  PlanClientSettings settings_;
  RequestId id_;
  std::string robot_;  // whose partition the reader listens in
  dds::Entity writer_;
  dds::Entity reader_;
  dds::Entity has_replies_;
};

}  // namespace underway
