#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "planner/plan_document.hpp"
#include "planner/replan.hpp"
#include "server/question.hpp"

namespace underway {

/// What a server plans in and for. Every reply says it. Which revision of the world it is about, each answer
/// says by itself.
struct Served {
  Robot robot;
  std::string map_name;
  std::string robot_hash;
  std::uint64_t seed = 0;  ///< of the roadmap
};

/// A Question in the server's words.
struct Asked {
  Request request;
  Purpose purpose = Purpose::kPlan;
  Executing executing = {};  ///< unless only a plan is asked for
  Reluctance reluctance = {};
};

/// A plan and, if another one was being followed, how it was chosen.
struct Given {
  Given() = default;
  // NOLINTBEGIN(google-explicit-constructor): either is a whole answer
  Given(Plan made) : plan(std::move(made)) {}
  Given(Replanned made) : plan(std::move(made.plan)), choice(Choice{made.is_new, std::move(made.why)}) {}
  // NOLINTEND(google-explicit-constructor)
  Plan plan;
  std::optional<Choice> choice;
};

/// Answers one request; called from several threads at once. Should return kTimeout when the deadline passes
/// and kCancelled when told to stop.
using PlanHandler = std::function<Expected<Given>(
    const Asked&, std::chrono::steady_clock::time_point deadline, std::stop_token)>;

/// Answers by a planner, in its world as it is by then.
[[nodiscard]] PlanHandler handlerFor(std::shared_ptr<Planner> planner);

}  // namespace underway
