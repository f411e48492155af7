#include <fcntl.h>

#include <csignal>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "apps/commands.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"

namespace {

using underway::ExitCode;
using underway::Subcommand;

constexpr const char* kExamples =
    "Examples:\n"
    "  underway plan --map maps/scenario3.yaml --query under_the_table --svg plan.svg\n"
    "  underway serve --map maps/scenario3.yaml &\n"
    "  underway ask --start 0.6,2,0 --goal 5.4,2,0\n"
    "'underway COMMAND --help' tells more about each.";

ExitCode help(const CLI::App& program, const CLI::ParseError& asked) {
  std::ostringstream text;
  program.exit(asked, text, text);
  const underway::Expected<void> written = underway::writeOutput(text.str());
  if (written) return ExitCode::kDone;
  underway::complain(written.error().message);
  return ExitCode::kOther;
}

/// The name of an option that was given with nothing in it, as an unset variable of a shell does it; empty if
/// there is none.
std::string emptyOption(const CLI::App& command) {
  for (const CLI::Option* const option : command.get_options())
    for (const std::string& text : option->results())
      if (text.empty()) return option->get_name();
  for (const CLI::App* const subcommand : command.get_subcommands())
    if (std::string name = emptyOption(*subcommand); !name.empty()) return name;
  return {};
}

/// "plan, ask, ... or bench".
std::string listOf(const std::vector<Subcommand>& commands) {
  std::string text;
  for (std::size_t i = 0; i < commands.size(); ++i)
    text += (i == 0 ? "" : i + 1 < commands.size() ? ", " : " or ") + commands[i].app->get_name();
  return text;
}

/// What is wrong with the command line. A word that is not known goes first: what is missing may be meant by
/// it.
std::string sentenceOf(const CLI::ParseError& error, const CLI::App& program,
                       const std::vector<Subcommand>& commands) {
  const int code = error.get_exit_code();
  const bool may_be_misspelt = code == static_cast<int>(CLI::ExitCodes::RequiredError) ||
                               code == static_cast<int>(CLI::ExitCodes::ExtrasError);
  const std::vector<std::string> unknown = program.remaining(true);
  if (!may_be_misspelt || unknown.empty()) return error.what();
  if (program.get_subcommands().empty() && !unknown.front().starts_with('-'))
    return "\"" + unknown.front() + "\" is no command; give " + listOf(commands);
  return "\"" + unknown.front() + "\" is not known; --help tells what is";
}

ExitCode runCommandLine(int argc, char** argv) {
  CLI::App program("Plans how a humanoid gets from here to there: walking, sidestepping, crawling.",
                   "underway");
  program.require_subcommand(0, 1);  // none at all is told below, in our own words
  program.footer(kExamples);
  const std::vector<Subcommand> commands{
      underway::addPlanCommand(program),   underway::addAskCommand(program),
      underway::addChangeCommand(program), underway::addServeCommand(program),
      underway::addFollowCommand(program), underway::addSimCommand(program),
      underway::addRunCommand(program),    underway::addQueryCommand(program),
      underway::addCheckCommand(program),  underway::addGaitCommand(program),
      underway::addBenchCommand(program)};
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return help(program, error);
    underway::complain(sentenceOf(error, program, commands));
    return ExitCode::kInvalidInput;
  }
  if (const std::string flag = emptyOption(program); !flag.empty()) {
    underway::complain(flag + " is empty; leave it out, or say what");
    return ExitCode::kInvalidInput;
  }
  for (const Subcommand& command : commands)
    if (command.app->parsed()) return command.run();
  underway::complain("a command is missing; give " + listOf(commands) + ", or --help");
  return ExitCode::kInvalidInput;
}

/// Standard streams that are closed: no file or socket may get their numbers, and be written to as if it were
/// one of them. What is written there fails.
void openClosedStreams() {
  for (const int stream : {0, 1, 2})
    if (fcntl(stream, F_GETFD) == -1) (void)open("/dev/null", O_RDONLY);  // the lowest number that is free
}

}  // namespace

int main(int argc, char** argv) {
  openClosedStreams();
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is told by the failing write
  std::signal(SIGXFSZ, SIG_IGN);  // and so is a file that grows too large
  try {
    return static_cast<int>(runCommandLine(argc, argv));
  } catch (const std::bad_alloc&) {
    underway::complain("out of memory; give a smaller map");
  } catch (const std::exception& error) {
    underway::complain(std::string("a fault in the program: ") + error.what());
  }
  return static_cast<int>(ExitCode::kOther);
}
