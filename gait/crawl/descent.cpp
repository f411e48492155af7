// The search with NLopt of optimise.hpp.

#include <algorithm>
#include <limits>
#include <nlopt.hpp>

#include "gait/crawl/optimise.hpp"

namespace underway::gait {
namespace {

constexpr int kStepEvaluations = 100;
constexpr double kRandomShare = 0.75;  ///< of the evaluations, for the random search

/// Counts, and remembers the best point whatever the search does.
class Ledger {
 public:
  Ledger(const Objective& objective, int evaluations, const SearchProgress& progress)
      : objective_(objective), progress_(progress), evaluations_(evaluations) {
    found_.cost = std::numeric_limits<double>::infinity();
  }

  double cost(const std::vector<double>& point) {
    const double cost = objective_(point);
    sum_ += cost;
    ++found_.evaluations;
    if (cost < found_.cost) {
      found_.cost = cost;
      found_.point = point;
    }
    if (found_.evaluations % kStepEvaluations == 0) {
      found_.history.push_back({found_.cost, sum_ / kStepEvaluations});
      sum_ = 0.0;
      if (progress_) progress_(static_cast<double>(found_.evaluations) / evaluations_, found_.cost);
    }
    return cost;
  }
  [[nodiscard]] const Found& found() const { return found_; }

 private:
  const Objective& objective_;
  const SearchProgress& progress_;
  int evaluations_;
  double sum_ = 0.0;
  Found found_;
};

double callback(const std::vector<double>& point, std::vector<double>&, void* ledger) {
  return static_cast<Ledger*>(ledger)->cost(point);
}

void run(nlopt::algorithm algorithm, const SearchSpace& space, std::vector<double> start, int evaluations,
         Ledger& ledger) {
  nlopt::opt search(algorithm, static_cast<unsigned>(start.size()));
  search.set_lower_bounds(space.lower());
  search.set_upper_bounds(space.upper());
  search.set_min_objective(callback, &ledger);
  search.set_maxeval(evaluations);
  search.set_xtol_rel(1e-7);
  double cost = 0.0;
  try {
    search.optimize(start, cost);
  } catch (const nlopt::roundoff_limited&) {
    // As good as it gets; the ledger has the best point.
  }
}

}  // namespace

Found searchDescent(const Objective& objective, const SearchSpace& space, const DescentSettings& settings,
                    const SearchProgress& progress) {
  Ledger ledger(objective, settings.evaluations, progress);
  ledger.cost(space.start());
  nlopt::srand(settings.seed);
  const int random = static_cast<int>(kRandomShare * settings.evaluations);
  run(nlopt::GN_CRS2_LM, space, space.start(), random, ledger);
  run(nlopt::LN_SBPLX, space, ledger.found().point, settings.evaluations - ledger.found().evaluations,
      ledger);
  return ledger.found();
}

Objective objectiveFor(const Crawler& crawler, const ChainMasses& masses, const SearchSpace& space,
                       const PushSetting& setting, Aim aim) {
  constexpr double kPerViolation = 1e4;
  return [&crawler, masses, space, setting, aim](const std::vector<double>& point) {
    const PushFigures figures = evaluate(crawler, masses, space.shapeAt(point), setting);
    return costOf(figures, aim) + kPerViolation * figures.violation;
  };
}

}  // namespace underway::gait
