#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "apps/exit_code.hpp"

namespace underway {

/// `underway gait optimise`: a gait of one's own, for an aim, within limits. Returns what runs when it is
/// chosen.
[[nodiscard]] std::function<ExitCode()> addOptimise(CLI::App& gait_command, CLI::App*& command);

}  // namespace underway
