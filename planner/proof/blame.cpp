#include "planner/proof/blame.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "planner/proof/need.hpp"
#include "planner/proof/way.hpp"

namespace underway::proof {
namespace {

using Set = std::vector<std::size_t>;  // of obstacles, as indices into the world's

constexpr int kMostRounds = 8;               // of adding obstacles until a way opens
constexpr std::size_t kMostTries = 6;        // of finding a lighter way
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
      const auto lack = lackToTell(obstacle);
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
      const Set more = lightestMore(relaxation);
      if (more.empty()) return false;
      all_.insert(all_.end(), more.begin(), more.end());
    }
    return false;
  }

  /// Those on the lightest way. What is guessed to be missing there is made sure of, which may make it
  /// heavier; until no other way is lighter.
  Set lightestMore(Relaxation& relaxation) {
    Set best;
    for (std::size_t tries = 0; tries < kMostTries && !interrupt_.isDueNow(); ++tries) {
      const auto more = WaySearch().fewestBlockers(
          relaxation, [&](std::size_t o) { return weightOf(o); }, interrupt_);
      if (!more) return best;
      best = *more;
      bool was_known = true;
      for (const std::size_t one : best) was_known = makeSure(one, best) && was_known;
      if (was_known) return best;
    }
    return best;
  }

  /// Whether what is missing at an obstacle was known already, the others gone.
  bool makeSure(std::size_t obstacle, Set others) {
    if (!sure_.insert(obstacle).second) return true;
    others.insert(others.end(), all_.begin(), all_.end());
    const auto lack = lackOf(obstacle, without(others, obstacle));
    weights_[obstacle] = weightFor(lack);
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

  /// What is missing least of what is decisive, some other obstacles gone: if the obstacle were not there for
  /// that shape alone, a way would open, and likewise if what is on the other side of the gap were not.
  std::optional<Lack> lackOf(std::size_t obstacle, const Set& gone) {
    Relaxation relaxation = proof_.relaxation;
    relaxation.lift(gone, std::nullopt, interrupt_);
    std::map<std::pair<std::size_t, std::optional<std::size_t>>, bool> known;
    const auto opens = [&](std::size_t lifted, std::optional<std::size_t> shape) {
      const auto [at, is_new] = known.try_emplace({lifted, shape}, false);
      if (is_new) at->second = opensWithout(relaxation, lifted, shape);
      return at->second;
    };
    for (const Lack& lack : lacksAt(checker_, relaxation.stances(), obstacle)) {
      if (known.size() >= kMostLacks || interrupt_.isDueNow()) break;
      // What ends a switch's box ends the body that stands there as well.
      const auto lifted_for = lack.is_of_switch ? std::nullopt : std::optional(lack.shape);
      if (opens(obstacle, lack.shape) && (!lack.partner || opens(*lack.partner, lifted_for))) return lack;
    }
    return std::nullopt;
  }

  /// The decisive one, or else that which is missing least.
  std::optional<Lack> lackToTell(std::size_t obstacle) {
    if (auto lack = lackOf(obstacle, without(all_, obstacle))) return lack;
    const auto lacks = lacksAt(checker_, proof_.relaxation.stances(), obstacle);
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

  /// One obstacle weighs less than two; of as many those weigh less at which less is missing. At first that
  /// is a guess, and never too much.
  double weightOf(std::size_t obstacle) {
    const auto [at, is_new] = weights_.try_emplace(obstacle, 0.0);
    if (is_new) {
      const auto lacks = lacksAt(checker_, proof_.relaxation.stances(), obstacle);
      at->second = weightFor(lacks.empty() ? std::nullopt : std::optional(lacks.front()));
    }
    return at->second;
  }

  static double weightFor(const std::optional<Lack>& lack) {
    constexpr double kMost_m = 1.0;
    return 1.0 + 0.1 * (lack ? std::min(kMost_m, lack->missing_m()) : kMost_m);
  }

  const Checker& checker_;
  const Proof& proof_;
  const IsSolvable& is_solvable_;
  Interrupt& interrupt_;
  Set all_;
  std::map<std::size_t, double> weights_;
  std::set<std::size_t> sure_;  // obstacles whose weight is no guess
};

}  // namespace

Blame blame(const Checker& checker, const Proof& proof, const IsSolvable& is_solvable, Interrupt& interrupt) {
  return Culprits(checker, proof, is_solvable, interrupt).blame();
}

}  // namespace underway::proof
