#pragma once

#include <optional>
#include <string>
#include <vector>

namespace underway::bench {

/// One measured figure.
struct Row {
  std::string what;  ///< as the table names it
  double value = 0.0;
  std::string unit;
  std::string goal;           ///< what was asked for: "< 100"; empty if nothing was
  std::optional<bool> met;    ///< whether the value, or the ratio, keeps the goal
  unsigned long seed = 0;     ///< the first one
  unsigned long samples = 0;  ///< measured
  struct Peer {
    std::string name;
    double value = 0.0;  ///< in the same unit, of the same run
  };
  std::optional<Peer> peer;     ///< what it is compared with
  std::optional<double> ratio;  ///< how many times the peer's value is the value
};

/// A benchmark's figures.
struct Report {
  std::string name;
  std::vector<Row> rows;
};

/// The file that `--json` writes (formats: 'Benchmarks'), with this machine's processor.
[[nodiscard]] std::string toJson(const Report& report);

/// The p-th quantile of some numbers, 0..1; they are sorted for it. Throws std::invalid_argument when there
/// are none.
[[nodiscard]] double quantile(std::vector<double> numbers, double p);

}  // namespace underway::bench
