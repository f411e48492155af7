// The genetic algorithm of optimise.hpp.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "gait/crawl/optimise.hpp"

namespace underway::gait {
namespace {

constexpr std::size_t kElite = 2;
constexpr double kCrossed = 0.8;    ///< share of the children that have two parents
constexpr double kFirstStep = 0.5;  ///< of a mutation, as a share of the box
constexpr double kLeastStep = 0.01;

struct Individual {
  std::vector<double> point;
  double cost = 0.0;
};

class Population {
 public:
  Population(const Objective& objective, const SearchSpace& space, const GeneticSettings& settings)
      : objective_(objective), space_(space), random_(settings.seed) {
    individuals_.push_back(judged(space.start()));
    while (individuals_.size() < static_cast<std::size_t>(settings.population))
      individuals_.push_back(judged(anywhere()));
    rank();
  }

  void breed(double share_done) {
    std::vector<Individual> next(individuals_.begin(), individuals_.begin() + kElite);
    const double step = kLeastStep + (kFirstStep - kLeastStep) * std::pow(1.0 - share_done, 2.0);
    while (next.size() < individuals_.size())
      next.push_back(judged(uniform(0.0, 1.0) < kCrossed ? crossed() : mutated(parent(), step)));
    individuals_ = std::move(next);
    rank();
  }

  [[nodiscard]] const Individual& best() const { return individuals_.front(); }
  [[nodiscard]] int evaluations() const { return evaluations_; }
  [[nodiscard]] double mean() const {
    const double sum = std::accumulate(individuals_.begin(), individuals_.end(), 0.0,
                                       [](double s, const Individual& i) { return s + i.cost; });
    return sum / static_cast<double>(individuals_.size());
  }

 private:
  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1.0p-53;
  }
  double normal() {
    return std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0))) * std::cos(2.0 * M_PI * uniform(0.0, 1.0));
  }

  Individual judged(std::vector<double> point) {
    ++evaluations_;
    const double cost = objective_(point);
    return {std::move(point), cost};
  }

  std::vector<double> anywhere() {
    std::vector<double> point(space_.start().size());
    for (std::size_t i = 0; i < point.size(); ++i) point[i] = uniform(space_.lower()[i], space_.upper()[i]);
    return point;
  }

  /// The r-th best has a weight of 1 / sqrt(r).
  const std::vector<double>& parent() {
    const double draw = uniform(0.0, std::sqrt(static_cast<double>(individuals_.size())));
    return individuals_[std::min(individuals_.size() - 1, static_cast<std::size_t>(draw * draw))].point;
  }

  std::vector<double> crossed() {
    std::vector<double> child = parent();
    const std::vector<double>& other = parent();
    for (std::size_t i = 0; i < child.size(); ++i)
      if (uniform(0.0, 1.0) < 0.5) child[i] = other[i];
    return child;
  }

  std::vector<double> mutated(std::vector<double> point, double step) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double width = space_.upper()[i] - space_.lower()[i];
      point[i] = std::clamp(point[i] + step * width * normal(), space_.lower()[i], space_.upper()[i]);
    }
    return point;
  }

  void rank() { std::ranges::stable_sort(individuals_, {}, &Individual::cost); }

  const Objective& objective_;
  const SearchSpace& space_;
  std::mt19937_64 random_;
  std::vector<Individual> individuals_;
  int evaluations_ = 0;
};

}  // namespace

Found searchGenetic(const Objective& objective, const SearchSpace& space, const GeneticSettings& settings,
                    const SearchProgress& progress) {
  Population population(objective, space, settings);
  Found found;
  for (int generation = 0; generation < settings.generations; ++generation) {
    found.history.push_back({population.best().cost, population.mean()});
    const double share = static_cast<double>(generation) / settings.generations;
    if (progress) progress(share, population.best().cost);
    population.breed(share);
  }
  found.history.push_back({population.best().cost, population.mean()});
  found.point = population.best().point;
  found.cost = population.best().cost;
  found.evaluations = population.evaluations();
  return found;
}

}  // namespace underway::gait
