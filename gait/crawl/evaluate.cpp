#include "gait/crawl/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace underway::gait {
namespace {

constexpr int kSteps = 40;
constexpr double kMargin_rad = 0.003;  ///< kept from joints' limits
constexpr double kAngleUnit_rad = 0.1;
constexpr double kLengthUnit_m = 0.01;
constexpr double kHeadAhead_m = 0.12;  ///< from the shoulder, along the back, on NAO

double square(double x) { return x * x; }

/// Squared distance from a range, in some unit; 0 inside.
double excess(double value, double least, double most, double unit) {
  return square(std::max({0.0, least - value, value - most}) / unit);
}

/// One pose of the push and what is told of it.
struct Sample {
  ChainAngles angles;
  ChainPoints points;
  PlanePoint head;
};

class Evaluation {
 public:
  Evaluation(const Crawler& crawler, const ChainMasses& masses, const PushShape& push,
             const PushSetting& setting)
      : crawler_(crawler), masses_(masses), push_(push), setting_(setting) {}

  PushFigures figures() && {
    figures_.hip_lowest_m = 1.0;
    const LinkLengths lengths = crawler_.lengths(setting_.spread_m);
    for (int i = 0; i <= kSteps; ++i) {
      const double phase = static_cast<double>(i) / kSteps;
      const double weight = (i == 0 || i == kSteps ? 0.5 : 1.0) / kSteps;
      const Triplet triplet = push_.at(phase);
      addTriplet(triplet, push_.alpha.rate(phase), weight);
      const auto chain = pushPose(lengths, triplet, {setting_.toe_to_elbow_m, 0.0});
      if (!chain) {
        addInfeasible(chain.error(), weight);
        continue;
      }
      addPose(*chain, pointsOf(lengths, *chain), i, weight);
    }
    if (is_whole_) addWhole();
    return figures_;
  }

 private:
  void addTriplet(const Triplet& triplet, double alpha_rate, double weight) {
    const PushLimits& limits = setting_.limits;
    const double mean_rate = push_.alpha.at(1.0) - push_.alpha.at(0.0);
    figures_.violation +=
        weight * (excess(triplet.knee, limits.knee_least_rad, limits.knee_most_rad, kAngleUnit_rad) +
                  excess(triplet.hip, limits.hip_least_rad, limits.hip_most_rad, kAngleUnit_rad) +
                  excess(triplet.alpha, limits.alpha_least_rad, limits.alpha_most_rad, kAngleUnit_rad) +
                  excess(alpha_rate / mean_rate, 0.0, limits.alpha_rate_most, 1.0));
  }

  void addInfeasible(const Infeasible& why, double weight) {
    is_whole_ = false;
    figures_.violation += weight * (1.0 + excess(why.needs_m, why.least_m, why.most_m, kLengthUnit_m));
  }

  void addPose(const ChainAngles& angles, const ChainPoints& points, int step, double weight) {
    const ChainLoad load = loadOf(masses_, points, setting_.force);
    for (std::size_t j = 0; j < 4; ++j) {
      figures_.torque_nm2[j] += weight * square(load.torques_nm[j]);
      figures_.peak_nm = std::max(figures_.peak_nm, std::abs(load.torques_nm[j]));
      figures_.highest_m = std::max(figures_.highest_m, points[j + 1].z);
    }
    figures_.hip_lowest_m = std::min(figures_.hip_lowest_m, points[3].z);
    figures_.back_rad2 += weight * square(angles.back());
    figures_.violation += weight * poseViolation(angles, points);
    samples_[static_cast<std::size_t>(step)] = {angles, points,
                                                points[4] + along(kHeadAhead_m, angles.back())};
  }

  double poseViolation(const ChainAngles& angles, const ChainPoints& points) const {
    double violation = 0.0;
    const double shoulder = -0.5 * std::numbers::pi - angles.shoulder();
    for (const auto& side : crawler_.sides)
      for (const auto& [joint, angle] : {std::pair{kAnkle, angles.ankle()},
                                         {kKnee, angles.knee()},
                                         {kHip, angles.hip()},
                                         {kShoulderPitch, shoulder}})
        violation += excess(angle, side[joint].lower() + kMargin_rad, side[joint].upper() - kMargin_rad,
                            kAngleUnit_rad);
    for (std::size_t j = 1; j <= 4; ++j)
      violation += excess(points[j].z, 0.0, setting_.limits.height_most_m, kLengthUnit_m);
    return violation + excess(points[3].z, setting_.limits.hip_height_least_m, 1.0, kLengthUnit_m);
  }

  /// What is told of the push as a whole.
  void addWhole() {
    const Sample& first = samples_.front();
    const Sample& last = samples_.back();
    figures_.stroke_m = last.points[4].x - first.points[4].x;
    double mean_z = 0.0;
    for (const Sample& sample : samples_) mean_z += sample.head.z / static_cast<double>(samples_.size());
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const double phase = static_cast<double>(i) / kSteps;
      const double even_x = first.head.x + phase * (last.head.x - first.head.x);
      figures_.head_m2 += (square(samples_[i].head.x - even_x) + square(samples_[i].head.z - mean_z)) /
                          static_cast<double>(samples_.size());
      if (i > 0) addSpeeds(samples_[i - 1].angles, samples_[i].angles);
    }
    figures_.violation += square(std::max(0.0, figures_.shortest_s / setting_.push_s - 1.0));
  }

  void addSpeeds(const ChainAngles& from, const ChainAngles& to) {
    constexpr std::array kJoints{kAnkle, kKnee, kHip, kShoulderPitch};
    for (std::size_t j = 0; j < 4; ++j) {
      const double rate = std::abs(to.theta[j + 1] - from.theta[j + 1]) * kSteps;
      for (const auto& side : crawler_.sides)
        figures_.shortest_s = std::max(figures_.shortest_s, rate / side[kJoints[j]].limits.speed_radps);
    }
  }

  const Crawler& crawler_;
  const ChainMasses& masses_;
  const PushShape& push_;
  const PushSetting& setting_;
  PushFigures figures_;
  std::array<Sample, kSteps + 1> samples_;
  bool is_whole_ = true;
};

}  // namespace

PushFigures evaluate(const Crawler& crawler, const ChainMasses& masses, const PushShape& push,
                     const PushSetting& setting) {
  return Evaluation(crawler, masses, push, setting).figures();
}

double torqueCost(const PushFigures& figures, const std::array<double, 4>& weights) {
  double cost = 0.0;
  for (std::size_t j = 0; j < 4; ++j) cost += weights[j] * figures.torque_nm2[j];
  return cost;
}

double costOf(const PushFigures& figures, Aim aim) {
  constexpr double kLittle = 1e-3;
  const double torque = torqueCost(figures, kPaperWeights);
  switch (aim) {
    case Aim::kTorque:
      return torque;
    case Aim::kEvenTorque:
      return torqueCost(figures, kEvenWeights);
    case Aim::kSpeed:
      return figures.shortest_s + kLittle * torque;
    case Aim::kLevelBack:
      return figures.back_rad2 + 10.0 * kLittle * torque;
    case Aim::kSteadyHead:
      return 1e4 * figures.head_m2 + kLittle * torque;
  }
  return torque;
}

}  // namespace underway::gait
