// plan_judge PLAN.json MAP.yaml ROBOT.yaml [--unknown occupied|free]
// Judges a plan file by every sentence of the format, sharing no code with the planner.
// Exit code 0: sound. 3: one line for each violation. 2: the judge cannot read what it was given.

#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/judge/judge.hpp"

namespace {

constexpr int kSound = 0;
constexpr int kUnreadable = 2;
constexpr int kViolated = 3;

std::string textOf(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw judge::InputError(file + ": cannot be opened");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool has_unknown = arguments.size() == 5 && arguments[3] == "--unknown" &&
                           (arguments[4] == "free" || arguments[4] == "occupied");
  if (arguments.size() != 3 && !has_unknown) {
    std::cerr << "usage: plan_judge PLAN.json MAP.yaml ROBOT.yaml [--unknown occupied|free]\n";
    return kUnreadable;
  }
  const auto unknown =
      has_unknown && arguments[4] == "free" ? judge::Unknown::kFree : judge::Unknown::kOccupied;
  const judge::Verdict verdict = judge::judgePlan(
      textOf(arguments[0]), judge::readScene(arguments[1], unknown), judge::readRobotFile(arguments[2]));
  for (const std::string& note : verdict.notes) std::cout << "note: " << note << "\n";
  for (const std::string& violation : verdict.violations) std::cout << violation << "\n";
  if (verdict.isSound()) std::cout << "sound\n";
  return verdict.isSound() ? kSound : kViolated;
} catch (const std::exception& error) {
  std::cerr << "plan_judge: " << error.what() << "\n";
  return kUnreadable;
}
