#include "gait/crawl/library.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "gait/crawl/recipes.hpp"
#include "gait/nao.hpp"
#include "gait/rest.hpp"

namespace underway::gait {
namespace {

const std::filesystem::path kGaits = std::filesystem::path(UNDERWAY_SOURCE_DIR) / "gaits";

PushFigures figuresOf(const Recipe& recipe, const PushShape& push) {
  const CrawlGait& gait = recipe.from;
  return evaluate(naoCrawler(), chainMassesOf(nao()), push,
                  {gait.toe_to_elbow_m, gait.spread_m, gait.times.push_s, recipe.limits, {}});
}

/// What lies in the repository is what `underway gait make` makes. A search may end elsewhere on a processor
/// that rounds its sines otherwise: then what was found must be as good.
TEST(Library, IsWhatItsRecipesMake) {
  std::vector<std::string> made;
  for (const Recipe& recipe : naoRecipes()) {
    made.push_back(recipe.from.name);
    const auto file = readGait(kGaits, recipe.from.name);
    ASSERT_TRUE(file) << file.error().message;
    GaitFile again = make(recipe);
    if (recipe.is_optimised) {
      const PushFigures figures = figuresOf(recipe, file->gait.push);
      EXPECT_LT(figures.violation, 1e-4) << recipe.from.name;
      EXPECT_LE(costOf(figures, recipe.aim), 1.1 * costOf(figuresOf(recipe, again.gait.push), recipe.aim))
          << recipe.from.name;
      again.gait.push = file->gait.push;
    }
    EXPECT_EQ(toJson(*file), toJson(again));
  }
  std::ranges::sort(made);
  EXPECT_EQ(gaitNames(kGaits), made) << "a gait without a recipe, or a recipe without its gait";
}

TEST(Library, EveryGaitCanBeGoneAtEveryDurationItIsOfferedFor) {
  for (const std::string& name : gaitNames(kGaits)) {
    GaitFile file = *readGait(kGaits, name);
    for (const double push_s : {file.for_push_s_least, file.gait.times.push_s, file.for_push_s_most}) {
      file.gait.times.push_s = push_s;
      const auto motion = crawlMotion(naoCrawler(), file.gait, 2);
      ASSERT_TRUE(motion) << name << " at " << push_s << " s: " << motion.error().message;
    }
  }
}

TEST(Library, EveryGaitIsStableLowAndGoesAhead) {
  for (const std::string& name : gaitNames(kGaits)) {
    const JointTable motion = *crawlMotion(naoCrawler(), readGait(kGaits, name)->gait, 2);
    const std::vector<Rest> rests = settleAll(nao(), motion, radians(87.0));
    for (std::size_t i = 0; i < rests.size(); ++i) {
      ASSERT_GT(rests[i].margin_m, 0.004) << name << ", row " << i;
      ASSERT_LT(rests[i].high.z(), 0.214) << name << ", row " << i;
    }
    EXPECT_GT(rests.back().root.x() - rests[rests.size() / 2].root.x(), 0.045) << name;
  }
}

TEST(Library, NoGaitNeedsMoreTorqueThanTheNominalOne) {
  const ChainMasses masses = chainMassesOf(nao());
  const auto cost = [&](const CrawlGait& gait) {
    PushSetting setting;
    setting.spread_m = gait.spread_m;
    setting.toe_to_elbow_m = gait.toe_to_elbow_m;
    return torqueCost(evaluate(naoCrawler(), masses, gait.push, setting), kPaperWeights);
  };
  for (const std::string& name : gaitNames(kGaits))
    EXPECT_LE(cost(readGait(kGaits, name)->gait), cost(nominalGait()) * 1.000001) << name;
}

TEST(GaitFile, ReadsBackBitForBit) {
  for (const std::string& name : gaitNames(kGaits)) {
    const GaitFile file = *readGait(kGaits, name);
    const auto back = gaitFromJson(toJson(file), "it");
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(toJson(*back), toJson(file));
    EXPECT_EQ(back->gait.push, file.gait.push);
  }
}

TEST(GaitFile, RefusesWhatIsWrongAndSaysWhere) {
  const std::string sound = toJson(GaitFile{nominalGait(), "a gait", 1.0, 10.0});
  const auto changed = [&](const std::string& what, const std::string& by) {
    std::string text = sound;
    text.replace(text.find(what), what.size(), by);
    const auto file = gaitFromJson(text, "gaits/x.json");
    return file ? std::string() : file.error().message;
  };
  EXPECT_NE(changed("\"spread_m\"", "\"spread\"").find("spread_m is missing"), std::string::npos);
  EXPECT_NE(changed("\"turn_rad\": 0.0", "\"turn_rad\": \"left\"").find("turn_rad must be a number"),
            std::string::npos);
  EXPECT_NE(changed("\"push\": 1.0", "\"push\": -1.0").find("times_s: push must be above 0"),
            std::string::npos);
  EXPECT_NE(changed("\"spread\",", "\"roll\",").find("lowering must be spread or slide"), std::string::npos);
  EXPECT_NE(changed("\"about\"", "\"also\": 1, \"about\"").find("\"also\" is not known"), std::string::npos);
  EXPECT_NE(changed("10.0", "0.5").find("for_push_s must be"), std::string::npos);
  for (const char* text : {"", "[]", "{", "null", "\xff\xfe", "{\"name\": 1e999}", "[[[[[[[[["}) {
    const auto file = gaitFromJson(text, "gaits/x.json");
    ASSERT_FALSE(file) << text;
    EXPECT_NE(file.error().message.find("gaits/x.json"), std::string::npos) << file.error().message;
  }
}

TEST(Library, SaysWhichGaitsThereAre) {
  const auto file = readGait(kGaits, "moonwalk");
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("nominal"), std::string::npos) << file.error().message;
  EXPECT_TRUE(gaitNames("/nowhere").empty());
}

}  // namespace
}  // namespace underway::gait
