#pragma once

#include "server/convert.hpp"
#include "server/link.hpp"
#include "server/reply_post.hpp"
#include "server/request_ledger.hpp"

namespace underway {

/// Where a server takes requests of one topic and hands out their replies, one for each. A request that was
/// sent again is not seen again: it gets the same reply.
///
/// Thread safety: wake() from any thread; everything else from the one thread that waits.
class RequestDesk {
 public:
  using Clock = dds::Clock;

  RequestDesk(Link link, ReplyPost::Limits limits);
  /// Begins to take requests. Errors: kInternal when DDS refuses.
  [[nodiscard]] Expected<void> open();

  void wake();
  /// Sleeps until a request or wake() comes, or the time.
  [[nodiscard]] Expected<void> wait(Clock::time_point until);
  /// Calls visit(const Wire&) for each new request. Takes a full reader's worth at most, so that a flood of
  /// requests does not hold up the replies.
  template <class Wire, class Visit>
  [[nodiscard]] Expected<void> takeNew(const Visit& visit) {
    bool is_empty = false;
    for (std::size_t i = 0; i < kDepth / dds::Loan::kMost && !is_empty; ++i) {
      const auto loan = dds::Loan::take(reader_);
      if (!loan) return tl::unexpected(loan.error());
      (*loan)->template forEach<Wire>([&](const Wire& wire) {
        if (!isResend(idOf(wire.id))) visit(wire);
      });
      is_empty = (*loan)->size() < dds::Loan::kMost;
    }
    return {};
  }
  /// A request that is answered later.
  void begin(const RequestId& id) { ledger_.begin(id); }
  void reply(const FinalReply& answer);
  [[nodiscard]] std::size_t inFlight() const { return ledger_.inFlight(); }
  /// Whether replies wait for their clients' readers.
  [[nodiscard]] bool isHolding() const { return post_.isHolding(); }
  /// Waits a moment for what was written to arrive.
  void flush();

  [[nodiscard]] const Link& link() const { return link_; }

 private:
  // A burst of requests may outrun the take loop by this many; beyond, resends mend what is lost.
  static constexpr std::int32_t kDepth = 1024;

  void onToken(dds_attach_t token);
  [[nodiscard]] bool isResend(const RequestId& id);

  Link link_;
  dds::Entity reader_;
  dds::Entity has_requests_;
  dds::Entity guard_;
  RequestLedger ledger_;
  ReplyPost post_;
};

}  // namespace underway
