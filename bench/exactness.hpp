#pragma once

#include <cstdint>
#include <functional>

namespace underway::bench {

/// Told the share that is done, 0..1.
using ProgressSink = std::function<void(double)>;

/// How the engine's answers compare with the reference's (reference.hpp), FCL's booleans beside them. Further
/// than 1 um from contact is counted as clear; nearer, only a missed collision counts.
struct Exactness {
  std::uint64_t cases = 0;
  std::uint64_t collisions = 0;    ///< by the reference
  std::uint64_t near_contact = 0;  ///< within 1 um
  std::uint64_t missed = 0;        ///< collisions that the engine told free
  std::uint64_t false_alarms = 0;  ///< clear cases that the engine told to collide
  std::uint64_t fcl_missed = 0;    ///< deeper than 1 um, and not found by FCL (turns: sampled each 2 degrees)
  std::uint64_t fcl_false_alarms = 0;  ///< clear, and a collision to FCL
  std::uint64_t disagreements = 0;     ///< of the engine with itself: one by one, in a batch, by visiting
  std::uint64_t doubtful = 0;          ///< further than 1 um from contact, and the two references disagree
  std::uint64_t answers = 0;           ///< a fingerprint of all the engine's answers, near contact too
  void add(const Exactness& other);
};

/// How clearances compare with the reference's.
struct ClearanceExactness {
  std::uint64_t cases = 0;
  std::uint64_t above_truth = 0;  ///< told larger than they are
  double shortfall_of_poses_m =
      0.0;  ///< largest: how much less than the truth was told; of translations and switches too
  double shortfall_of_turns_m = 0.0;
  void add(const ClearanceExactness& other);
};

// Each draws its cases from a seed: plain, tilted, thin, tiny and huge boxes, near and far from the map's
// origin, many placed within nanometres of contact. Runs on all cores; the same on any number of them.

/// Bodies against obstacles, pair by pair.
[[nodiscard]] Exactness comparePairs(std::uint64_t seed, std::uint64_t pairs,
                                     const ProgressSink& progress = {});
/// Translations, turns and switches of a robot in crowded worlds.
[[nodiscard]] Exactness compareMotions(std::uint64_t seed, std::uint64_t motions,
                                       const ProgressSink& progress = {});
/// Clearances of poses and motions.
[[nodiscard]] ClearanceExactness compareClearances(std::uint64_t seed, std::uint64_t cases,
                                                   const ProgressSink& progress = {});

}  // namespace underway::bench
