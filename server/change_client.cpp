#include "server/change_client.hpp"

#include <optional>
#include <utility>

#include "server/conversation.hpp"
#include "server/convert.hpp"
#include "server/convert_change.hpp"

namespace underway {

struct ChangeClient::State {
  Conversation conversation;
};

ChangeClient::ChangeClient(std::unique_ptr<State> state) : state_(std::move(state)) {}
ChangeClient::~ChangeClient() = default;
ChangeClient::ChangeClient(ChangeClient&&) noexcept = default;
ChangeClient& ChangeClient::operator=(ChangeClient&&) noexcept = default;

Expected<ChangeClient> ChangeClient::open(std::shared_ptr<const Domain> domain,
                                          const PlanClientSettings& settings) {
  Expected<Conversation> opened = Conversation::open(std::move(domain), changeTopics(), settings);
  if (!opened) return tl::unexpected(opened.error());
  return ChangeClient(std::make_unique<State>(State{std::move(*opened)}));
}

Expected<ChangeAnswer> ChangeClient::ask(const ChangeQuestion& question, std::chrono::milliseconds patience) {
  const auto until = dds::Clock::now() + patience;
  Conversation& conversation = state_->conversation;
  const Expected<WireChangeRequest> wire = toWire(conversation.nextId(), question);
  if (!wire) return tl::unexpected(wire.error());
  std::optional<Expected<ChangeAnswer>> answer;
  const auto find = [&](const dds::Loan& loan) {
    loan.forEach<underway_ChangeReply>([&](const underway_ChangeReply& reply) {
      if (!answer && idOf(reply.id) == conversation.id()) answer = fromWire(reply);
    });
    return answer.has_value();
  };
  if (const auto answered = conversation.converse(wire->get(), question.robot, until, find); !answered)
    return tl::unexpected(answered.error());
  return *std::move(answer);
}

std::size_t ChangeClient::servers() const { return state_->conversation.servers(); }

}  // namespace underway
