#pragma once

#include <vector>

#include "gait/crawl/evaluate.hpp"

namespace underway::gait {

/// The pushes an optimiser chooses from, as points of a box. Each angle is a cubic given by its values and
/// rates at both ends.
class SearchSpace {
 public:
  enum class Ends {
    kFixed,  ///< as in the thesis: the ends are those of `from`; the six rates are free
    kFree,   ///< knee and hip end where they like; alpha's ends stay
  };

  SearchSpace(const PushShape& from, Ends ends, const PushLimits& limits);

  [[nodiscard]] const std::vector<double>& lower() const { return lower_; }
  [[nodiscard]] const std::vector<double>& upper() const { return upper_; }
  /// Where `from` lies, moved into the box.
  [[nodiscard]] const std::vector<double>& start() const { return start_; }
  [[nodiscard]] PushShape shapeAt(const std::vector<double>& point) const;

 private:
  void add(double least, double most, double start);

  PushShape from_;
  Ends ends_;
  std::vector<double> lower_;
  std::vector<double> upper_;
  std::vector<double> start_;
};

}  // namespace underway::gait
