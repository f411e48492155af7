#include "gait/crawl/search_space.hpp"

#include <algorithm>

namespace underway::gait {
namespace {

constexpr double kMostRate = 6.0;  ///< rad per push, of knee and hip

}  // namespace

SearchSpace::SearchSpace(const PushShape& from, Ends ends, const PushLimits& limits)
    : from_(from), ends_(ends) {
  for (const Cubic* angle : {&from.knee, &from.hip})
    for (const double end : {0.0, 1.0}) add(-kMostRate, kMostRate, angle->rate(end));
  const double mean = from.alpha.at(1.0) - from.alpha.at(0.0);
  for (const double end : {0.0, 1.0}) add(limits.alpha_rate_most * mean, 0.0, from.alpha.rate(end));
  if (ends == Ends::kFixed) return;
  for (const double end : {0.0, 1.0}) add(limits.knee_least_rad, limits.knee_most_rad, from.knee.at(end));
  for (const double end : {0.0, 1.0}) add(limits.hip_least_rad, limits.hip_most_rad, from.hip.at(end));
}

PushShape SearchSpace::shapeAt(const std::vector<double>& p) const {
  const bool is_fixed = ends_ == Ends::kFixed;
  const auto end = [&](const Cubic& angle, double at, std::size_t index) {
    return is_fixed ? angle.at(at) : p[index];
  };
  return {cubicThrough(end(from_.knee, 0.0, 6), end(from_.knee, 1.0, 7), p[0], p[1]),
          cubicThrough(end(from_.hip, 0.0, 8), end(from_.hip, 1.0, 9), p[2], p[3]),
          cubicThrough(from_.alpha.at(0.0), from_.alpha.at(1.0), p[4], p[5])};
}

void SearchSpace::add(double least, double most, double start) {
  lower_.push_back(least);
  upper_.push_back(most);
  start_.push_back(std::clamp(start, least, most));
}

}  // namespace underway::gait
