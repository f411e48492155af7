#pragma once

#include "geometry/error.hpp"

namespace underway {

/// What the program ends with (formats: 'Exit codes').
enum class ExitCode : int {
  kDone = 0,          ///< a plan, or what else was asked for
  kOther = 1,         ///< anything else: an output that cannot be written, a busy server, a fault of ours
  kInvalidInput = 2,  ///< usage, or a file that cannot be used
  kNo = 3,            ///< a valid 'no': there is no such plan, none was found in time, or it is stale
  kNoServer = 4,
};

[[nodiscard]] constexpr ExitCode exitCodeOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::kStartInCollision:
    case ErrorCode::kGoalInCollision:
    case ErrorCode::kStartOutOfBounds:
    case ErrorCode::kGoalOutOfBounds:
    case ErrorCode::kNoPathExists:
    case ErrorCode::kTimeout:
    case ErrorCode::kStaleRevision:
      return ExitCode::kNo;
    case ErrorCode::kInvalidRequest:
    case ErrorCode::kInvalidMap:
    case ErrorCode::kInvalidRobot:
      return ExitCode::kInvalidInput;
    case ErrorCode::kNoServer:
      return ExitCode::kNoServer;
    case ErrorCode::kCancelled:
    case ErrorCode::kBusy:
    case ErrorCode::kInternal:
      return ExitCode::kOther;
  }
  return ExitCode::kOther;
}

}  // namespace underway
