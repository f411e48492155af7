#include "planner/grow.hpp"

#include <ompl/datastructures/NearestNeighborsGNAT.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>

#include "geometry/sweep.hpp"
#include "planner/draft.hpp"
#include "planner/gaps.hpp"
#include "planner/rails.hpp"
#include "planner/sampling.hpp"
#include "planner/sites.hpp"

namespace underway {
namespace {

using PlaceId = Draft::PlaceId;
using Kind = PoseSampler::Kind;

constexpr unsigned kSitesPerBatch = 24;
constexpr unsigned kLinesPerBatch = 10;  // for each mode that is lower than the first
constexpr unsigned kLooksPerBatch = 60;  // across gaps, for each narrower mode: most see none
constexpr double kNarrow_m = 0.25;       // a gap with less room than this beside the standing body is narrow
constexpr std::size_t kNeighbours = 40;  // looked at; Sites::connectAround tries few of them
constexpr unsigned kProbes = 500;        // poses drawn to see how much floor is free

/// A seed for one use of one batch, spread by splitmix64.
std::uint64_t seedOf(std::uint64_t seed, std::uint64_t batch, std::uint64_t use) {
  std::uint64_t z = seed * 0x9e3779b97f4a7c15ULL + batch * 0xbf58476d1ce4e5b9ULL + use + 1;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// The width of the strip a mode's body covers as it moves along a sense [m].
double strip(const Mode& mode, Sense sense) {
  const bool along_x = sense == Sense::kForward || sense == Sense::kBackward;
  return along_x ? mode.body_m.y.length() : mode.body_m.x.length();
}

double narrowestStrip(const Mode& mode) {
  double narrowest = INFINITY;
  for (const Sense sense : kSenses)
    if (mode.canMove(sense)) narrowest = std::min(narrowest, strip(mode, sense));
  return narrowest;
}

/// The heading at which a mode moves along a gap: its sense at a right angle to the direction across.
double headingAlong(const Gaps::Gap& gap, Sense sense) {
  return normalizedAngle(gap.across_rad + 0.5 * std::numbers::pi - angleOf(sense));
}

struct Located {
  PlaceId place = 0;
  Point at;
  bool operator==(const Located& other) const { return place == other.place; }
  bool operator!=(const Located& other) const { return place != other.place; }
};

/// The distance, and so little of the difference in number that it only decides between places equally far:
/// OMPL's tree finds those in an order that depends on more than the seed.
double apart(const Located& a, const Located& b) {
  constexpr double kTieBreak_m = 1e-12;
  return distance(a.at, b.at) +
         kTieBreak_m * std::abs(static_cast<double>(a.place) - static_cast<double>(b.place));
}

}  // namespace

struct Growth::State {
  State(std::shared_ptr<const Checker> c, GrowthSettings s) : settings(s) {
    near.resize(Groups(c->robot()).modes.size());
    for (auto& near_group : near) near_group.setDistanceFunction(apart);
    standOn(std::move(c));
  }

  /// Makes all that depends on the world.
  void standOn(std::shared_ptr<const Checker> c) {
    ground.reset();
    world = std::move(c);
    const Checker& here = *world;
    ground.emplace(here, draft);
    overhangs.clear();
    standing.reset();
    gaps.reset();
    const Robot& robot = here.robot();
    for (ModeId mode = 0; mode < robot.modes.size(); ++mode) {
      overhangs.push_back(overhangsFor(here.world(), robot, mode));
      if (!standing && robot.modes[mode].canTurn()) standing = mode;
    }
    if (!standing) return;
    const Range slab = slabOf(robot, stay(*standing, {}), here.world().floorZ());
    gaps.emplace(here.world(), slab, narrowestStrip(robot.modes[*standing]) + kNarrow_m);
  }

