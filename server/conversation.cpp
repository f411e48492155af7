#include "server/conversation.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <utility>

#include "server/reply_post.hpp"

namespace underway {
namespace {

constexpr dds_attach_t kWriterToken = 1;
constexpr dds_attach_t kReplyToken = 2;
constexpr std::int32_t kDepth = 64;
constexpr std::chrono::milliseconds kLongestResend{1000};

std::array<std::uint8_t, 16> randomClient() {
  std::random_device device;
  std::array<std::uint8_t, 16> client{};
  for (std::uint8_t& byte : client) byte = static_cast<std::uint8_t>(device() & 0xFFU);
  return client;
}

}  // namespace

Expected<Conversation> Conversation::open(std::shared_ptr<const Domain> domain, const Topics& topics,
                                          const PlanClientSettings& settings) {
  Expected<Link> link = Link::open(std::move(domain), topics);
  if (!link) return tl::unexpected(link.error());
  Conversation made;
  made.link_ = std::move(*link);
  made.settings_ = settings;
  made.id_ = {randomClient(), 0};
  FirstError first;
  made.writer_ =
      first.unwrap(dds::createWriter(made.link_.participant, made.link_.request_topic, {.depth = kDepth}));
  dds_set_status_mask(made.writer_.get(), DDS_PUBLICATION_MATCHED_STATUS);
  first.check(made.link_.wait_set.attach(made.writer_, kWriterToken));
  if (first.error()) return tl::unexpected(*first.error());
  return made;
}

const RequestId& Conversation::nextId() {
  ++id_.sequence;
  return id_;
}

Expected<void> Conversation::listenFor(const std::string& robot) {
  if (robot_ == robot) return {};
  FirstError first;
  robot_.clear();
  has_replies_ = {};
  reader_ = first.unwrap(
      dds::createReader(link_.participant, link_.reply_topic,
                        {.partition = robot, .depth = kDepth, .user_data = userDataOf(id_.client)}));
  has_replies_ = first.unwrap(dds::createReadCondition(reader_));
  first.check(link_.wait_set.attach(has_replies_, kReplyToken));
  if (first.error()) return tl::unexpected(*first.error());
  robot_ = robot;
  return {};
}

/// Those whose readers are matched now; also lets the wait set sleep again.
std::size_t Conversation::servers() const {
  dds_publication_matched_status_t status{};
  return dds_get_publication_matched_status(writer_.get(), &status) == DDS_RETCODE_OK ? status.current_count
                                                                                      : 0;
}

Expected<void> Conversation::findServer(Clock::time_point until) {
  while (!hasServer()) {
    if (Clock::now() >= until)
      return fail(ErrorCode::kNoServer, "no plan server answers in DDS domain " +
                                            std::to_string(link_.domain->id()) +
                                            ": start one with the same domain and the same network setting");
    if (const auto woken = link_.wait_set.wait(until); !woken) return tl::unexpected(woken.error());
  }
  return {};
}

Expected<void> Conversation::converse(const void* request, const std::string& robot, Clock::time_point until,
                                      const Find& find) {
  if (const Expected<void> listening = listenFor(robot); !listening) return listening;
  const Clock::time_point discovered = std::min(until, Clock::now() + settings_.discovery);
  if (const Expected<void> found = findServer(discovered); !found) return found;
  auto pause = settings_.first_resend;
  Clock::time_point next_send = Clock::now();
  while (Clock::now() < until) {
    if (Clock::now() >= next_send) {
      // A refusal means that no server keeps up just now: the next resend tries again.
      dds_write(writer_.get(), request);
      next_send = Clock::now() + pause;
      pause = std::min(2 * pause, kLongestResend);
    }
    const auto woken = link_.wait_set.wait(std::min(next_send, until));
    if (!woken) return tl::unexpected(woken.error());
    (void)hasServer();  // a server that comes or goes wakes us only once
    const auto loan = dds::Loan::take(reader_);
    if (!loan) return tl::unexpected(loan.error());
    if (find(**loan)) return {};
  }
  if (!hasServer())
    return fail(ErrorCode::kNoServer, "the plan server went away before it answered: start it and ask again");
  return fail(ErrorCode::kTimeout,
              "the plan server did not answer in time: allow more time or a shorter deadline");
}

}  // namespace underway
