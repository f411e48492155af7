#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "apps/exit_code.hpp"

namespace underway {

/// A subcommand that was added to the program, and what runs when it is the one chosen.
struct Subcommand {
  CLI::App* app = nullptr;  ///< owned by the program's CLI::App
  std::function<ExitCode()> run;
};

[[nodiscard]] Subcommand addPlanCommand(CLI::App& program);    ///< plans on the spot
[[nodiscard]] Subcommand addAskCommand(CLI::App& program);     ///< asks a server for a plan
[[nodiscard]] Subcommand addChangeCommand(CLI::App& program);  ///< changes a server's world
[[nodiscard]] Subcommand addServeCommand(CLI::App& program);   ///< answers over DDS until it is told to stop
[[nodiscard]] Subcommand addFollowCommand(CLI::App& program);  ///< drives a robot by a server's plans
[[nodiscard]] Subcommand addSimCommand(CLI::App& program);     ///< stands in for a robot
[[nodiscard]] Subcommand addRunCommand(CLI::App& program);     ///< all of that together, to look at
[[nodiscard]] Subcommand addQueryCommand(CLI::App& program);   ///< judges one pose in every mode
[[nodiscard]] Subcommand addCheckCommand(CLI::App& program);   ///< judges a plan by the certificate alone
[[nodiscard]] Subcommand addGaitCommand(CLI::App& program);    ///< makes gaits and shows them
[[nodiscard]] Subcommand addBenchCommand(CLI::App& program);   ///< measures

}  // namespace underway
