#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace underway::gait {

/// A motion as joint angles over time: what a gait makes, and what a robot or a simulator plays.
///
/// Columns are joints, by the robot's own names ("LShoulderPitch"); rows are instants [s], strictly rising;
/// entries are angles [rad]. Between rows angles run straight; before the first row and after the last they
/// stay. Thread safety: a value, read by any number of threads.
class JointTable {
 public:
  /// No rows yet. Throws std::invalid_argument when a name is empty or comes twice.
  explicit JointTable(std::vector<std::string> joints);

  /// A row after the last one. Throws std::invalid_argument when the time does not rise, a number is not
  /// finite, or there are not as many angles as joints.
  void append(double time_s, std::span<const double> angles_rad);
  /// All rows of `next`, shifted so that its first falls on our last. That one is left out: the two must
  /// agree to 1e-9 rad, else std::invalid_argument, as when the joints differ.
  void append(const JointTable& next);

  [[nodiscard]] const std::vector<std::string>& joints() const { return joints_; }
  [[nodiscard]] std::size_t rows() const { return times_s_.size(); }
  [[nodiscard]] bool empty() const { return times_s_.empty(); }
  [[nodiscard]] double time(std::size_t row) const { return times_s_.at(row); }  ///< [s]
  /// By joint [rad]. Valid until the next append.
  [[nodiscard]] std::span<const double> angles(std::size_t row) const;
  /// The joint's place in a row, if it is one of ours.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view joint) const;

  /// From the first row to the last [s]; 0 with fewer than two.
  [[nodiscard]] double duration() const;
  /// The angles at a time [rad], into as many numbers as there are joints. Throws std::logic_error when there
  /// is no row. `sample(time(i), ...)` is `angles(i)`, bit for bit.
  void sample(double time_s, std::span<double> angles_rad) const;
  [[nodiscard]] std::vector<double> sample(double time_s) const;

  /// What it does between two instants, the second one later: rows at both, and ours between them.
  [[nodiscard]] JointTable part(double from_s, double to_s) const;

  /// The same motion in rows at most `step_s` apart: our rows, and as many between them as it takes.
  [[nodiscard]] JointTable denser(double step_s) const;

  bool operator==(const JointTable&) const = default;

 private:
  std::vector<std::string> joints_;
  std::vector<double> times_s_;
  std::vector<double> angles_rad_;  ///< row by row
};

}  // namespace underway::gait
