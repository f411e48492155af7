#pragma once

#include <memory>
#include <optional>

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/roadmap.hpp"
#include "planner/settings.hpp"

namespace underway {

/// Grows a roadmap in numbered batches of fixed size. Batch k depends on world, robot, settings, seed and k
/// alone; time only decides after which batch it stops. Not for several threads at once.
///
/// A batch draws, with OMPL: sites for the modes that turn (uniform, near obstacles, between obstacles);
/// lines through low places for the modes that are lower; lines through narrow places for the modes that are
/// narrower. Each new place is connected to its nearest neighbours, and every connection is checked exactly.
class Growth {
 public:
  Growth(std::shared_ptr<const Checker> checker, GrowthSettings settings);
  ~Growth();

  /// Adds the next batch. When interrupted it returns false, and goes on where it stopped the next time: half
  /// a batch is no batch, and must not be frozen.
  bool addBatch(Interrupt& interrupt);
  void addBatch();
  /// The roadmap as grown; empty when interrupted.
  [[nodiscard]] std::optional<Roadmap> freeze(Interrupt& interrupt) const;
  [[nodiscard]] Roadmap freeze() const;

  /// Goes on from a frozen roadmap as if all of it had grown here: the batches to come are those that would
  /// have come after it. Its ways must be those that are free in checker()'s world. What has grown so far is
  /// dropped.
  void takeOver(const Roadmap& roadmap);

  /// Goes on in another revision of the world, from a roadmap whose ways are those that are free there; from
  /// nothing if it is empty.
  void moveTo(std::shared_ptr<const Checker> checker, const Roadmap& roadmap);
  [[nodiscard]] const std::shared_ptr<const Checker>& checker() const;

  [[nodiscard]] std::uint32_t batches() const;
  /// How many batches cover the floor as densely as the settings ask.
  [[nodiscard]] std::uint32_t batchesToCover() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace underway
