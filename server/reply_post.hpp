#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "server/dds.hpp"
#include "server/request_ledger.hpp"

namespace underway {

/// Delivers replies: a writer and partition per robot, so that a robot that hangs disturbs no other and no
/// robot's reader is flooded by replies to others.
///
/// A reply written before the client's reader is matched would be lost, so it is held until then, up to a
/// limit. Losing one is no harm: the client asks again and the ledger knows the answer. Thread safety: none;
/// it belongs to the thread that waits on the wait set. No call blocks for longer than kMaxBlocking.
class ReplyPost {
 public:
  using Clock = dds::Clock;
  static constexpr std::chrono::milliseconds kMaxBlocking{
      10};                                        ///< of a write to a robot that does not keep up
  static constexpr std::size_t kMostHeld = 1024;  ///< beyond, the oldest is given up

  struct Limits {
    std::chrono::milliseconds hold{2000};
    std::size_t most_writers = 128;
  };

  /// Attaches its writers to the wait set, each with a token that onMatched() takes: tokens are even, never
  /// 0.
  ReplyPost(const dds::Entity& participant, const dds::Entity& topic, dds::WaitSet& wait_set, Limits limits);

  /// Writes the reply, or holds it until the client's reader is matched.
  void send(const FinalReply& answer);
  /// Call when the wait set returns a writer's token.
  void onMatched(dds_attach_t token);
  /// Gives up what was held too long.
  void expire(Clock::time_point now);
  /// When expire() has something to do next; Clock::time_point::max() if nothing is held.
  [[nodiscard]] Clock::time_point nextExpiry() const;
  [[nodiscard]] bool isHolding() const { return !held_.empty(); }
  [[nodiscard]] std::size_t writers() const { return writers_.size(); }
  /// Waits until all that was written has arrived, but not beyond the given time.
  void flush(Clock::time_point until);

 private:
  struct Writer {
    dds::Entity entity;
    std::vector<std::string> readers;  ///< user data of the matched readers
    std::uint64_t last_use = 0;
  };
  struct Held {
    FinalReply answer;
    Clock::time_point expiry;
  };
  [[nodiscard]] Writer* writerFor(const std::string& partition);
  [[nodiscard]] bool makeRoom();
  [[nodiscard]] bool deliver(const FinalReply& answer, Writer& writer);

  const dds::Entity& participant_;
  const dds::Entity& topic_;
  dds::WaitSet& wait_set_;
  Limits limits_;
  std::map<std::string, Writer> writers_;  ///< by partition; nodes stay where they are
  std::deque<Held> held_;                  ///< oldest first
  std::uint64_t uses_ = 0;
};

/// What a client's reader says in its user data: "clientid=<32 hex digits>;".
[[nodiscard]] std::string userDataOf(const std::array<std::uint8_t, 16>& client);

}  // namespace underway
