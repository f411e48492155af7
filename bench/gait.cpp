#include "bench/gait.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/stopwatch.hpp"
#include "gait/crawl/envelope.hpp"
#include "gait/crawl/library.hpp"
#include "gait/crawl/optimise.hpp"
#include "gait/nao.hpp"

namespace underway::bench {
namespace {

using namespace underway::gait;

constexpr unsigned long kSeed = 1;
constexpr int kSeeds = 10;

class Rows {
 public:
  explicit Rows(Report& report) : report_(report) {}

  void tell(const std::string& what, double value, const char* unit, unsigned long samples = 1) {
    report_.rows.push_back({what, value, unit, "", std::nullopt, kSeed, samples, {}, {}});
  }
  void atMost(const std::string& what, double value, const char* unit, double most,
              unsigned long samples = 1) {
    report_.rows.push_back(
        {what, value, unit, fmt::format("<= {:g}", most), value <= most, kSeed, samples, {}, {}});
  }
  void near(const std::string& what, double value, const char* unit, double asked, double tolerance) {
    report_.rows.push_back({what,
                            value,
                            unit,
                            fmt::format("{:g} +- {:g}", asked, tolerance),
                            std::abs(value - asked) <= tolerance,
                            kSeed,
                            1,
                            {},
                            {}});
  }

