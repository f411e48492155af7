#pragma once

#include <memory>
#include <optional>

#include "server/dds.hpp"

namespace underway {

/// A topic of requests and the topic of their replies.
struct Topics {
  const dds_topic_descriptor_t& request;
  const char* request_name;
  const dds_topic_descriptor_t& reply;
  const char* reply_name;
};
[[nodiscard]] Topics planTopics();
[[nodiscard]] Topics changeTopics();

/// What both ends of a conversation have: a participant in the domain, both topics and a wait set.
struct Link {
  std::shared_ptr<const Domain> domain;
  dds::Entity participant;
  dds::Entity request_topic;
  dds::Entity reply_topic;
  dds::WaitSet wait_set;

  [[nodiscard]] static Expected<Link> open(std::shared_ptr<const Domain> domain,
                                           const Topics& topics = planTopics());
};

/// Unwraps entities made one after the other and keeps the first error: what is made from a missing entity
/// fails too, so one look at the end is enough.
class FirstError {
 public:
  template <class T>
  [[nodiscard]] T unwrap(Expected<T> made) {
    if (made) return std::move(*made);
    note(made.error());
    return T();
  }
  void check(const Expected<void>& done) {
    if (!done) note(done.error());
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  void note(const Error& error) {
    if (!error_) error_ = error;
  }
  std::optional<Error> error_;
};

}  // namespace underway
