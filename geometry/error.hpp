#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace underway {

/// Why a request was not answered with a plan. The wire (idl/underway.idl) mirrors this list, value by value.
enum class ErrorCode {
  kStartInCollision,
  kGoalInCollision,
  kStartOutOfBounds,
  kGoalOutOfBounds,
  kNoPathExists,  ///< proven: no plan exists at all
  kTimeout,       ///< no plan found in the time given; one may exist
  kCancelled,
  kBusy,
  kInvalidRequest,
  kInvalidMap,
  kInvalidRobot,
  kStaleRevision,
  kNoServer,
  kInternal,
};
inline constexpr int kErrorCodeCount = 14;

/// One obstacle in the way, and what is missing there.
struct Blocking {
  std::string obstacle;  ///< obstacle id
  std::string mode;      ///< mode that does not fit
  std::string of;        ///< "height", "width", "length" or "switch"
  double needs_m = 0.0;  ///< what the mode needs [m]
  double has_m = 0.0;    ///< what the place leaves [m]
};

/// An expected failure: a code for programs, one sentence (what, where, what to do) for people.
struct Error {
  ErrorCode code = ErrorCode::kInternal;
  std::string message;
  std::vector<Blocking> blocking;
  std::uint64_t revision = 0;   ///< of the world it is about; 0: of none
  std::string world_hash = {};  ///< of that world
};

template <class T>
using Expected = tl::expected<T, Error>;

/// `return fail(ErrorCode::kInvalidMap, "...")` from any function that returns an Expected.
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
  return tl::unexpected<Error>(Error{code, std::move(message), {}});
}

/// The code's name in snake_case, as formats and the wire print it: "start_in_collision".
[[nodiscard]] std::string_view name(ErrorCode code);

}  // namespace underway
