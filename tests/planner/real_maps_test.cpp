#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>
#include <ostream>
#include <random>

#include "tests/planner/fixture.hpp"

// Real maps, used where they lie; they do not come with the project.
namespace underway {
namespace {

struct RealMap {
  const char* name;
  const char* file;  // below shared/maps/maps2d
  MapOptions options;
};

void PrintTo(const RealMap& map, std::ostream* out) { *out << map.file; }

MapOptions image(double resolution_m, double occupied, double free) {
  MapOptions options;
  options.resolution_m = resolution_m;
  options.occupied_thresh = occupied;
  options.free_thresh = free;
  return options;
}

/// Positions, 10 cm apart, where the body can turn all the way round, in the largest part that neighbours
/// join.
class OpenFloor {
 public:
  explicit OpenFloor(const Checker& checker) : bounds_(checker.world().bounds()) {
    columns_ = static_cast<int>(bounds_.width_m / kCell_m);
    rows_ = static_cast<int>(bounds_.height_m / kCell_m);
    std::vector<bool> open(static_cast<std::size_t>(columns_ * rows_));
    for (int cell = 0; cell < columns_ * rows_; ++cell)
      open[static_cast<std::size_t>(cell)] = checker.isFreeAllRound(0, at(cell), checker.robot().margin_m);
    for (int cell = 0; cell < columns_ * rows_; ++cell)
      if (open[static_cast<std::size_t>(cell)])
        if (auto part = partOf(cell, open); part.size() > largest_.size()) largest_ = std::move(part);
  }

  [[nodiscard]] bool isEmpty() const { return largest_.empty(); }
  Pose draw(std::mt19937& random) const {
    const int cell = largest_[std::uniform_int_distribution<std::size_t>(0, largest_.size() - 1)(random)];
    const double yaw = std::uniform_real_distribution(-std::numbers::pi, std::numbers::pi)(random);
    return {at(cell).x, at(cell).y, yaw};
  }

 private:
  static constexpr double kCell_m = 0.1;

  [[nodiscard]] Point at(int cell) const {
    return transform(bounds_.corner, {(cell % columns_ + 0.5) * kCell_m, (cell / columns_ + 0.5) * kCell_m});
  }

  /// The cells joined with one, which are open no more afterwards.
  std::vector<int> partOf(int first, std::vector<bool>& open) const {
    std::vector<int> part;
    const auto take = [&](int cell) {
      if (!open[static_cast<std::size_t>(cell)]) return;
      open[static_cast<std::size_t>(cell)] = false;
      part.push_back(cell);
    };
    take(first);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const int cell = part[i];
      if (cell % columns_ > 0) take(cell - 1);
      if (cell % columns_ + 1 < columns_) take(cell + 1);
      if (cell >= columns_) take(cell - columns_);
      if (cell + columns_ < columns_ * rows_) take(cell + columns_);
    }
    return part;
  }

  Bounds bounds_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> largest_;
};

class RealMaps : public ::testing::TestWithParam<RealMap> {};

TEST_P(RealMaps, RandomQueriesBetweenPosesInOnePartAreSolved) {
  const std::filesystem::path folder = UNDERWAY_SOURCE_DIR "/../shared/maps/maps2d";
  const auto file = folder / GetParam().file;
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << "NOT TESTED: " << GetParam().file << " is not on this machine";
  const auto map = readMap(file, GetParam().options);
  ASSERT_TRUE(map.has_value()) << map.error().message;
  Planner dut(std::make_shared<const World>(map->world), test::nao());
  dut.prepare(test::soon());
  const OpenFloor floor(*dut.checker());
  ASSERT_FALSE(floor.isEmpty());
  std::mt19937 random(1);
  for (int query = 0; query < 25; ++query) {
    const Request request = test::requestFor(floor.draw(random), floor.draw(random));
    const auto plan = dut.plan(request, test::soon());
    EXPECT_TRUE(plan.has_value()) << "query " << query << " from " << request.start.x << ","
                                  << request.start.y << "," << request.start.yaw << " to " << request.goal.x
                                  << "," << request.goal.y << "," << *request.goal_yaw << ": "
                                  << plan.error().message;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Maps, RealMaps,
    ::testing::Values(RealMap{"willow_10cm", "willow_0.10/willow-2010-02-18-0.10.yaml", {}},
                      RealMap{"willow_5cm", "willow_0.05/willow-full-0.05.pgm", image(0.05, 0.65, 0.196)},
                      RealMap{"utexas_3ne", "utexas_gdc_3ne/3ne.yaml", {}},
                      RealMap{"freiburg_079", "freiburg_079/freiburg.png", image(0.05, 0.2, 0.05)},
                      RealMap{"rail_lab", "gt_rail/rail_lab.yaml", {}},
                      RealMap{"ilab", "gt_rail/ilab.yaml", {}},
                      RealMap{"ipa_apartment", "ipa_apartment/map.yaml", {}},
                      RealMap{"kth_floor", "strands_kth/map.yaml", {}}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace underway
