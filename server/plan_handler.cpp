#include "server/served.hpp"

namespace underway {
namespace {

Expected<Given> check(const Planner& planner, const Asked& asked) {
  auto left = remaining(asked.executing, *planner.checker());
  if (!left) return tl::unexpected(left.error());
  return Replanned{std::move(*left), false, "the plan may still be followed"};
}

}  // namespace

PlanHandler handlerFor(std::shared_ptr<Planner> planner) {
  return [planner = std::move(planner)](const Asked& asked, Planner::Clock::time_point deadline,
                                        const std::stop_token& stop) -> Expected<Given> {
    switch (asked.purpose) {
      case Purpose::kPlan:
        return planner->plan(asked.request, deadline, stop);
      case Purpose::kReplan:
        return replan(*planner, asked.executing, asked.request, deadline, asked.reluctance, stop);
      case Purpose::kCheck:
        return check(*planner, asked);
    }
    return fail(ErrorCode::kInvalidRequest, "there is no such kind of request");
  };
}

}  // namespace underway
