#pragma once

#include <memory>
#include <string>

#include "planner/attach.hpp"
#include "planner/grow.hpp"
#include "planner/search.hpp"
#include "tests/planner/fixture.hpp"

namespace underway::test {

/// A map of ours with a small roadmap, and the ways that a search finds on it, before any shortening.
class FoundWay {
 public:
  FoundWay(const std::string& map, Policy policy)
      : checker_(std::make_shared<const Checker>(ourWorld(map), nao())), stances_(*checker_, policy) {
    Growth growth(checker_, {1, 3.0});
    for (int i = 0; i < 4; ++i) growth.addBatch();
    roadmap_ = growth.freeze();
  }

  [[nodiscard]] std::optional<Passage> way(const Request& request) const {
    Interrupt never(soon(), {});
    const auto attached = attach(*checker_, stances_, roadmap_, request, Effort::kNearest, never);
    LinkChecks checks(attached->graph, *checker_);
    return search(attached->graph, stances_, checker_->robot(), checks, attached->target, never);
  }
  [[nodiscard]] const Checker& checker() const { return *checker_; }
  [[nodiscard]] const Stances& stances() const { return stances_; }
  [[nodiscard]] Cost costOf(const Route& route) const {
    return underway::costOf(checker_->robot(), stances_.policy(), route);
  }

 private:
  std::shared_ptr<const Checker> checker_;
  Stances stances_;
  Roadmap roadmap_;
};

}  // namespace underway::test
