#include "planner/proof/blame.hpp"

#include <algorithm>
#include <map>

#include "planner/proof/need.hpp"
#include "planner/proof/way.hpp"

namespace underway {
namespace {

using Set = std::vector<std::size_t>;  // of obstacles, as indices into the world's

constexpr int kMostRounds = 8;               // of adding obstacles until a way opens
constexpr std::size_t kMostLacks = 8;        // that are looked at until one is decisive
constexpr std::size_t kCellsBesides = 4000;  // that a question about a changed world is worth, at least

Set without(Set set, std::size_t one) {
  set.erase(std::remove(set.begin(), set.end(), one), set.end());
  return set;
}

class Culprits {
 public:
  Culprits(const Checker& checker, const Proof& proof, const IsSolvable& is_solvable, Interrupt& interrupt)
      : checker_(checker), proof_(proof), is_solvable_(is_solvable), interrupt_(interrupt) {}

  Blame blame() && {
    Blame result;
    const bool is_enough = gather();
    result.is_irreducible = is_enough && reduce();
    for (const std::size_t obstacle : all_) {
      const auto lack = lackOf(obstacle);
      const std::string& id = checker_.world().obstacles()[obstacle].id;
      result.blocking.push_back(lack ? lack->blocking : Blocking{id, "", "", 0.0, 0.0});
      if (!result.sentence.empty()) result.sentence += "; ";
      result.sentence += lack ? sentenceOf(*lack, checker_.world()) : id + " is in the way";
    }
    if (all_.empty())
      result.sentence = "it is not obstacles that are in the way: bounds and modes leave none";
    return result;
  }

 private:
  /// Obstacles without which there is a way as far as a relaxation can tell, those first at which least is
  /// missing; and whether the planner knows the way.
  bool gather() {
    for (int round = 0; round < kMostRounds && !interrupt_.isDueNow(); ++round) {
      Relaxation relaxation = proof_.relaxation;
      relaxation.lift(all_, std::nullopt, interrupt_);
      if (!all_.empty() && !isClosed(relaxation)) return isSolvableWithout(all_);
      const auto weight = [&](std::size_t obstacle) { return weightOf(obstacle); };
      const auto more = WaySearch().fewestBlockers(relaxation, weight, interrupt_);
      if (!more || more->empty()) return false;
      all_.insert(all_.end(), more->begin(), more->end());
    }
    return false;
  }

  /// Leaves out, one by one, those without which there is a way as well. Whether each that is left is shown
  /// to be needed.
  bool reduce() {
    bool is_shown = true;
    for (const std::size_t one : Set(all_)) {
      const Set others = without(all_, one);
      Relaxation relaxation = proof_.relaxation;
      relaxation.lift(others, std::nullopt, interrupt_);
      if (others.empty() || isClosed(relaxation)) continue;
      if (isSolvableWithout(others))
        all_ = others;
      else
        is_shown = false;
    }
    return is_shown;
  }

  /// What is missing least of what is decisive: if the obstacle were not there for that shape alone, or if
  /// what is on the other side of the gap were not there at all, a way would open, the other obstacles gone.
  std::optional<Lack> lackOf(std::size_t obstacle) {
    Relaxation relaxation = proof_.relaxation;
    relaxation.lift(without(all_, obstacle), std::nullopt, interrupt_);
    const std::vector<Lack> lacks = lacksAt(checker_, relaxation.stances(), obstacle);
    std::map<std::pair<std::size_t, std::optional<std::size_t>>, bool> known;
    const auto opens = [&](std::size_t lifted, std::optional<std::size_t> shape) {
      const auto [at, is_new] = known.try_emplace({lifted, shape}, false);
      if (is_new) at->second = opensWithout(relaxation, lifted, shape);
      return at->second;
    };
    for (const Lack& lack : lacks) {
      if (known.size() >= kMostLacks || interrupt_.isDueNow()) break;
      if (opens(obstacle, lack.shape) && (!lack.partner || opens(*lack.partner, std::nullopt))) return lack;
    }
    return lacks.empty() ? std::nullopt : std::optional(lacks.front());
  }

  bool opensWithout(Relaxation relaxation, std::size_t obstacle, std::optional<std::size_t> shape) {
    relaxation.lift(std::span(&obstacle, 1), shape, interrupt_);
    return !isClosed(relaxation) && !interrupt_.isDueNow();
  }

  bool isClosed(Relaxation& relaxation) {
    return closes(relaxation, 2 * proof_.relaxation.size() + kCellsBesides, interrupt_);
  }

  bool isSolvableWithout(const Set& obstacles) {
    if (interrupt_.isDueNow()) return false;
    World world = checker_.world();
    for (const std::size_t obstacle : obstacles)
      world = *world.removed(checker_.world().obstacles()[obstacle].id);
    return is_solvable_(std::make_shared<const World>(std::move(world)));
  }

  /// One obstacle weighs less than two; of as many those weigh less at which less is missing.
  double weightOf(std::size_t obstacle) {
    constexpr double kMost_m = 1.0;
    const auto [at, is_new] = weights_.try_emplace(obstacle, 1.0);
    if (is_new)
      if (const auto lacks = lacksAt(checker_, proof_.relaxation.stances(), obstacle); !lacks.empty())
        at->second += 0.1 * std::min(kMost_m, lacks.front().missing_m());
    return at->second;
  }

  const Checker& checker_;
  const Proof& proof_;
  const IsSolvable& is_solvable_;
  Interrupt& interrupt_;
  Set all_;
  std::map<std::size_t, double> weights_;
};

}  // namespace

Blame blame(const Checker& checker, const Proof& proof, const IsSolvable& is_solvable, Interrupt& interrupt) {
  return Culprits(checker, proof, is_solvable, interrupt).blame();
}

}  // namespace underway