  /// What builds the draft in one world.
  struct Ground {
    Ground(const Checker& checker, Draft& draft)
        : stances(checker, Policy::kFastest),
          sites(stances, draft, Sites::Check::kNow),
          rails(checker, draft, sites) {}
    Stances stances;
    Sites sites;
    Rails rails;
  };

  [[nodiscard]] const Checker& checker() const { return *world; }

  /// Connects places to their neighbours, and makes them neighbours of those to come.
  void settle(const std::vector<PlaceId>& waiting) {
    for (const PlaceId place : waiting) {
      auto& near_group = near[draft.place(place).group];
      const Located here{place, draft.place(place).at};
      std::vector<Located> found;
      if (near_group.size() > 0) near_group.nearestK(here, kNeighbours, found);
      std::vector<PlaceId> neighbours;
      for (const Located& neighbour : found) neighbours.push_back(neighbour.place);
      ground->sites.connectAround(place, neighbours);
      near_group.add(here);
    }
  }

  // A batch is a list of steps, each of some tens of microseconds, so that growing can stop between two of
  // them and go on there later. What they draw depends on the batch alone.

  void planSites(std::uint32_t batch) {
    if (!standing) return;
    const auto sampler = samplerFor(*standing, {}, seedOf(settings.seed, batch, 0));
    for (unsigned i = 0; i < kSitesPerBatch; ++i) {
      const Kind kind = i % 4 == 2 ? Kind::kGaussian : i % 4 == 3 ? Kind::kBridge : Kind::kUniform;
      steps.emplace_back([this, sampler, kind] {
        if (const auto pose = sampler->sample(kind)) addSite(*standing, *pose);
      });
    }
  }

  void planLowLines(std::uint32_t batch, ModeId mode) {
    if (overhangs[mode].empty()) return;
    const auto sampler = samplerFor(mode, overhangs[mode], seedOf(settings.seed, batch, 1U + mode));
    for (unsigned i = 0; i < kLinesPerBatch; ++i)
      steps.emplace_back([this, sampler, mode] {
        if (const auto pose = sampler->sample(Kind::kLowPlace)) addLowLines(mode, *pose);
      });
  }

  void planNarrowLines(std::uint32_t batch, ModeId mode) {
    const Mode& moving = checker().robot().modes[mode];
    if (!gaps || !moving.canTurn() ||
        narrowestStrip(moving) > narrowestStrip(checker().robot().modes[*standing]))
      return;
    const auto random = std::make_shared<std::mt19937_64>(seedOf(settings.seed, batch, 100U + mode));
    for (unsigned i = 0; i < kLooksPerBatch; ++i)
      steps.emplace_back([this, random, mode] {
        if (const auto gap = gaps ? gaps->draw(*random) : std::nullopt) addNarrowLines(mode, *gap);
      });
  }

  /// It keeps the world it draws in.
  [[nodiscard]] std::shared_ptr<PoseSampler> samplerFor(ModeId mode, std::vector<std::size_t> below,
                                                        std::uint64_t seed) const {
    const auto in_world = std::make_shared<std::pair<std::shared_ptr<const Checker>, PoseSampler>>(
        std::piecewise_construct, std::forward_as_tuple(world),
        std::forward_as_tuple(*world, mode, std::move(below), seed));
    return {in_world, &in_world->second};
  }

  void addSite(ModeId mode, const Pose& pose) {
    settle({ground->sites.add(mode, pose.position(), checker().robot().margin_m)});
  }

  void addLowLines(ModeId mode, const Pose& pose) {
    const Mode& moving = checker().robot().modes[mode];
    if (moving.canTurn()) addSite(mode, pose);
    for (const Sense sense : kSenses)
      if (moving.canMove(sense)) settle(ground->rails.addThrough(mode, sense, pose));
  }

