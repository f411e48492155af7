#include "server/dds.hpp"

#include <algorithm>
#include <memory>

namespace underway::dds {
namespace {

constexpr std::size_t kMostTokens = 512;
constexpr std::size_t kMostReaders = 256;

struct FreeQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, FreeQos>;

Qos qosOf(const EndpointOptions& options) {
  Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(),
                       options.is_best_effort ? DDS_RELIABILITY_BEST_EFFORT : DDS_RELIABILITY_RELIABLE,
                       DDS_MSECS(options.max_blocking.count()));
  dds_qset_durability(qos.get(),
                      options.is_for_latecomers ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, options.depth);
  if (options.is_plain_cdr) {
    const dds_data_representation_id_t plain = DDS_DATA_REPRESENTATION_XCDR1;
    dds_qset_data_representation(qos.get(), 1, &plain);
  }
  if (!options.partition.empty()) dds_qset_partition1(qos.get(), options.partition.c_str());
  if (!options.user_data.empty())
    dds_qset_userdata(qos.get(), options.user_data.data(), options.user_data.size());
  return qos;
}

Expected<Entity> owned(dds_entity_t handle, const std::string& what) {
  if (handle < 0) return failure("cannot create " + what, handle);
  return Entity(handle);
}

/// What is left until then, as DDS counts it.
dds_duration_t left(Clock::time_point until) {
  if (until == Clock::time_point::max()) return DDS_INFINITY;
  const auto rest = std::chrono::duration_cast<std::chrono::nanoseconds>(until - Clock::now());
  return std::max<dds_duration_t>(0, rest.count());
}

std::string userDataOf(dds_entity_t writer, dds_instance_handle_t reader) {
  dds_builtintopic_endpoint_t* endpoint = dds_get_matched_subscription_data(writer, reader);
  if (endpoint == nullptr) return {};  // gone meanwhile
  std::string text;
  void* data = nullptr;
  std::size_t size = 0;
  if (dds_qget_userdata(endpoint->qos, &data, &size) && data != nullptr) {
    text.assign(static_cast<const char*>(data), size);
    dds_free(data);
  }
  dds_builtintopic_free_endpoint(endpoint);
  return text;
}

}  // namespace

tl::unexpected<Error> failure(const std::string& what, dds_return_t code) {
  return fail(ErrorCode::kInternal, "DDS " + what + ": " + dds_strretcode(code));
}

Expected<Entity> createParticipant(const Domain& domain) {
  return owned(dds_create_participant(domain.id(), nullptr, nullptr), "a participant");
}

Expected<Entity> createTopic(const Entity& participant, const dds_topic_descriptor_t& type,
                             const char* name) {
  return owned(dds_create_topic(participant.get(), &type, name, nullptr, nullptr),
               std::string("topic ") + name);
}

Expected<Entity> createReader(const Entity& participant, const Entity& topic,
                              const EndpointOptions& options) {
  return owned(dds_create_reader(participant.get(), topic.get(), qosOf(options).get(), nullptr), "a reader");
}

Expected<Entity> createWriter(const Entity& participant, const Entity& topic,
                              const EndpointOptions& options) {
  return owned(dds_create_writer(participant.get(), topic.get(), qosOf(options).get(), nullptr), "a writer");
}

Expected<Entity> createReadCondition(const Entity& reader) {
  return owned(dds_create_readcondition(reader.get(), DDS_ANY_STATE), "a read condition");
}

Expected<Entity> createGuardCondition(const Entity& participant) {
  return owned(dds_create_guardcondition(participant.get()), "a guard condition");
}

std::vector<std::string> userDataOfReaders(const Entity& writer) {
  std::vector<dds_instance_handle_t> readers(kMostReaders);
  const dds_return_t count = dds_get_matched_subscriptions(writer.get(), readers.data(), readers.size());
  readers.resize(std::clamp<std::size_t>(count < 0 ? 0 : static_cast<std::size_t>(count), 0, kMostReaders));
  std::vector<std::string> all;
  all.reserve(readers.size());
  for (const dds_instance_handle_t reader : readers) all.push_back(userDataOf(writer.get(), reader));
  return all;
}

Expected<WaitSet> WaitSet::create(const Entity& participant) {
  return owned(dds_create_waitset(participant.get()), "a wait set").map([](Entity&& entity) {
    return WaitSet(std::move(entity));
  });
}

Expected<void> WaitSet::attach(const Entity& entity, dds_attach_t token) {
  const dds_return_t code = dds_waitset_attach(entity_.get(), entity.get(), token);
  if (code < 0) return failure("cannot attach to a wait set", code);
  return {};
}

Expected<std::vector<dds_attach_t>> WaitSet::wait(Clock::time_point until) {
  std::vector<dds_attach_t> tokens(kMostTokens);
  const dds_return_t count = dds_waitset_wait(entity_.get(), tokens.data(), tokens.size(), left(until));
  if (count < 0) return failure("cannot wait", count);
  tokens.resize(std::min(static_cast<std::size_t>(count), kMostTokens));
  return tokens;
}

Expected<std::unique_ptr<Loan>> Loan::take(const Entity& reader) {
  std::unique_ptr<Loan> loan(new Loan(reader.get()));
  const dds_return_t count = dds_take(reader.get(), loan->samples_, loan->infos_, kMost, kMost);
  if (count < 0) return failure("cannot take", count);
  loan->count_ = static_cast<std::size_t>(count);
  return loan;
}

Loan::~Loan() {
  if (count_ > 0) dds_return_loan(reader_, samples_, static_cast<std::int32_t>(count_));
}

}  // namespace underway::dds
