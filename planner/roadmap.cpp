#include "planner/roadmap.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace underway {
namespace {

constexpr double kRounding_m = 1e-8;  // of clearances, which are told within a few nanometres

}  // namespace

void Roadmap::count() {
  const auto count_of = [&](LinkId link) { return static_cast<std::uint64_t>(std::popcount(ways[link])); };
  node_count = edge_count = 0;
  std::vector<std::uint64_t> leaving(places.size(), 0);
  for (LinkId link = 0; link < links.size(); ++link) leaving[links[link].from] += count_of(link);
  for (LinkId link = 0; link < links.size(); ++link) {
    node_count += count_of(link);
    edge_count += count_of(link) * leaving[links[link].to];
  }
}

bool isFreeKeeping(const Checker& checker, const Motion& motion, double keep_m) {
  const double margin = checker.robot().margin_m;
  if (keep_m >= margin) return checker.isFree(motion, keep_m);
  return checker.isFree(motion, 0.0) && checker.clearance(motion, margin) >= keep_m - kRounding_m;
}

double clearanceToKeep(const Checker& checker, ModeId mode, const Pose& pose) {
  const double margin = checker.robot().margin_m;
  const Motion standing = stay(mode, pose);
  if (checker.isFree(standing, margin)) return margin;
  // A corner can be within the grown body and yet further than the margin: just below it, distances decide.
  return std::min(checker.clearance(standing, margin), std::nextafter(margin, 0.0));
}

}  // namespace underway
