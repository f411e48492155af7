#include "bench/peers/peer.hpp"

#include <ompl/base/ProblemDefinition.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <thread>

#include "bench/peers/forked.hpp"
#include "bench/peers/validity.hpp"

namespace underway::bench {
namespace {

namespace og = ompl::geometric;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLook{1};  // how often the best cost is looked at
constexpr const char* kRestarting = "RRTConnect";

ob::PlannerPtr makePlanner(const std::string& name, const ob::SpaceInformationPtr& space) {
  if (name == "PRM") return std::make_shared<og::PRM>(space);
  if (name == "PRMstar") return std::make_shared<og::PRMstar>(space);
  if (name == "LazyPRMstar") return std::make_shared<og::LazyPRMstar>(space);
  if (name == "BITstar") return std::make_shared<og::BITstar>(space);
  return std::make_shared<og::RRTConnect>(space);
}

/// One query, set up as a user would, and its clock.
class Solver {
 public:
  Solver(const std::string& name, const Task& task, const std::function<void(Sample)>& tell)
      : task_(task),
        tell_(tell),
        deadline_(start_ + std::chrono::microseconds(std::llround(task.limit_s * 1e6))) {
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(task.seed);
    space_ = std::make_shared<ob::SpaceInformation>(makeSpace(*task.world, *task.robot));
    validity_ = std::make_shared<FclValidity>(space_, *task.world, *task.robot);
    space_->setStateValidityChecker(validity_);
    space_->setMotionValidator(std::make_shared<ModeMotionValidator>(space_, *validity_, *task.robot));
    space_->setup();
    objective_ = std::make_shared<TimeObjective>(space_, *task.robot);
    problem_ = std::make_shared<ob::ProblemDefinition>(space_);
    setEnds();
    problem_->setOptimizationObjective(objective_);
    planner_ = makePlanner(name, space_);
    planner_->setProblemDefinition(problem_);
    planner_->setup();
    // OMPL's timed condition looks at a thread's flag; this one looks at the clock itself as well.
    until_ = std::make_shared<ob::PlannerTerminationCondition>([this] { return Clock::now() >= deadline_; });
  }

  void solve() {
    std::atomic<bool> is_done = false;
    std::thread watching([&] {
      while (!is_done) {
        tellProgress();
        std::this_thread::sleep_for(kLook);
      }
    });
    planner_->solve(*until_);
    is_done = true;
    watching.join();
    tellPath();
  }

  /// Again and again from nothing, each path simplified.
  void solveAgainAndAgain() {
    og::PathSimplifier simplifier(space_, problem_->getGoal(), objective_);
    while (Clock::now() < deadline_) {
      planner_->clear();
      problem_->clearSolutionPaths();
      planner_->solve(*until_);
      if (!problem_->hasExactSolution()) continue;
      tellPath();
      simplifier.simplify(*problem_->getSolutionPath()->as<og::PathGeometric>(), *until_);
      tellPath();
    }
  }

 private:
  void setEnds() {
    const Request& request = task_.request;
    ob::ScopedState<> start(space_);
    ob::ScopedState<> goal(space_);
    setState(*start.get(), request.start, request.start_mode);
    setState(*goal.get(), {request.goal.x, request.goal.y, request.goal_yaw.value_or(0.0)},
             request.goal_mode);
    problem_->setStartAndGoalStates(start, goal);
  }

  void tell(double cost_s) {
    const std::lock_guard lock(telling_);
    if (!std::isfinite(cost_s) || cost_s <= 0.0 || cost_s >= best_s_) return;
    best_s_ = cost_s;
    tell_({std::chrono::duration<double>(Clock::now() - start_).count(), cost_s});
  }

  /// What the planner itself says of its best path, as OMPL's own benchmark asks it.
  void tellProgress() {
    for (const auto& [name, value] : planner_->getPlannerProgressProperties())
      if (name.rfind("best cost", 0) == 0) tell(std::strtod(value().c_str(), nullptr));
  }

  void tellPath() {
    if (problem_->hasExactSolution()) tell(problem_->getSolutionPath()->cost(objective_).value());
  }

  const Task& task_;
  const std::function<void(Sample)>& tell_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point deadline_;
  ob::SpaceInformationPtr space_;
  std::shared_ptr<FclValidity> validity_;
  ob::OptimizationObjectivePtr objective_;
  ob::ProblemDefinitionPtr problem_;
  ob::PlannerPtr planner_;
  std::shared_ptr<ob::PlannerTerminationCondition> until_;
  std::mutex telling_;
  double best_s_ = INFINITY;
};

}  // namespace

std::vector<std::string> peerNames() { return {"PRM", "PRMstar", "LazyPRMstar", kRestarting, "BITstar"}; }

Run runPeer(const std::string& name, const Task& task) {
  return runForked(task.limit_s, [&](const std::function<void(Sample)>& tell) {
    try {
      Solver solver(name, task, tell);
      name == kRestarting ? solver.solveAgainAndAgain() : solver.solve();
    } catch (const std::exception&) {
      // OMPL refuses a start or goal that is not valid: such a run has no plan, which is what the empty
      // progress says.
    }
  });
}

}  // namespace underway::bench
