#pragma once

#include <string>
#include <tl/expected.hpp>

namespace underway::gait {

/// Why a gait cannot be read or gone: one sentence (what, where, what to do).
struct GaitError {
  std::string message;
};

template <class T>
using GaitExpected = tl::expected<T, GaitError>;

}  // namespace underway::gait
