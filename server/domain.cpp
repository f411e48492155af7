#include "server/domain.hpp"

#include <dds/dds.h>

#include <cstdlib>
#include <string>

namespace underway {
namespace {

// 1 s of lease: a killed server is noticed in 1.2 s instead of 10 s. No linger: deleting a writer never waits
// for a client that hangs (ReplyPost::flush waits for all of them together instead).
constexpr const char* kAlways =
    "<CycloneDDS><Domain Id=\"any\">"
    "<Discovery><LeaseDuration>1 "
    "s</LeaseDuration><MaxAutoParticipantIndex>120</MaxAutoParticipantIndex></Discovery>"
    "<Internal><WriterLingerDuration>0 s</WriterLingerDuration></Internal>"
    "</Domain></CycloneDDS>";

// Unicast to this machine alone. Without multicast, participants find each other by their index.
constexpr const char* kLoopback =
    "<CycloneDDS><Domain Id=\"any\">"
    "<General><Interfaces><NetworkInterface name=\"lo\" multicast=\"false\"/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex><Peers><Peer "
    "Address=\"127.0.0.1\"/></Peers></Discovery>"
    "</Domain></CycloneDDS>";

/// Cyclone DDS reads a comma-separated list; later parts go before earlier ones.
std::string configuration(const DomainSettings& settings) {
  std::string text = kAlways;
  const char* uri = std::getenv("CYCLONEDDS_URI");
  if (uri != nullptr && *uri != '\0')
    text.append(",").append(uri);
  else if (!settings.use_network)
    text.append(",").append(kLoopback);
  if (!settings.tag.empty())
    text.append(",<CycloneDDS><Domain Id=\"any\"><Discovery><Tag>")
        .append(settings.tag)
        .append("</Tag></Discovery></Domain></CycloneDDS>");
  return text;
}

}  // namespace

Expected<std::shared_ptr<const Domain>> Domain::open(const DomainSettings& settings) {
  const std::string label = "DDS domain " + std::to_string(settings.id);
  if (settings.id > kLargestId)
    return fail(ErrorCode::kInvalidRequest,
                label + " does not exist: choose an id from 0 to " + std::to_string(kLargestId));
  const dds_entity_t handle = dds_create_domain(settings.id, configuration(settings).c_str());
  if (handle == DDS_RETCODE_PRECONDITION_NOT_MET)
    return fail(ErrorCode::kInvalidRequest, label + " is already open in this process: share the open one");
  if (handle < 0)
    return fail(ErrorCode::kInvalidRequest,
                label + " cannot be opened (" + dds_strretcode(handle) +
                    "): check CYCLONEDDS_URI if it is set, or the network interfaces");
  return std::shared_ptr<const Domain>(new Domain(settings.id, handle));
}

Domain::~Domain() { dds_delete(handle_); }

}  // namespace underway
