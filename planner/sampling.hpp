#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/checker.hpp"

namespace underway {

/// Draws free poses of one mode through OMPL's state space over (pose, mode) and its valid-state samplers.
/// The same seed draws the same poses. Not for several threads at once.
class PoseSampler {
 public:
  enum class Kind {
    kUniform,
    kGaussian,  ///< near obstacles (Boor, Overmars and van der Stappen 1999)
    kBridge,    ///< between obstacles (Hsu, Jiang, Reif and Sun 2003)
    kLowPlace,  ///< below what hangs above the mode's body, where the first mode is not free
  };

  /// `overhangs`: obstacles (by index) to look below for kLowPlace. The checker must outlive the sampler.
  PoseSampler(const Checker& checker, ModeId mode, std::vector<std::size_t> overhangs, std::uint64_t seed);
  ~PoseSampler();

  /// One free pose, or none after a fixed number of attempts.
  [[nodiscard]] std::optional<Pose> sample(Kind kind);

  /// The share of poses drawn uniformly over the bounds that are free, 0..1.
  [[nodiscard]] double freeShare(unsigned draws);

 private:
  struct Space;
  std::unique_ptr<Space> space_;
};

}  // namespace underway
