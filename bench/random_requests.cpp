#include "bench/random_requests.hpp"

#include <limits>
#include <numbers>

namespace underway::bench {

std::optional<Pose> randomPose(const Checker& checker, double margin_m, std::mt19937_64& random) {
  constexpr int kDraws = 1'000'000;
  const Bounds& bounds = checker.world().bounds();
  std::uniform_real_distribution<double> x(0.0, bounds.width_m);
  std::uniform_real_distribution<double> y(0.0, bounds.height_m);
  std::uniform_real_distribution<double> yaw(-std::numbers::pi, std::numbers::pi);
  for (int draw = 0; draw < kDraws; ++draw) {
    const double along = x(random);
    const double across = y(random);
    const Point at = transform(bounds.corner, {along, across});
    const Pose pose{at.x, at.y, yaw(random)};
    if (checker.isFree(stay(0, pose), margin_m)) return pose;
  }
  return std::nullopt;
}

std::vector<std::vector<Request>> randomRequests(const Checker& checker, Policy policy, std::size_t starts,
                                                 std::size_t goals, unsigned long seed) {
  // A start or goal that is closer to something than safest asks for would decide the clearance alone.
  const double margin_m = policy == Policy::kSafest ? kEnoughClearance_m : checker.robot().margin_m;
  std::mt19937_64 random(seed);
  std::vector<std::vector<Request>> requests;
  for (std::size_t i = 0; i < starts; ++i) {
    const auto start = randomPose(checker, margin_m, random);
    if (!start) break;
    std::vector<Request> of_start;
    for (std::size_t k = 0; k < goals; ++k) {
      const auto goal = randomPose(checker, margin_m, random);
      if (!goal) break;
      Request request{*start, 0, goal->position(), goal->yaw, 0, policy};
      request.max_detour = std::numeric_limits<double>::infinity();
      of_start.push_back(request);
    }
    requests.push_back(std::move(of_start));
  }
  return requests;
}

}  // namespace underway::bench
