#include "server/client.hpp"

#include <optional>
#include <utility>

#include "server/conversation.hpp"
#include "server/convert.hpp"

namespace underway {
namespace {

// Added to the planning's deadline: discovery, a held reply, and the way there and back.
constexpr std::chrono::milliseconds kRoundTrip{5000};

}  // namespace

struct PlanClient::State {
  Conversation conversation;
};

PlanClient::PlanClient(std::unique_ptr<State> state) : state_(std::move(state)) {}
PlanClient::~PlanClient() = default;
PlanClient::PlanClient(PlanClient&&) noexcept = default;
PlanClient& PlanClient::operator=(PlanClient&&) noexcept = default;

Expected<PlanClient> PlanClient::open(std::shared_ptr<const Domain> domain,
                                      const PlanClientSettings& settings) {
  Expected<Conversation> opened = Conversation::open(std::move(domain), planTopics(), settings);
  if (!opened) return tl::unexpected(opened.error());
  return PlanClient(std::make_unique<State>(State{std::move(*opened)}));
}

Expected<PlanDocument> PlanClient::ask(const Question& question, std::chrono::milliseconds patience) {
  const auto until = dds::Clock::now() + patience;
  Conversation& conversation = state_->conversation;
  const Expected<WireRequest> wire = toWire(conversation.nextId(), question);
  if (!wire) return tl::unexpected(wire.error());
  std::optional<Expected<PlanDocument>> document;
  // Replies to others and to earlier requests are dropped.
  const auto find = [&](const dds::Loan& loan) {
    loan.forEach<underway_PlanReply>([&](const underway_PlanReply& reply) {
      if (!document && idOf(reply.id) == conversation.id()) document = fromWire(reply, question);
    });
    return document.has_value();
  };
  if (const auto answered = conversation.converse(wire->get(), question.robot, until, find); !answered)
    return tl::unexpected(answered.error());
  return *std::move(document);
}

Expected<PlanDocument> PlanClient::ask(const Question& question) {
  return ask(question, question.deadline + kRoundTrip);
}

Expected<void> PlanClient::findServer(std::chrono::steady_clock::time_point until) {
  return state_->conversation.findServer(until);
}

std::size_t PlanClient::servers() const { return state_->conversation.servers(); }

}  // namespace underway
