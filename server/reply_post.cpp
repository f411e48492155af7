#include "server/reply_post.hpp"

#include <algorithm>

namespace underway {
namespace {

constexpr std::int32_t kDepth = 64;

/// Takes note of the writer's present matches, and of having taken note.
void readMatches(const dds::Entity& writer, std::vector<std::string>& readers) {
  dds_publication_matched_status_t status{};
  if (dds_get_publication_matched_status(writer.get(), &status) < 0) return;
  if (status.total_count_change == 0 && status.current_count_change == 0) return;
  readers = dds::userDataOfReaders(writer);
}

}  // namespace

std::string userDataOf(const std::array<std::uint8_t, 16>& client) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "clientid=";
  for (const std::uint8_t byte : client) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 0xFU];
  }
  return text + ";";
}

ReplyPost::ReplyPost(const dds::Entity& participant, const dds::Entity& topic, dds::WaitSet& wait_set,
                     Limits limits)
    : participant_(participant), topic_(topic), wait_set_(wait_set), limits_(limits) {}

void ReplyPost::send(const FinalReply& answer) {
  Writer* writer = writerFor(answer.partition);
  if (writer == nullptr || deliver(answer, *writer)) return;
  const auto is_same = [&](const Held& held) { return held.answer.id == answer.id; };
  if (std::any_of(held_.begin(), held_.end(), is_same)) return;
  held_.push_back({answer, Clock::now() + limits_.hold});
  if (held_.size() > kMostHeld) held_.pop_front();
}

/// False if the client's reader is not matched yet.
bool ReplyPost::deliver(const FinalReply& answer, Writer& writer) {
  readMatches(writer.entity, writer.readers);
  const std::string client = userDataOf(answer.id.client);
  const auto is_theirs = [&](const std::string& user_data) {
    return user_data.empty() || user_data == client;
  };
  if (std::none_of(writer.readers.begin(), writer.readers.end(), is_theirs)) return false;
  // A refusal means that the robot does not keep up; its resend will fetch the reply from the ledger.
  dds_write(writer.entity.get(), answer.reply.get());
  return true;
}

void ReplyPost::onMatched(dds_attach_t token) {
  const auto is_token = [&](auto& entry) { return reinterpret_cast<dds_attach_t>(&entry.second) == token; };
  const auto found = std::find_if(writers_.begin(), writers_.end(), is_token);
  if (found == writers_.end()) return;  // evicted meanwhile
  readMatches(found->second.entity, found->second.readers);
  std::erase_if(held_, [&](const Held& held) {
    return held.answer.partition == found->first && deliver(held.answer, found->second);
  });
}

void ReplyPost::expire(Clock::time_point now) {
  while (!held_.empty() && held_.front().expiry <= now) held_.pop_front();
}

ReplyPost::Clock::time_point ReplyPost::nextExpiry() const {
  return held_.empty() ? Clock::time_point::max() : held_.front().expiry;
}

ReplyPost::Writer* ReplyPost::writerFor(const std::string& partition) {
  if (const auto found = writers_.find(partition); found != writers_.end()) {
    found->second.last_use = ++uses_;
    return &found->second;
  }
  if (writers_.size() >= limits_.most_writers && !makeRoom()) return nullptr;
  Expected<dds::Entity> entity = dds::createWriter(
      participant_, topic_, {.partition = partition, .depth = kDepth, .max_blocking = kMaxBlocking});
  if (!entity) return nullptr;
  dds_set_status_mask(entity->get(), DDS_PUBLICATION_MATCHED_STATUS);
  const auto added = writers_.emplace(partition, Writer{std::move(*entity), {}, ++uses_}).first;
  Writer& writer = added->second;
  if (!wait_set_.attach(writer.entity, reinterpret_cast<dds_attach_t>(&writer))) {
    writers_.erase(added);
    return nullptr;
  }
  return &writer;
}

/// Closes the writer that was not used for the longest time, of those that have nothing left to deliver.
bool ReplyPost::makeRoom() {
  auto oldest = writers_.end();
  for (auto entry = writers_.begin(); entry != writers_.end(); ++entry) {
    const auto is_theirs = [&](const Held& held) { return held.answer.partition == entry->first; };
    if (std::any_of(held_.begin(), held_.end(), is_theirs)) continue;
    if (dds_wait_for_acks(entry->second.entity.get(), 0) != DDS_RETCODE_OK) continue;
    if (oldest == writers_.end() || entry->second.last_use < oldest->second.last_use) oldest = entry;
  }
  if (oldest == writers_.end()) return false;
  writers_.erase(oldest);
  return true;
}

void ReplyPost::flush(Clock::time_point until) {
  for (const auto& [partition, writer] : writers_) {
    const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(until - Clock::now());
    dds_wait_for_acks(writer.entity.get(), std::max<dds_duration_t>(0, left.count()));
  }
}

}  // namespace underway
