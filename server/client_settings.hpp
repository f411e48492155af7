#pragma once

#include <chrono>

namespace underway {

struct PlanClientSettings {
  std::chrono::milliseconds discovery{3000};    ///< how long to look for a server
  std::chrono::milliseconds first_resend{100};  ///< doubles with every resend, up to 1 s
};

}  // namespace underway
