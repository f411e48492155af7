#pragma once

#include <string>
#include <string_view>

#include "gait/crawl/gait.hpp"

namespace underway::gait {

/// A gait as it lies in the library (gaits/NAME.json): the gait, and where it comes from.
struct GaitFile {
  CrawlGait gait;
  std::string about;              ///< what it is good for, in a line or two
  double for_push_s_least = 0.0;  ///< the durations of a push it is offered for [s]
  double for_push_s_most = 0.0;
};

/// Lengths in metres, times in seconds, angles in radians; numbers print so that they read back bit for bit.
[[nodiscard]] std::string toJson(const GaitFile& file);

/// Errors: a sentence that names `where` and the field. Fields that are not known are refused.
[[nodiscard]] GaitExpected<GaitFile> gaitFromJson(std::string_view text, const std::string& where);

}  // namespace underway::gait
