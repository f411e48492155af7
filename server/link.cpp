#include "server/link.hpp"

#include "idl/underway.h"

namespace underway {

Expected<Link> Link::open(std::shared_ptr<const Domain> domain) {
  FirstError first;
  Link link;
  link.participant = first.unwrap(dds::createParticipant(*domain));
  link.domain = std::move(domain);
  link.request_topic =
      first.unwrap(dds::createTopic(link.participant, underway_PlanRequest_desc, "underway/plan_request"));
  link.reply_topic =
      first.unwrap(dds::createTopic(link.participant, underway_PlanReply_desc, "underway/plan_reply"));
  link.wait_set = first.unwrap(dds::WaitSet::create(link.participant));
  if (first.error()) return tl::unexpected(*first.error());
  return link;
}

}  // namespace underway
