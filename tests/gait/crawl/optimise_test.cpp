#include "gait/crawl/optimise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gait/nao.hpp"
#include "tests/gait/random_numbers.hpp"

namespace underway::gait {
namespace {

PushSetting authors() {
  PushSetting setting;
  setting.spread_m = naoCrawler().arm.spreadFor(0.08975);
  return setting;
}

PushFigures figuresOf(const PushShape& push, const PushSetting& setting = authors()) {
  return evaluate(naoCrawler(), chainMassesOf(naoV40()), push, setting);
}

TEST(Evaluate, TheAuthorsGaitsKeepAllLimits) {
  for (const PushShape& push : {nominalPush(), thesisOptimum()}) {
    const PushFigures figures = figuresOf(push);
    EXPECT_EQ(figures.violation, 0.0);
    EXPECT_NEAR(figures.stroke_m, 0.0777, 0.0002);
    EXPECT_LT(figures.peak_nm, 1.4);
  }
  EXPECT_NEAR(figuresOf(nominalPush()).highest_m, 0.1038, 0.0001);
}

/// Each limit by itself: a push that breaks it, and only it, and by how much it is let out again.
TEST(Evaluate, EveryLimitBites) {
  const auto broken = [](void (*change)(PushShape&, PushSetting&)) {
    PushShape push = nominalPush();
    PushSetting setting = authors();
    change(push, setting);
    return figuresOf(push, setting).violation;
  };
  EXPECT_GT(broken([](PushShape& p, PushSetting&) { p.knee = line(radians(46), radians(46)); }), 0.0);
  EXPECT_GT(broken([](PushShape& p, PushSetting&) { p.hip = line(radians(29), radians(29)); }), 0.0);
  EXPECT_GT(broken([](PushShape& p, PushSetting&) { p.alpha = line(radians(-25), radians(-90)); }), 0.0);
  EXPECT_GT(broken([](PushShape& p, PushSetting&) { p.alpha = line(radians(-30), radians(-95)); }), 0.0);
  EXPECT_GT(broken([](PushShape& p, PushSetting&) {  // goes back on its way
              p.alpha = cubicThrough(radians(-30), radians(-90), 0.3, -1.0);
            }),
            0.0);
  EXPECT_GT(broken([](PushShape& p, PushSetting&) {  // starts with a jump
              p.alpha = cubicThrough(radians(-30), radians(-90), -4.0, 0.0);
            }),
            0.0);
  EXPECT_GT(broken([](PushShape&, PushSetting& s) { s.limits.height_most_m = 0.10; }), 0.0);
  EXPECT_GT(broken([](PushShape&, PushSetting& s) { s.limits.hip_height_least_m = 0.04; }), 0.0)
      << "the thesis' 40 mm refuse the nominal gait";
  EXPECT_GT(broken([](PushShape&, PushSetting& s) { s.toe_to_elbow_m = 0.40; }), 0.0) << "the ankle's limit";
  EXPECT_GT(broken([](PushShape&, PushSetting& s) { s.toe_to_elbow_m = 0.60; }), 0.5) << "out of reach";
  EXPECT_GT(broken([](PushShape&, PushSetting& s) { s.push_s = 0.1; }), 0.0) << "faster than the joints";
}

TEST(SearchSpace, HoldsThePushItStartsFrom) {
  for (const auto ends : {SearchSpace::Ends::kFixed, SearchSpace::Ends::kFree}) {
    PushLimits limits;
    limits.hip_most_rad = radians(27.5);
    const SearchSpace space(nominalPush(), ends, limits);
    const PushShape push = space.shapeAt(space.start());
    for (const double s : {0.0, 0.3, 1.0}) {
      EXPECT_NEAR(push.at(s).knee, nominalPush().at(s).knee, 1e-12);
      EXPECT_NEAR(push.at(s).hip, nominalPush().at(s).hip, 1e-12);
      EXPECT_NEAR(push.at(s).alpha, nominalPush().at(s).alpha, 1e-12);
    }
  }
}

TEST(SearchSpace, KeepsTheEndsWhereverItGoes) {
  test::RandomNumbers random(1);
  const SearchSpace space(thesisOptimum(), SearchSpace::Ends::kFixed, {});
  for (int i = 0; i < 100; ++i) {
    std::vector<double> point;
    for (std::size_t j = 0; j < space.start().size(); ++j)
      point.push_back(random.between(space.lower()[j], space.upper()[j]));
    for (const double end : {0.0, 1.0}) {
      EXPECT_NEAR(space.shapeAt(point).at(end).hip, thesisOptimum().at(end).hip, 1e-12);
      EXPECT_NEAR(space.shapeAt(point).at(end).alpha, thesisOptimum().at(end).alpha, 1e-12);
    }
  }
}

/// Squared distance from a point that is not the start, scaled unevenly.
Objective bowl(const SearchSpace& space) {
  return [&space](const std::vector<double>& point) {
    double sum = 0.0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double target = space.lower()[i] + 0.3 * (space.upper()[i] - space.lower()[i]);
      sum += static_cast<double>(i + 1) * std::pow(point[i] - target, 2.0);
    }
    return sum;
  };
}

TEST(Optimise, BothFindTheBottomOfABowl) {
  const SearchSpace space(nominalPush(), SearchSpace::Ends::kFixed, {});
  EXPECT_LT(searchGenetic(bowl(space), space, {}).cost, 0.05);
  EXPECT_LT(searchDescent(bowl(space), space, {}).cost, 1e-6);
}

TEST(Optimise, TheSameSeedGivesTheSameAnswer) {
  const SearchSpace space(nominalPush(), SearchSpace::Ends::kFixed, {});
  GeneticSettings genetic;
  genetic.generations = 10;
  DescentSettings descent;
  descent.evaluations = 900;
  EXPECT_EQ(searchGenetic(bowl(space), space, genetic).point,
            searchGenetic(bowl(space), space, genetic).point);
  EXPECT_EQ(searchDescent(bowl(space), space, descent).point,
            searchDescent(bowl(space), space, descent).point);
  genetic.seed = 2;
  EXPECT_NE(searchGenetic(bowl(space), space, genetic).point, searchGenetic(bowl(space), space, {}).point);
}

TEST(Optimise, NeverAsksOutsideTheBoxOrTooOften) {
  const SearchSpace space(nominalPush(), SearchSpace::Ends::kFree, {});
  int asked = 0;
  const Objective watched = [&](const std::vector<double>& point) {
    ++asked;
    for (std::size_t i = 0; i < point.size(); ++i) {
      EXPECT_GE(point[i], space.lower()[i]);
      EXPECT_LE(point[i], space.upper()[i]);
    }
    return bowl(space)(point);
  };
  DescentSettings descent;
  descent.evaluations = 2000;
  const Found found = searchDescent(watched, space, descent);
  EXPECT_LE(found.evaluations, 2000 + 20);
  EXPECT_EQ(found.evaluations, asked);
  asked = 0;
  EXPECT_EQ(searchGenetic(watched, space, {}).evaluations, asked);
}

/// The figures asked for: with every joint below 110 mm, half the nominal torque with servos' internal force,
/// and 0.65 of it without any.
TEST(Optimise, HalvesTheTorqueWithinAllLimits) {
  for (const auto& [kind, asked] :
       {std::pair{InternalForce::Kind::kServo, 0.50}, {InternalForce::Kind::kNone, 0.65}}) {
    PushSetting setting = authors();
    setting.force.kind = kind;
    const SearchSpace space(nominalPush(), SearchSpace::Ends::kFixed, setting.limits);
    const ChainMasses masses = chainMassesOf(naoV40());
    const Objective objective = objectiveFor(naoCrawler(), masses, space, setting, Aim::kTorque);
    const PushFigures best = figuresOf(space.shapeAt(searchDescent(objective, space, {}).point), setting);
    const double nominal = torqueCost(figuresOf(nominalPush(), setting), kPaperWeights);
    EXPECT_LE(torqueCost(best, kPaperWeights), asked * nominal);
    EXPECT_LT(best.violation, 1e-8);
    EXPECT_LE(best.highest_m, 0.1101);
  }
}

}  // namespace
}  // namespace underway::gait