  void addNarrowLines(ModeId mode, const Gaps::Gap& gap) {
    const Mode& moving = checker().robot().modes[mode];
    if (gap.width_m < narrowestStrip(moving) + 2.0 * checker().robot().margin_m) return;
    for (const Sense sense : {Sense::kForward, Sense::kLeft}) {
      if (!moving.canMove(sense) && !moving.canMove(opposite(sense))) continue;
      if (strip(moving, sense) > narrowestStrip(moving)) continue;
      const Pose pose{gap.middle.x, gap.middle.y, headingAlong(gap, sense)};
      if (checker().isFree(stay(mode, pose))) settle(ground->rails.addNarrow(mode, sense, pose));
    }
  }

  std::shared_ptr<const Checker> world;
  GrowthSettings settings;
  Draft draft;
  std::optional<Ground> ground;
  std::vector<ompl::NearestNeighborsGNAT<Located>> near;  // by group
  std::vector<std::vector<std::size_t>> overhangs;        // by mode
  std::optional<ModeId> standing;                         // the first mode that turns: sites are drawn for it
  std::optional<Gaps> gaps;                               // that the standing mode does not fit through
  std::uint32_t batches = 0;
  std::deque<std::function<void()>> steps;  // of the batch that has begun
};

Growth::Growth(std::shared_ptr<const Checker> checker, GrowthSettings settings)
    : state_(std::make_unique<State>(std::move(checker), settings)) {}
Growth::~Growth() = default;

bool Growth::addBatch(Interrupt& interrupt) {
  State& state = *state_;
  if (state.steps.empty()) {
    state.planSites(state.batches);
    for (ModeId mode = 0; mode < state.checker().robot().modes.size(); ++mode) {
      state.planLowLines(state.batches, mode);
      state.planNarrowLines(state.batches, mode);
    }
  }
  for (; !state.steps.empty(); state.steps.pop_front()) {
    if (interrupt.isDueNow()) return false;
    state.steps.front()();
  }
  ++state.batches;
  return true;
}

void Growth::addBatch() {
  Interrupt never(Interrupt::Clock::time_point::max(), {});
  addBatch(never);
}

std::optional<Roadmap> Growth::freeze(Interrupt& interrupt) const {
  auto roadmap = state_->draft.freeze(state_->ground->stances.all(), interrupt);
  if (roadmap) roadmap->batches = state_->batches;
  return roadmap;
}

Roadmap Growth::freeze() const {
  Interrupt never(Interrupt::Clock::time_point::max(), {});
  return *freeze(never);
}

void Growth::takeOver(const Roadmap& roadmap) {
  state_->steps.clear();
  state_->draft = Draft::thawed(roadmap);
  state_->batches = roadmap.batches;
  // All places of whole batches have been connected. What is found nearest does not depend on how the tree
  // came about.
  for (auto& near_group : state_->near) near_group.clear();
  for (PlaceId place = 0; place < roadmap.places.size(); ++place)
    state_->near[roadmap.places[place].group].add({place, roadmap.places[place].at});
}

void Growth::moveTo(std::shared_ptr<const Checker> checker, const Roadmap& roadmap) {
  state_->standOn(std::move(checker));
  takeOver(roadmap);
}

const std::shared_ptr<const Checker>& Growth::checker() const { return state_->world; }

std::uint32_t Growth::batches() const { return state_->batches; }

std::uint32_t Growth::batchesToCover() const {
  constexpr double kFewest = 3.0;
  constexpr double kMost = 400.0;
  if (!state_->standing) return static_cast<std::uint32_t>(kFewest);
  const Bounds& bounds = state_->checker().world().bounds();
  PoseSampler sampler(state_->checker(), *state_->standing, {}, seedOf(state_->settings.seed, 0, 1000));
  const double free_m2 = bounds.width_m * bounds.height_m * sampler.freeShare(kProbes);
  const double sites = free_m2 * state_->settings.sites_per_m2;
  return static_cast<std::uint32_t>(std::clamp(std::ceil(sites / kSitesPerBatch), kFewest, kMost));
}

}  // namespace underway
