#include "server/client.hpp"

#include <algorithm>
#include <optional>
#include <random>
#include <utility>

#include "server/convert.hpp"
#include "server/link.hpp"
#include "server/reply_post.hpp"

namespace underway {
namespace {

using dds::Clock;

constexpr dds_attach_t kWriterToken = 1;
constexpr dds_attach_t kReplyToken = 2;
constexpr std::int32_t kDepth = 64;
constexpr std::chrono::milliseconds kLongestResend{1000};
// Added to the planning's deadline: discovery, a held reply, and the way there and back.
constexpr std::chrono::milliseconds kRoundTrip{5000};

std::array<std::uint8_t, 16> randomClient() {
  std::random_device device;
  std::array<std::uint8_t, 16> client{};
  for (std::uint8_t& byte : client) byte = static_cast<std::uint8_t>(device() & 0xFFU);
  return client;
}

}  // namespace

struct PlanClient::State {
  Link link;
  PlanClientSettings settings;
  RequestId id{randomClient(), 0};
  std::string robot;  ///< whose partition the reader listens in
  dds::Entity writer;
  dds::Entity reader;
  dds::Entity has_replies;

  [[nodiscard]] Expected<void> open();
  [[nodiscard]] Expected<void> listenFor(const std::string& robot_name);
  [[nodiscard]] bool hasServer() const;
  [[nodiscard]] Expected<void> findServer(Clock::time_point until);
  [[nodiscard]] Expected<PlanDocument> converse(const underway_PlanRequest& wire, const Question& question,
                                                Clock::time_point until);
  [[nodiscard]] Expected<std::optional<Expected<PlanDocument>>> takeReply(const Question& question);
};

Expected<void> PlanClient::State::open() {
  FirstError first;
  writer = first.unwrap(dds::createWriter(link.participant, link.request_topic, {.depth = kDepth}));
  dds_set_status_mask(writer.get(), DDS_PUBLICATION_MATCHED_STATUS);
  first.check(link.wait_set.attach(writer, kWriterToken));
  if (first.error()) return tl::unexpected(*first.error());
  return {};
}

Expected<void> PlanClient::State::listenFor(const std::string& robot_name) {
  if (robot == robot_name) return {};
  FirstError first;
  robot.clear();
  has_replies = {};
  reader = first.unwrap(
      dds::createReader(link.participant, link.reply_topic,
                        {.partition = robot_name, .depth = kDepth, .user_data = userDataOf(id.client)}));
  has_replies = first.unwrap(dds::createReadCondition(reader));
  first.check(link.wait_set.attach(has_replies, kReplyToken));
  if (first.error()) return tl::unexpected(*first.error());
  robot = robot_name;
  return {};
}

/// Whether a server's reader is matched now; also lets the wait set sleep again.
bool PlanClient::State::hasServer() const {
  dds_publication_matched_status_t status{};
  return dds_get_publication_matched_status(writer.get(), &status) == DDS_RETCODE_OK &&
         status.current_count > 0;
}

Expected<void> PlanClient::State::findServer(Clock::time_point until) {
  while (!hasServer()) {
    if (Clock::now() >= until)
      return fail(ErrorCode::kNoServer, "no plan server answers in DDS domain " +
                                            std::to_string(link.domain->id()) +
                                            ": start one with the same domain and the same network setting");
    if (const auto woken = link.wait_set.wait(until); !woken) return tl::unexpected(woken.error());
  }
  return {};
}

/// The reply to the request under way, if it has come. Replies to others and to earlier requests are dropped.
Expected<std::optional<Expected<PlanDocument>>> PlanClient::State::takeReply(const Question& question) {
  const auto loan = dds::Loan::take(reader);
  if (!loan) return tl::unexpected(loan.error());
  std::optional<Expected<PlanDocument>> document;
  (*loan)->forEach<underway_PlanReply>([&](const underway_PlanReply& reply) {
    if (!document && idOf(reply.id) == id) document = fromWire(reply, question);
  });
  return document;
}

Expected<PlanDocument> PlanClient::State::converse(const underway_PlanRequest& wire, const Question& question,
                                                   Clock::time_point until) {
  auto pause = settings.first_resend;
  Clock::time_point next_send = Clock::now();
  while (Clock::now() < until) {
    if (Clock::now() >= next_send) {
      // A refusal means that no server keeps up just now: the next resend tries again.
      dds_write(writer.get(), &wire);
      next_send = Clock::now() + pause;
      pause = std::min(2 * pause, kLongestResend);
    }
    const auto woken = link.wait_set.wait(std::min(next_send, until));
    if (!woken) return tl::unexpected(woken.error());
    (void)hasServer();  // a server that comes or goes wakes us only once
    auto document = takeReply(question);
    if (!document) return tl::unexpected(document.error());
    if (*document) return std::move(**document);
  }
  if (!hasServer())
    return fail(ErrorCode::kNoServer, "the plan server went away before it answered: start it and ask again");
  return fail(ErrorCode::kTimeout,
              "the plan server did not answer in time: allow more time or a shorter deadline");
}

PlanClient::PlanClient(std::unique_ptr<State> state) : state_(std::move(state)) {}
PlanClient::~PlanClient() = default;
PlanClient::PlanClient(PlanClient&&) noexcept = default;
PlanClient& PlanClient::operator=(PlanClient&&) noexcept = default;

Expected<PlanClient> PlanClient::open(std::shared_ptr<const Domain> domain,
                                      const PlanClientSettings& settings) {
  Expected<Link> link = Link::open(std::move(domain));
  if (!link) return tl::unexpected(link.error());
  auto state = std::make_unique<State>();
  state->link = std::move(*link);
  state->settings = settings;
  if (const Expected<void> opened = state->open(); !opened) return tl::unexpected(opened.error());
  return PlanClient(std::move(state));
}

Expected<PlanDocument> PlanClient::ask(const Question& question, std::chrono::milliseconds patience) {
  const Clock::time_point until = Clock::now() + patience;
  ++state_->id.sequence;
  const Expected<underway_PlanRequest> wire = toWire(state_->id, question);
  if (!wire) return tl::unexpected(wire.error());
  if (const Expected<void> listening = state_->listenFor(question.robot); !listening)
    return tl::unexpected(listening.error());
  const Clock::time_point discovered = std::min(until, Clock::now() + state_->settings.discovery);
  if (const Expected<void> found = state_->findServer(discovered); !found)
    return tl::unexpected(found.error());
  return state_->converse(*wire, question, until);
}

Expected<PlanDocument> PlanClient::ask(const Question& question) {
  return ask(question, question.deadline + kRoundTrip);
}

}  // namespace underway
