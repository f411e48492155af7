#include "gait/crawl/recipes.hpp"

#include "gait/nao.hpp"

namespace underway::gait {
namespace {

/// The hips clear of the floor all the way, on NAO with its elbows' and toes' thickness.
constexpr double kClearHip_m = 0.030;

Recipe own(const char* name, const PushShape& push, const char* about) {
  Recipe recipe;
  recipe.from = nominalGait();
  recipe.from.name = name;
  recipe.from.push = push;
  recipe.about = about;
  recipe.is_optimised = false;
  return recipe;
}

/// Not from a search, but tried in physics.
Recipe cruise() {
  Recipe recipe = own("cruise", nominalPush(), "For going far and for steering: the hips do not drag.");
  recipe.from = cruiseGait();
  return recipe;
}

Recipe optimum(const char* name, Aim aim, SearchSpace::Ends ends, const char* about) {
  Recipe recipe = own(name, nominalPush(), about);
  recipe.is_optimised = true;
  recipe.aim = aim;
  recipe.ends = ends;
  recipe.search.evaluations = 14400;
  if (ends == SearchSpace::Ends::kFree) {
    recipe.limits.hip_height_least_m = kClearHip_m;
    recipe.from.lying.hip_rad = radians(10.0);
    recipe.from.lying.knee_rad = radians(28.0);
  }
  return recipe;
}

Recipe fast() {
  Recipe recipe = optimum("fast", Aim::kSpeed, SearchSpace::Ends::kFree,
                          "Joints turn as little as they can, and every part is short.");
  recipe.from.times = {0.5, 0.6, 1.2};
  recipe.for_push_s_least = 0.5;
  return recipe;
}

Recipe level() {
  Recipe recipe = optimum("level", Aim::kLevelBack, SearchSpace::Ends::kFree, "Keeps the back level.");
  recipe.for_push_s_least = 3.0;  // below, it costs more than the nominal gait in physics
  recipe.from.times.push_s = 3.0;
  return recipe;
}

Recipe narrow() {
  Recipe recipe = optimum("narrow", Aim::kTorque, SearchSpace::Ends::kFixed,
                          "As efficient, but no wider than the push: the elbows slide ahead.");
  recipe.from.lying.lowering = Lowering::kSlide;
  recipe.from.lying.knee_rad = radians(30.0);
  return recipe;
}

/// Lies and lowers as what it was found from.
Recipe physical() {
  Recipe recipe = own("physical", physicsOptimum(), "Least torque in physics itself: Brooks 2017, 7.4.");
  recipe.from.lying = fast().from.lying;
  recipe.from.times = {0.5, 2.0, 1.2};
  recipe.for_push_s_least = 2.0;
  return recipe;
}

}  // namespace

std::vector<Recipe> naoRecipes() {
  using Ends = SearchSpace::Ends;
  return {own("nominal", nominalPush(), "The author's own: Brooks 2017, Table 8."),
          own("thesis", thesisOptimum(), "The author's optimum: Brooks 2017, Table 9."),
          cruise(),
          optimum("efficient", Aim::kTorque, Ends::kFixed,
                  "Least torque with the paper's weights, from and to the nominal poses."),
          optimum("even", Aim::kEvenTorque, Ends::kFixed,
                  "Least torque, every joint alike, from and to the nominal poses."),
          level(),
          optimum("steady", Aim::kSteadyHead, Ends::kFree, "Moves the head straight and evenly."),
          fast(),
          narrow(),
          physical()};
}

GaitFile make(const Recipe& recipe, const SearchProgress& progress) {
  GaitFile file{recipe.from, recipe.about, recipe.for_push_s_least, recipe.for_push_s_most};
  if (!recipe.is_optimised) return file;
  const PushSetting setting{
      recipe.from.toe_to_elbow_m, recipe.from.spread_m, recipe.from.times.push_s, recipe.limits, {}};
  const SearchSpace space(recipe.from.push, recipe.ends, recipe.limits);
  const Objective objective = objectiveFor(naoCrawler(), chainMassesOf(nao()), space, setting, recipe.aim);
  file.gait.push = space.shapeAt(searchDescent(objective, space, recipe.search, progress).point);
  return file;
}

}  // namespace underway::gait
