#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "local/executor.hpp"

namespace underway {

/// Where plans come from: the planner in this process, or a server. Given what to plan and the world as the
/// robot knows it; errors as of Planner::plan, kNoServer when nobody answers, kBusy when the answer is not
/// there yet and is to be asked for again.
using PlanSource = std::function<Expected<Plan>(const Request&, const std::shared_ptr<const World>&)>;

/// Brings a robot to a goal: asks for a plan, has it executed, and when the world disagrees puts what was
/// seen into the world and asks again, from where the robot is.
class Mission {
 public:
  Mission(std::shared_ptr<const World> map, std::shared_ptr<const Robot> robot, Request request,
          PlanSource source, const ExecutorSettings& settings = {});

  enum class Outcome : std::uint8_t {
    kUnderway,
    kArrived,
    kNoWay,      ///< blocked, and there is no plan round what was seen: reported with `why`
    kNeedsHelp,  ///< fell, lost, or lies where it cannot get up
  };
  /// One tick; asks for a plan when it has to, which takes as long as the source does.
  [[nodiscard]] Tick tick(const Senses& senses);

  [[nodiscard]] Outcome outcome() const { return outcome_; }
  /// A sentence on what ended it, or on what it waits for.
  [[nodiscard]] const std::string& why() const { return why_; }
  [[nodiscard]] const Executor& executor() const { return executor_; }
  [[nodiscard]] const std::shared_ptr<const World>& world() const { return world_; }
  [[nodiscard]] int plans() const { return plans_; }

 private:
  /// What a plan is asked for: until the answer is there, the same.
  struct Question {
    Request request;
    std::shared_ptr<const World> known;  // the map, and what was seen
    std::shared_ptr<const World> world;  // to plan in: with more to keep off
  };
  void ask(const Senses& senses);
  void watchLocalisation(State state, double now_s);
  [[nodiscard]] Question question();
  [[nodiscard]] Expected<Plan> answer();
  [[nodiscard]] std::shared_ptr<const World> worldToPlanIn(const std::shared_ptr<const World>& known) const;
  [[nodiscard]] Expected<Plan> clearOfSurprises(Expected<Plan> plan, const Question& asked);
  [[nodiscard]] std::size_t cautionNow() const;
  [[nodiscard]] std::shared_ptr<const World> worldWithSurprises(const World& base) const;
  void countLooks(double left_s);
  void countInPlace();
  [[nodiscard]] std::string whyGivenUp() const;
  void refused(const Error& error, double now_s);

  std::shared_ptr<const World> map_;
  std::shared_ptr<const World> world_;
  std::shared_ptr<const Robot> robot_;
  Request request_;
  PlanSource source_;
  Executor executor_;
  Outcome outcome_ = Outcome::kUnderway;
  std::string why_;
  int plans_ = 0;
  int refusals_ = 0;
  int looks_ = 0;  // with less caution, that led to plans no nearer to the goal
  double least_left_s_ = std::numeric_limits<double>::infinity();  // of those plans
  std::size_t caution_ = 0;                                        // which one the next question begins with
  Point cautioned_at_;                                             // where that was found
  int in_place_ = 0;                                               // plans asked for from one place
  Point asked_at_;
  std::vector<std::string> berths_;  // what the next plan is to keep further from
  int berths_given_ = 0;             // since the last refusal
  bool may_tread_unseen_ = false;    // no plan keeps off the floor that was not seen
  double again_s_ = 0.0;             // when to ask again
  std::optional<Question> asked_;    // and not answered yet
  std::optional<double> unsure_s_;   // since when it does not know where it is
};

}  // namespace underway
