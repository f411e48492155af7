#include "server/link.hpp"

#include "idl/underway.h"

namespace underway {

Topics planTopics() {
  return {underway_PlanRequest_desc, "underway/plan_request", underway_PlanReply_desc, "underway/plan_reply"};
}

Topics changeTopics() {
  return {underway_ChangeRequest_desc, "underway/change_request", underway_ChangeReply_desc,
          "underway/change_reply"};
}

Expected<Link> Link::open(std::shared_ptr<const Domain> domain, const Topics& topics) {
  FirstError first;
  Link link;
  link.participant = first.unwrap(dds::createParticipant(*domain));
  link.domain = std::move(domain);
  link.request_topic = first.unwrap(dds::createTopic(link.participant, topics.request, topics.request_name));
  link.reply_topic = first.unwrap(dds::createTopic(link.participant, topics.reply, topics.reply_name));
  link.wait_set = first.unwrap(dds::WaitSet::create(link.participant));
  if (first.error()) return tl::unexpected(*first.error());
  return link;
}

}  // namespace underway
