#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <memory>
#include <string>

#include "planner/plan_document.hpp"
#include "server/domain.hpp"
#include "server/question.hpp"
#include "server/served.hpp"
#include "tests/test_domain.hpp"

#ifdef __SANITIZE_THREAD__
// Debian's Cyclone DDS is not built for the thread sanitizer, which therefore sees its memory being copied
// and freed but not the atomics that order it. It never calls back into our code, so this hides no race of
// ours outside its calls.
extern "C" const char* __tsan_default_suppressions() { return "race:libddsc.so\n"; }
#endif

/// A served robot, a plan with everything a plan can hold, and a domain of this process's own.
namespace underway::fixture {

inline std::shared_ptr<const Domain> openDomain() {
  const Expected<std::shared_ptr<const Domain>> domain =
      Domain::open({.id = test::testDomain(), .use_network = false});
  EXPECT_TRUE(domain.has_value()) << domain.error().message;
  return *domain;
}

inline Served served() {
  Served served;
  served.robot.name = "nao";
  served.robot.modes.resize(3);
  served.robot.modes[0].name = "frontal";
  served.robot.modes[1].name = "lateral";
  served.robot.modes[2].name = "crawl";
  served.map_name = "scenario3";
  served.robot_hash = "fedcba9876543210";
  served.seed = 42;
  return served;
}

/// `offset` makes plans that differ: its bits are in many of the numbers.
inline Plan planWithEverything(double offset = 0.0) {
  const Pose a{0.1 + offset, 2.0 / 3.0, -0.0};
  const Pose b{3.3 + offset, 2.0 / 3.0, -0.0};
  const Pose c{3.3 + offset, 2.0 / 3.0, 1e-300};
  const Pose d{3.6 + offset, 0.7, 1e-300};
  Plan plan;
  plan.segments = {{{MotionKind::kTranslate, 0, 0, Sense::kBackward, a, b, 0.0},
                    47.1,
                    {0.12, Nearest{"wall_left", {2.05, 1.8}}, {}}},
                   {{MotionKind::kTurn, 0, 0, Sense::kForward, b, c, -6.3}, 37.0, {1.0, {}, 0.25}},
                   {{MotionKind::kSwitch, 0, 2, Sense::kForward, c, d, 0.0},
                    8.0,
                    {0.0, Nearest{"", {0.0, -1.0 / 7.0}}, -0.01}}};
  plan.total_time_s = 92.1 + offset;
  plan.length_m = 3.2;
  plan.goal = d;
  plan.stats = {2000, 30000, 3, 812.5, 92.25, 1e-3};
  plan.revision = 7;
  plan.world_hash = "0123456789abcdef";
  return plan;
}

inline Question question(std::string robot = "nao_1", double x = 0.1) {
  Question question;
  question.robot = std::move(robot);
  question.start = {x, 2.0 / 3.0, -0.0};
  question.start_mode = "frontal";
  question.goal = {5.4, 1.0 / 3.0};
  question.goal_yaw = 0.1;
  question.goal_mode = "crawl";
  question.policy = Policy::kSafest;
  question.max_detour = 2.5;
  return question;
}

/// What planning on the spot would have given.
inline PlanDocument documentFor(const Question& question, const Served& served, Expected<Plan> answer) {
  const std::uint64_t revision = answer ? answer->revision : answer.error().revision;
  const std::string world_hash = answer ? answer->world_hash : answer.error().world_hash;
  return {.request = {.start = question.start,
                      .start_mode = *served.robot.findMode(question.start_mode),
                      .goal = question.goal,
                      .goal_yaw = question.goal_yaw,
                      .goal_mode = *served.robot.findMode(question.goal_mode),
                      .policy = question.policy,
                      .max_detour = question.max_detour},
          .robot_name = served.robot.name,
          .mode_names = {"frontal", "lateral", "crawl"},
          .map_name = served.map_name,
          .revision = revision,
          .world_hash = world_hash,
          .robot_hash = served.robot_hash,
          .seed = served.seed,
          .answer = std::move(answer)};
}

}  // namespace underway::fixture