 private:
  Report& report_;
};

PushSetting authors(InternalForce::Kind force) {
  PushSetting setting;
  setting.spread_m = naoCrawler().arm.spreadFor(0.08975);
  setting.force.kind = force;
  return setting;
}

PushFigures figuresOf(const PushShape& push, const PushSetting& setting) {
  return evaluate(naoCrawler(), chainMassesOf(naoV40()), push, setting);
}

void measureNominal(Rows& rows) {
  const PushFigures figures = figuresOf(nominalPush(), authors(InternalForce::Kind::kServo));
  rows.near("nominal gait: ankle top", 1e3 * figures.highest_m, "mm", 103.8, 0.1);
  rows.near("nominal gait: stroke in the model, l5 89.75 mm", 1e3 * figures.stroke_m, "mm", 77.7, 0.1);
  const auto motion = crawlMotion(naoCrawler(), nominalGait());
  rows.near("nominal gait: joints out of their limits, in angle or speed", motion ? 0.0 : 1.0, "", 0.0, 0.0);
  if (!motion) return;
  const CrawlTimes times = nominalGait().times;
  const double elbow_rad = motion->sample(times.extension_s + times.push_s)[*motion->find("LElbowRoll")];
  rows.near("nominal gait: ElbowRoll ending at", degrees(elbow_rad), "deg", -88.5, 0.01);
}

/// Best over the seeds with their spread, of an optimiser, against the nominal gait.
struct Ratios {
  double best = 1e9;
  double worst = 0.0;
  void add(double ratio) {
    best = std::min(best, ratio);
    worst = std::max(worst, ratio);
  }
};

void measureOptimum(Rows& rows, InternalForce::Kind force, const char* name, double asked) {
  const PushSetting setting = authors(force);
  const ChainMasses masses = chainMassesOf(naoV40());
  const SearchSpace space(nominalPush(), SearchSpace::Ends::kFixed, setting.limits);
  const Objective objective = objectiveFor(naoCrawler(), masses, space, setting, Aim::kTorque);
  const double nominal = torqueCost(figuresOf(nominalPush(), setting), kPaperWeights);
  Ratios genetic;
  Ratios descent;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    GeneticSettings of_genetic;
    of_genetic.seed = static_cast<std::uint64_t>(seed);
    DescentSettings of_descent;
    of_descent.seed = static_cast<std::uint64_t>(seed);
    genetic.add(searchGenetic(objective, space, of_genetic).cost / nominal);
    descent.add(searchDescent(objective, space, of_descent).cost / nominal);
  }
  const std::string what = fmt::format("optimised against nominal, model with {}", name);
  rows.atMost(what + ": NLopt, worst of the seeds", descent.worst, "", asked, kSeeds);
  rows.tell(what + ": NLopt, best", descent.best, "", kSeeds);
  rows.tell(what + ": genetic, worst of the seeds", genetic.worst, "", kSeeds);
  rows.tell(what + ": genetic, best", genetic.best, "", kSeeds);
  rows.tell(what + ": Table 9", torqueCost(figuresOf(thesisOptimum(), setting), kPaperWeights) / nominal, "");
}

void measureLibrary(Rows& rows, const std::string& name, const GaitFile& file) {
  const CrawlGait& gait = file.gait;
  PushSetting setting = authors(InternalForce::Kind::kServo);
  setting.toe_to_elbow_m = gait.toe_to_elbow_m;
  const double nominal = torqueCost(figuresOf(nominalPush(), setting), kPaperWeights);
  setting.spread_m = gait.spread_m;
  const PushFigures figures = figuresOf(gait.push, setting);
  rows.tell(name + ": torque against nominal, paper's weights", torqueCost(figures, kPaperWeights) / nominal,
            "");
  rows.tell(name + ": back's slope, root mean square", degrees(std::sqrt(figures.back_rad2)), "deg");
  rows.tell(name + ": head off an even way, root mean square", 1e3 * std::sqrt(figures.head_m2), "mm");
  const auto room = crawlEnvelope(nao(), naoCrawler(), gait);
  if (!room) return;
  rows.tell(name + ": advance a cycle, at rest", 1e3 * room->advance_m, "mm");
  rows.tell(name + ": cycle", room->duration_s, "s");
  rows.tell(name + ": highest point, at rest", 1e3 * room->high.z(), "mm");
  rows.tell(name + ": least distance of the centre of mass from its support's border",
            1e3 * room->least_margin_m, "mm");
}

void measureSpeed(Rows& rows) {
  constexpr int kEvaluations = 1000;
  constexpr int kCycles = 200;
  constexpr int kRounds = 15;
  const PushSetting setting = authors(InternalForce::Kind::kServo);
  const ChainMasses masses = chainMassesOf(naoV40());
  const SearchSpace space(nominalPush(), SearchSpace::Ends::kFixed, setting.limits);
  const Objective objective = objectiveFor(naoCrawler(), masses, space, setting, Aim::kTorque);
  std::vector<double> point = space.start();
  const double evaluations_s = processorMedianOf(
      [&] {
        double sum = 0.0;
        for (int i = 0; i < kEvaluations; ++i) {
          point[0] = 1e-3 * i;
          sum += objective(point);
        }
        keep(static_cast<std::size_t>(sum));
      },
      kRounds);
  rows.atMost("1,000 optimiser evaluations, processor time", 1e3 * evaluations_s, "ms", 50.0, kRounds);
  const CrawlGait gait = nominalGait();
  const double cycles_s = processorMedianOf(
      [&] {
        for (int i = 0; i < kCycles; ++i) keep(crawlMotion(naoCrawler(), gait)->rows());
      },
      kRounds);
  rows.atMost("a cycle's trajectory generated, processor time", 1e6 * cycles_s / kCycles, "us", 100.0,
              kRounds * kCycles);
}

}  // namespace

Expected<Report> gait(const std::filesystem::path& data, const std::function<void(double)>& progress) {
  Report report{"gait", {}};
  Rows rows(report);
  measureNominal(rows);
  measureOptimum(rows, InternalForce::Kind::kServo, "servo h", 0.50);
  progress(0.4);
  measureOptimum(rows, InternalForce::Kind::kNone, "h = 0", 0.65);
  progress(0.8);
  for (const std::string& name : gaitNames(data / "gaits")) {
    const auto file = readGait(data / "gaits", name);
    if (!file) return fail(ErrorCode::kInvalidRequest, file.error().message);
    measureLibrary(rows, name, *file);
  }
  measureSpeed(rows);
  return report;
}

}  // namespace underway::bench
