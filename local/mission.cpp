#include "local/mission.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/checker.hpp"
#include "local/low.hpp"
#include "local/start.hpp"
#include "local/surprises.hpp"

namespace underway {
namespace {

constexpr int kMostRefusals = 4;   // of plans, with a fresh look between them
constexpr int kMostLooks = 4;      // with less caution, that led to a plan but no nearer
constexpr int kMostInPlace = 8;    // plans in a row that were not followed away from a place
constexpr double kNearer_s = 5.0;  // to the goal, than any of those before
constexpr int kMostBerths = 6;     // given one after the other, until a plan crawls beside nothing unmapped
constexpr double kLookAgain_s = 2.0;
constexpr double kAskAgain_s = 1.0;     // a server that is gone
constexpr double kMostUnsure_s = 30.0;  // standing still, not knowing where it is
constexpr double kSettles_s = 5.0;      // which takes no longer

constexpr const char* kBesideCrawl =
    "each plan found crawls close by something that is not in the map, which the robot cannot see while it "
    "lies; take it away, or give the robot a lidar on its head";

/// What was seen is first taken for more than points, for the noise, for corners and for what was not seen:
/// all together they leave no gaps for a body. Where that leaves no plan less is tried, which the guard
/// watches over all the same.
constexpr std::array kCautions{Caution{0.06, true}, Caution{0.04, false}, Caution{0.02, false}};

/// There is no plan in the world it was asked in: not that nobody answers, nor that the question is bad.
bool isNone(ErrorCode code) {
  return code == ErrorCode::kNoPathExists || code == ErrorCode::kTimeout ||
         code == ErrorCode::kGoalInCollision;
}

}  // namespace

Mission::Mission(std::shared_ptr<const World> map, std::shared_ptr<const Robot> robot, Request request,
                 PlanSource source, const ExecutorSettings& settings)
    : map_(std::move(map)),
      world_(map_),
      robot_(robot),
      request_(std::move(request)),
      source_(std::move(source)),
      executor_(std::move(robot), settings) {}

Tick Mission::tick(const Senses& senses) {
  Tick tick = executor_.tick(senses);
  watchLocalisation(tick.state, senses.now_s);
  switch (tick.state) {
    case State::kArrived:
      outcome_ = Outcome::kArrived;
      break;
    case State::kFallen:
      outcome_ = Outcome::kNeedsHelp, why_ = "the robot has fallen; get it up, then ask for a new plan";
      if (senses.has_fallen)
        asked_.reset();
      else if (executor_.isSettled())
        ask(senses);
      break;
    case State::kStalled:
      outcome_ = Outcome::kNeedsHelp;
      why_ = "the robot cannot go on: " + std::string(executor_.whyStalled()) +
             "; free it, then ask for a new plan";
      break;
    case State::kIdle:
    case State::kBlocked:
      ask(senses);
      break;
    default:
      break;
  }
  return tick;
}

/// Standing still until it knows where it is, but not for ever.
void Mission::watchLocalisation(State state, double now_s) {
  if (state != State::kLost && state != State::kSettling) {
    if (unsure_s_) why_.clear();
    unsure_s_.reset();
    return;
  }
  if (!unsure_s_) unsure_s_ = now_s;
  if (state == State::kSettling && now_s - *unsure_s_ < kSettles_s) return;
  why_ = state == State::kLost ? "localisation is silent; standing still until it is back"
                               : "localisation comes too seldom to know where the robot is; standing still";
  if (now_s - *unsure_s_ > kMostUnsure_s) outcome_ = Outcome::kNeedsHelp;
}

void Mission::ask(const Senses& senses) {
  if (senses.now_s < again_s_) return;
  if (!asked_) asked_ = question();
  auto plan = answer();
  if (!plan) return refused(plan.error(), senses.now_s);
  world_ = asked_->known;
  asked_.reset();
  ++plans_;
  countLooks(plan->total_time_s);
  countInPlace();
  caution_ = cautionNow();
  if (caution_ > 0 && refusals_ > 0) cautioned_at_ = executor_.pose().position();
  refusals_ = 0;
  may_tread_unseen_ = false;
  berths_.clear();
  berths_given_ = 0;
  why_ = whyGivenUp();
  outcome_ = why_.empty() ? Outcome::kUnderway : Outcome::kNoWay;
  if (outcome_ == Outcome::kNoWay) return;
  executor_.follow(std::move(*plan), world_, *map_);
}

/// Plans that less caution has led to, one after the other and none nearer to the goal, are to and fro.
void Mission::countLooks(double left_s) {
  if (cautionNow() == 0) return;
  if (left_s < least_left_s_ - kNearer_s) least_left_s_ = left_s, looks_ = 0;
  ++looks_;
}

void Mission::countInPlace() {
  constexpr double kAway_m = 0.1;
  const Point here = executor_.pose().position();
  in_place_ = distance(here, asked_at_) < kAway_m ? in_place_ + 1 : 0;
  if (in_place_ == 0) asked_at_ = here;
}

/// A sentence when the plans lead nowhere, though there are any; empty otherwise.
std::string Mission::whyGivenUp() const {
  if (in_place_ >= kMostInPlace) return "none of the last plans could be followed away from here";
  if (looks_ > kMostLooks)
    return "the last plans lead to and fro between blocked ways, and no nearer to the goal";
  return "";
}

Mission::Question Mission::question() {
  constexpr double kAway_m = 1.0;
  if (distance(executor_.pose().position(), cautioned_at_) > kAway_m) caution_ = 0;
  Question question{request_, world_, nullptr};
  if (plans_ > 0 || refusals_ > 0) question.known = worldWithSurprises(refusals_ == 0 ? *world_ : *map_);
  executor_.surprisesAreKnown();
  question.world = worldToPlanIn(question.known);
  if (plans_ == 0) return question;
  Request& request = question.request;
  // Too close by something for the guard: what is safest keeps further off, where there is room.
  if (executor_.isHeld()) request.policy = Policy::kSafest;
  request.start_mode = executor_.mode();
  const Checker checker(question.world, robot_);
  request.start = isLow(*robot_, request.start_mode)
                      ? executor_.pose()
                      : startFrom(checker, request.start_mode, executor_.pose());
  return question;
}

/// Busy: the answer is not there yet, or another question is better.
Expected<Plan> Mission::answer() {
  auto plan = source_(asked_->request, asked_->world);
  if (!plan && plan.error().code == ErrorCode::kBusy) return plan;
  const Question asked = *asked_;
  const bool is_none = !plan && isNone(plan.error().code);
  if (is_none && executor_.isHeld() && !may_tread_unseen_) {
    may_tread_unseen_ = true;
    asked_.reset();
    return fail(ErrorCode::kBusy, "waiting for a plan that may lead over floor that was not seen");
  }
  if (is_none && !berths_.empty() && plan.error().code != ErrorCode::kGoalInCollision)
    return fail(ErrorCode::kNoPathExists, kBesideCrawl);
  return clearOfSurprises(std::move(plan), asked);
}

/// With a berth round what the last plan crawled beside. Who was held may have come to floor that was not
/// seen: then plans keep off that too, if there are any.
std::shared_ptr<const World> Mission::worldToPlanIn(const std::shared_ptr<const World>& known) const {
  auto world = berths_.empty() ? known : std::make_shared<const World>(withBerth(*known, berths_));
  if (!executor_.isHeld() || may_tread_unseen_ || isLow(*robot_, executor_.mode())) return world;
  return std::make_shared<const World>(
      withUnseenFloor(*world, executor_.unseenFloor(), *robot_, executor_.mode(), executor_.pose()));
}

/// Who cannot see while it lies asks for another plan, that keeps further from what the last one crawls
/// beside.
Expected<Plan> Mission::clearOfSurprises(Expected<Plan> plan, const Question& asked) {
  if (!plan || robot_->senses.head) return plan;
  const auto beside = surprisesBesideCrawl(*plan, asked.known, robot_);
  if (beside.empty()) return plan;
  if (berths_given_++ >= kMostBerths) return fail(ErrorCode::kNoPathExists, kBesideCrawl);
  berths_.insert(berths_.end(), beside.begin(), beside.end());
  asked_.reset();
  return fail(ErrorCode::kBusy, "waiting for a plan that crawls further from what is not in the map");
}

void Mission::refused(const Error& error, double now_s) {
  why_ = error.message;
  if (error.code == ErrorCode::kBusy) return;  // asked again with the next tick, standing still
  asked_.reset();
  if (error.code == ErrorCode::kNoServer) {
    again_s_ = now_s + kAskAgain_s;  // it stands still meanwhile
    return;
  }
  again_s_ = now_s + kLookAgain_s;
  berths_given_ = 0;
  if (++refusals_ >= kMostRefusals || plans_ == 0) outcome_ = Outcome::kNoWay;
}

/// Where one has left no plan, less is tried; and what led to a plan is begun with, until it is away from
/// there.
std::size_t Mission::cautionNow() const {
  return std::min(caution_ + static_cast<std::size_t>(refusals_), kCautions.size() - 1);
}

std::shared_ptr<const World> Mission::worldWithSurprises(const World& base) const {
  return std::make_shared<const World>(withSurprises(base, executor_.surprises(), kCautions.at(cautionNow()),
                                                     *robot_, executor_.mode(), executor_.pose()));
}

}  // namespace underway
