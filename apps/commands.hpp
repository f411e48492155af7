#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "apps/exit_code.hpp"

namespace underway {

/// A subcommand that was added to the program, and what runs when it is the one chosen.
struct Command {
  CLI::App* app = nullptr;  ///< owned by the program's CLI::App
  std::function<ExitCode()> run;
};

[[nodiscard]] Command addPlanCommand(CLI::App& program);    ///< plans on the spot
[[nodiscard]] Command addAskCommand(CLI::App& program);     ///< asks a server for a plan
[[nodiscard]] Command addChangeCommand(CLI::App& program);  ///< changes a server's world
[[nodiscard]] Command addServeCommand(CLI::App& program);   ///< answers over DDS until it is told to stop
[[nodiscard]] Command addQueryCommand(CLI::App& program);   ///< judges one pose in every mode
[[nodiscard]] Command addCheckCommand(CLI::App& program);   ///< judges a plan by the certificate alone
[[nodiscard]] Command addGaitCommand(CLI::App& program);    ///< makes gaits and shows them
[[nodiscard]] Command addBenchCommand(CLI::App& program);   ///< measures

}  // namespace underway
