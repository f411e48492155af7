#include "planner/impossible.hpp"

#include <chrono>

#include "planner/planner.hpp"
#include "planner/proof/blame.hpp"

namespace underway {
namespace {

/// For a plan in a world with an obstacle less: where there is one, it is mostly found at once.
constexpr std::chrono::milliseconds kEnough{700};

}  // namespace

std::optional<Error> provenImpossible(const Checker& checker, const Request& request,
                                      const GrowthSettings& settings, Interrupt& interrupt) {
  const auto proof = proof::proveNoPath(checker, request, interrupt);
  if (!proof) return std::nullopt;
  const auto robot = std::make_shared<const Robot>(checker.robot());
  const auto is_solvable = [&](const std::shared_ptr<const World>& world) {
    const auto enough = Interrupt::Clock::now() + kEnough;
    return Planner(world, robot, settings)
        .findPlan(request, std::min(enough, interrupt.deadline()), interrupt.stop())
        .has_value();
  };
  const proof::Blame blame = proof::blame(checker, *proof, is_solvable, interrupt);
  const std::size_t goals = 1 + request.other_goals.size();
  std::string message = "no path exists";
  if (goals > 1) message += " to any of " + std::to_string(goals) + " goals";
  if (!blame.sentence.empty()) message += ": " + blame.sentence;
  return Error{ErrorCode::kNoPathExists, std::move(message), blame.blocking};
}

}  // namespace underway
