#include "server/request_desk.hpp"

#include <algorithm>
#include <utility>

namespace underway {
namespace {

// Tokens of the wait set; those of the reply writers are even.
constexpr dds_attach_t kRequestToken = 1;
constexpr dds_attach_t kGuardToken = 3;

// What is left for written replies to arrive when the service ends.
constexpr std::chrono::seconds kFlush{1};

}  // namespace

RequestDesk::RequestDesk(Link link, ReplyPost::Limits limits)
    : link_(std::move(link)), post_(link_.participant, link_.reply_topic, link_.wait_set, limits) {}

Expected<void> RequestDesk::open() {
  FirstError first;
  reader_ = first.unwrap(dds::createReader(link_.participant, link_.request_topic, {.depth = kDepth}));
  has_requests_ = first.unwrap(dds::createReadCondition(reader_));
  guard_ = first.unwrap(dds::createGuardCondition(link_.participant));
  first.check(link_.wait_set.attach(has_requests_, kRequestToken));
  first.check(link_.wait_set.attach(guard_, kGuardToken));
  if (first.error()) return tl::unexpected(*first.error());
  return {};
}

void RequestDesk::wake() { dds_set_guardcondition(guard_.get(), true); }

Expected<void> RequestDesk::wait(Clock::time_point until) {
  const auto tokens = link_.wait_set.wait(std::min(until, post_.nextExpiry()));
  if (!tokens) return tl::unexpected(tokens.error());
  for (const dds_attach_t token : *tokens) onToken(token);
  post_.expire(Clock::now());
  return {};
}

void RequestDesk::onToken(dds_attach_t token) {
  if (token == kGuardToken) {
    bool was_set = false;
    dds_take_guardcondition(guard_.get(), &was_set);
  } else if (token != kRequestToken) {
    post_.onMatched(token);
  }
}

bool RequestDesk::isResend(const RequestId& id) {
  if (ledger_.isInFlight(id)) return true;
  const FinalReply* answer = ledger_.answerTo(id);
  if (answer != nullptr) post_.send(*answer);
  return answer != nullptr;
}

void RequestDesk::reply(const FinalReply& answer) {
  ledger_.finish(answer);
  post_.send(answer);
}

void RequestDesk::flush() { post_.flush(Clock::now() + kFlush); }

}  // namespace underway
