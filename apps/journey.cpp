#include "apps/journey.hpp"

#include <array>
#include <string>

#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"

namespace underway {

std::string describe(const JourneyEnd& end, const Journal& journal) {
  constexpr std::array kOutcomes{"stopped", "arrived", "found no way", "needs help"};
  std::string text = std::string(kOutcomes.at(static_cast<std::size_t>(end.outcome))) + " after " +
                     fixed(journal.time(), 1) + " s and " + std::to_string(journal.plans()) +
                     (journal.plans() == 1 ? " plan" : " plans");
  if (end.outcome != Mission::Outcome::kArrived && !end.why.empty()) text += ": " + printable(end.why);
  return text;
}

ExitCode exitCodeOf(const JourneyEnd& end) {
  switch (end.outcome) {
    case Mission::Outcome::kArrived:
      return ExitCode::kDone;
    case Mission::Outcome::kNoWay:
      return ExitCode::kNo;
    case Mission::Outcome::kNeedsHelp:
    case Mission::Outcome::kUnderway:
      break;
  }
  return ExitCode::kOther;
}

ExitCode deliverJourney(const Expected<JourneyEnd>& end, const Journal& journal) {
  if (!end) {
    complain(end.error().message);
    return exitCodeOf(end.error().code);
  }
  std::string sentence = "The robot ";
  sentence.append(describe(*end, journal)).append(".\n");
  if (const auto written = writeOutput(sentence); !written) complain(written.error().message);
  return exitCodeOf(*end);
}

}  // namespace underway
