#include "gait/crawl/switches.hpp"

#include <array>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>

namespace underway::gait {
namespace {

/// The left arm's; the right one's but for the sign of all but the pitch [deg].
struct Arm {
  double pitch, roll, yaw, elbow;
};

/// Where the joints should be, and how long the way there takes. Legs are alike; what is not told is 0.
struct Keyframe {
  double takes_s;
  double head, hip, knee, ankle;  ///< pitches [deg]
  Arm left, right;
};

constexpr Keyframe both(double takes_s, double head, double hip, double knee, double ankle, Arm arms) {
  return {takes_s, head, hip, knee, ankle, arms, arms};
}

// Arms on the floor, in a fold over straight legs: bent onto a hand that stands close, or stretched.
constexpr Arm kReaching{-60, 10, -90, -70};
constexpr Arm kStretched{-71, 10, -90, -5};
constexpr Arm kRaised{-60, 10, -90, -88};

constexpr Keyframe kStanding = both(1.2, 0, -10, 20, -10, {85, 8, -90, -10});

constexpr Arm kHandAhead{-8, 10, -90, -83};
constexpr std::array kDown{
    kStanding,
    both(1.2, 0, -50, 20, 0, {40, 8, -90, -10}),
    both(1.2, 0, -88, 5, 9, {-30, 8, -90, -5}),
    both(0.8, 0, -88, 0, -8, {-43, 8, -90, -5}),  // hands on the floor
    both(0.8, 0, -88, 0, -21, kHandAhead),
    Keyframe{0.4, 0, -88, 0, -21, kReaching, kHandAhead},
    Keyframe{0.4, 0, -88, 0, -21, kStretched, kHandAhead},
    Keyframe{0.4, 0, -88, 0, -21, kStretched, kReaching},
    Keyframe{0.4, 0, -88, 0, -21, kStretched, kStretched},
    both(0.8, 0, -88, 0, -25, {-50, 15, -90, -45}),
    both(0.8, 0, -88, 0, -30, {-28, 20, -90, -85}),  // on the elbows, feet flat
    both(1.0, 0, -88, 50, -50, {-10, 20, -90, -85}),
    both(1.0, 0, -88, 110, -66, {10, 20, -90, -85}),  // on elbows and knees
    both(1.0, 0, -60, 80, -60, {15, 23, -90, -88}),
    both(1.5, 0, 27, 18, -62, {15, 23, -90, -88}),  // on elbows and toes
    both(1.0, 25, 27.5, 16.5, -65.9, {-50.5, 23.1, -55.8, -37.2}),
};

constexpr Arm kHandClose{3, 10, -90, -88};
constexpr std::array kUp{
    both(0.6, 25, 27.5, 16.5, -65.9, {-50.5, 23.1, -55.8, -37.2}),
    both(1.0, 25, 27, 18, -62, {15, 23, -90, -88}),  // on elbows and toes
    both(1.5, 0, -60, 80, -60, {15, 23, -90, -88}),
    both(1.0, 0, -88, 110, -66, {10, 20, -90, -85}),  // on elbows and knees
    both(1.0, 0, -88, 50, -50, {-10, 20, -90, -85}),
    both(1.0, 0, -88, 0, -30, {-28, 20, -90, -85}),  // on the elbows, feet flat
    both(0.8, 0, -88, 0, -25, {-50, 15, -90, -45}),
    both(0.8, 0, -88, 0, -21, kStretched),
    Keyframe{0.4, 0, -88, 0, -21, kRaised, kStretched},
    Keyframe{0.4, 0, -88, 0, -21, kHandClose, kStretched},
    Keyframe{0.4, 0, -88, 0, -21, kHandClose, kRaised},
    Keyframe{0.4, 0, -88, 0, -21, kHandClose, kHandClose},
    both(1.0, 0, -88, 0, -5, {-37, 10, -90, -5}),
    both(1.0, 0, -88, 0, 10, {2, 8, -90, -5}),
    both(0.8, 0, -82, 0, 13, {12, 8, -90, -5}),  // on the feet alone
    both(1.0, 0, -60, 4, 10, {10, 8, -90, -5}),
    both(1.2, 0, -50, 20, 0, {50, 8, -90, -10}),
    kStanding,
};

constexpr double kLie_s = 0.6;  ///< from the last keyframe down to the crawl's first row

class Row {
 public:
  explicit Row(const JointTable& columns) : columns_(columns), angles_rad_(columns.joints().size(), 0.0) {}

  void set(const std::string& joint, double angle_deg) {
    const auto column = columns_.find(joint);
    if (!column) throw std::invalid_argument("the crawl has no joint " + joint + ": it is not NAO's");
    angles_rad_[*column] = angle_deg * std::numbers::pi / 180.0;
  }
  [[nodiscard]] const std::vector<double>& angles() const { return angles_rad_; }

 private:
  const JointTable& columns_;
  std::vector<double> angles_rad_;
};

void setSide(Row& row, char side, const Keyframe& frame, const Arm& arm) {
  const double sign = side == 'L' ? 1.0 : -1.0;
  const auto named = [&](const char* joint) { return std::string(1, side) + joint; };
  row.set(named("HipPitch"), frame.hip);
  row.set(named("KneePitch"), frame.knee);
  row.set(named("AnklePitch"), frame.ankle);
  row.set(named("ShoulderPitch"), arm.pitch);
  row.set(named("ShoulderRoll"), sign * arm.roll);
  row.set(named("ElbowYaw"), sign * arm.yaw);
  row.set(named("ElbowRoll"), sign * arm.elbow);
}

std::vector<double> angles(const JointTable& columns, const Keyframe& frame) {
  Row row(columns);
  row.set("HeadPitch", frame.head);
  setSide(row, 'L', frame, frame.left);
  setSide(row, 'R', frame, frame.right);
  return row.angles();
}

void append(JointTable& table, double takes_s, std::span<const double> angles_rad) {
  table.append(table.empty() ? 0.0 : table.time(table.rows() - 1) + takes_s, angles_rad);
}

void append(JointTable& table, std::span<const Keyframe> frames) {
  for (const Keyframe& frame : frames) append(table, frame.takes_s, angles(table, frame));
}

}  // namespace

JointTable goDown(const JointTable& crawl) {
  if (crawl.empty()) throw std::invalid_argument("a crawl without rows cannot be gone down to");
  JointTable table(crawl.joints());
  append(table, kDown);
  append(table, kLie_s, crawl.angles(0));
  return table;
}

JointTable getUp(const JointTable& crawl) {
  if (crawl.empty()) throw std::invalid_argument("a crawl without rows cannot be got up from");
  JointTable table(crawl.joints());
  append(table, 0.0, crawl.angles(0));
  append(table, kUp);
  return table;
}

JointTable standing(const JointTable& crawl) {
  JointTable table(crawl.joints());
  append(table, 0.0, angles(crawl, kStanding));
  return table;
}

}  // namespace underway::gait
