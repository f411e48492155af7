#include "server/request_ledger.hpp"

namespace underway {
namespace {

// A reply without segments weighs about as much as this many.
constexpr std::size_t kBareReply = 10;

std::size_t weightOf(const FinalReply& answer) { return kBareReply + answer.weight; }

}  // namespace

const FinalReply* RequestLedger::answerTo(const RequestId& id) const {
  const auto found = answered_.find(id);
  return found == answered_.end() ? nullptr : &found->second;
}

void RequestLedger::finish(const FinalReply& answer) {
  in_flight_.erase(answer.id);
  if (!answered_.emplace(answer.id, answer).second) return;
  oldest_first_.push_back(answer.id);
  weight_ += weightOf(answer);
  while (weight_ > most_ && oldest_first_.size() > 1) {
    const auto oldest = answered_.find(oldest_first_.front());
    weight_ -= weightOf(oldest->second);
    answered_.erase(oldest);
    oldest_first_.pop_front();
  }
}

}  // namespace underway
