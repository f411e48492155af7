#pragma once

#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "server/question.hpp"

namespace underway {

/// A final reply and where it belongs.
struct FinalReply {
  RequestId id;
  std::string partition;
  std::shared_ptr<const void> reply;  ///< of the topic's type
  std::size_t weight = 0;             ///< how large it is, in segments
};

/// Remembers which requests are being worked on and what was answered, so that no resend is worked on twice.
/// Invariant: an id is in flight, or answered, or unknown; the weight of what is remembered stays within the
/// limit, the oldest answers being forgotten first. Thread safety: none; it belongs to one thread.
class RequestLedger {
 public:
  /// `most_remembered` counts segments, an answer's own fields as ten: some 30 MB.
  explicit RequestLedger(std::size_t most_remembered = 100'000) : most_(most_remembered) {}

  [[nodiscard]] bool isInFlight(const RequestId& id) const { return in_flight_.contains(id); }
  /// What was answered; nullptr if nothing was, or it is forgotten.
  [[nodiscard]] const FinalReply* answerTo(const RequestId& id) const;
  [[nodiscard]] std::size_t inFlight() const { return in_flight_.size(); }

  void begin(const RequestId& id) { in_flight_.insert(id); }
  void finish(const FinalReply& answer);

 private:
  std::size_t most_;
  std::size_t weight_ = 0;
  std::set<RequestId> in_flight_;
  std::map<RequestId, FinalReply> answered_;
  std::deque<RequestId> oldest_first_;
};

}  // namespace underway
