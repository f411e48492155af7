#include "apps/rivals.hpp"

#include <string>

#include "apps/terminal.hpp"

namespace underway {

void complainOfRivals(std::size_t servers, std::uint32_t domain) {
  if (servers < 2) return;
  complain(
      std::to_string(servers) + " servers answer in DDS domain " + std::to_string(domain) +
      ", and this is the answer of one of them, whichever; stop all but one, or give each its own --domain");
}

}  // namespace underway
