#include "gait/joint_table.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace underway::gait {
namespace {

constexpr double kSamePlace_rad = 1e-9;

void require(bool is_met, const char* sentence) {
  if (!is_met) throw std::invalid_argument(sentence);
}

bool isFinite(double number) { return std::isfinite(number); }

}  // namespace

JointTable::JointTable(std::vector<std::string> joints) : joints_(std::move(joints)) {
  require(std::ranges::none_of(joints_, &std::string::empty), "a joint table has a joint without a name");
  require(std::set<std::string>(joints_.begin(), joints_.end()).size() == joints_.size(),
          "a joint table has a joint twice");
}

void JointTable::append(double time_s, std::span<const double> angles_rad) {
  require(angles_rad.size() == joints_.size(), "a row of a joint table has an angle too many or too few");
  require(isFinite(time_s) && std::ranges::all_of(angles_rad, isFinite),
          "a row of a joint table holds a number that is not finite");
  require(empty() || time_s > times_s_.back(), "a row of a joint table comes before the last one");
  times_s_.push_back(time_s);
  angles_rad_.insert(angles_rad_.end(), angles_rad.begin(), angles_rad.end());
}

void JointTable::append(const JointTable& next) {
  if (&next == this) return append(JointTable(next));  // the rows it reads must stay where they are
  require(next.joints_ == joints_, "joint tables of different joints cannot follow each other");
  if (next.empty()) return;
  if (empty()) {
    *this = next;
    return;
  }
  const auto ours = angles(rows() - 1);
  require(std::ranges::equal(ours, next.angles(0),
                             [](double a, double b) { return std::abs(a - b) <= kSamePlace_rad; }),
          "a joint table does not begin where the one before it ends");
  const double shift_s = times_s_.back() - next.times_s_.front();
  for (std::size_t row = 1; row < next.rows(); ++row) append(next.time(row) + shift_s, next.angles(row));
}

std::span<const double> JointTable::angles(std::size_t row) const {
  if (row >= rows()) throw std::out_of_range("a joint table has no such row");
  return {angles_rad_.data() + row * joints_.size(), joints_.size()};
}

std::optional<std::size_t> JointTable::find(std::string_view joint) const {
  const auto found = std::ranges::find(joints_, joint);
  if (found == joints_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - joints_.begin());
}

double JointTable::duration() const { return empty() ? 0.0 : times_s_.back() - times_s_.front(); }

void JointTable::sample(double time_s, std::span<double> angles_rad) const {
  if (empty()) throw std::logic_error("an empty joint table has no angles to sample");
  require(angles_rad.size() == joints_.size(), "a sample of a joint table needs one number a joint");
  const auto after = static_cast<std::size_t>(std::ranges::upper_bound(times_s_, time_s) - times_s_.begin());
  const auto from = angles(after == 0 ? 0 : after - 1);
  std::ranges::copy(from, angles_rad.begin());
  if (after == 0 || after == rows()) return;
  const auto to = angles(after);
  const double share = (time_s - times_s_[after - 1]) / (times_s_[after] - times_s_[after - 1]);
  for (std::size_t i = 0; i < from.size(); ++i) angles_rad[i] += share * (to[i] - from[i]);
}

std::vector<double> JointTable::sample(double time_s) const {
  std::vector<double> angles_rad(joints_.size());
  sample(time_s, angles_rad);
  return angles_rad;
}

JointTable JointTable::part(double from_s, double to_s) const {
  JointTable result(joints_);
  result.append(from_s, sample(from_s));
  for (std::size_t row = 0; row < rows(); ++row)
    if (times_s_[row] > from_s && times_s_[row] < to_s) result.append(times_s_[row], angles(row));
  result.append(to_s, sample(to_s));
  return result;
}

JointTable JointTable::denser(double step_s) const {
  require(step_s > 0.0, "rows of a joint table cannot be that close");
  JointTable table(joints_);
  for (std::size_t row = 0; row < rows(); ++row) {
    if (row > 0) {
      const double from_s = times_s_[row - 1];
      const double gap_s = times_s_[row] - from_s;
      const double steps = std::ceil(gap_s / step_s);
      for (double i = 1.0; i < steps; i += 1.0)
        table.append(from_s + gap_s * i / steps, sample(from_s + gap_s * i / steps));
    }
    table.append(times_s_[row], angles(row));
  }
  return table;
}

}  // namespace underway::gait
