#include "bench/oracle/lattice.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace underway::bench {
namespace {

constexpr std::uint8_t kNotChecked = 0xff;
constexpr std::uint64_t kNoneChecked = ~std::uint64_t{0};

Sense senseOf(Lattice::Step step) { return static_cast<Sense>(step); }

}  // namespace

Lattice::Lattice(const Checker& checker, const LatticeSettings& settings)
    : checker_(&checker),
      settings_(settings),
      gaits_(gaitsOf(checker.robot(), settings.policy)),
      headings_(latticeHeadings(settings.headings)),
      columns_(static_cast<int>(checker.world().bounds().width_m / settings.cell_m)),
      rows_(static_cast<int>(checker.world().bounds().height_m / settings.cell_m)) {
  if (settings.headings > 64) throw std::invalid_argument("a lattice has up to 64 headings");
  spot_of_cell_.resize(gaits_.all.size());
  for (std::size_t i = 0; i < gaits_.all.size(); ++i)
    if (gaits_.all[i].turning) placeGait(static_cast<GaitId>(i));
  if (checker.robot().switches.size() > 63) throw std::invalid_argument("a lattice knows up to 63 switches");
  free_steps_.assign(size(), kNotChecked);
  if (settings.has_bridges) free_switches_.assign(size(), kNoneChecked);
  costSteps();
}

void Lattice::placeGait(GaitId gait) {
  spot_of_cell_[gait].assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      Spot spot{{x, y}, gait, false, 0};
      spot.is_free_all_round =
          checker_->isFreeAllRound(*gaits_.all[gait].turning, at(spot.cell), settings_.margin_m);
      spot.free = spot.is_free_all_round ? ~std::uint64_t{0} : freeHeadings(gait, spot.cell);
      if (spot.free == 0) continue;
      spot_of_cell_[gait][static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                          static_cast<std::size_t>(x)] = static_cast<std::int32_t>(spots_.size());
      spots_.push_back(spot);
    }
}

std::uint64_t Lattice::freeHeadings(GaitId gait, Cell cell) const {
  const Point here = at(cell);
  std::vector<Motion> standing;
  standing.reserve(headings_.size());
  for (int k = 0; k < settings_.headings; ++k)
    standing.push_back(stay(*gaits_.all[gait].turning, {here.x, here.y, yawOf(k)}));
  const std::vector<char> free = checker_->areFree(standing, settings_.margin_m);
  std::uint64_t mask = 0;
  for (std::size_t k = 0; k < free.size(); ++k) mask |= std::uint64_t{free[k] != 0} << k;
  return mask;
}

void Lattice::costSteps() {
  cost_.assign(gaits_.all.size() * headings_.size() * kSteps, Cost::most());
  for (std::size_t g = 0; g < gaits_.all.size(); ++g)
    for (std::size_t k = 0; k < headings_.size(); ++k)
      for (Step step = 0; step < kSteps; ++step) {
        const Gait& gait = gaits_.all[g];
        const bool is_turn = step >= kCounterClockwise;
        const auto mode = is_turn ? gait.turning : gait.mode(senseOf(step));
        if (!mode) continue;
        const double length_m = settings_.cell_m * std::hypot(headings_[k].x, headings_[k].y);
        const std::size_t next = (k + (step == kClockwise ? headings_.size() - 1 : 1)) % headings_.size();
        const double angle = normalizedAngle(headings_[next].yaw - headings_[k].yaw);
        const Motion motion =
            is_turn ? turn(*mode, {}, angle, angle) : translate(*mode, senseOf(step), {}, length_m);
        cost_[(g * headings_.size() + k) * kSteps + step] =
            costOf(checker_->robot(), settings_.policy, motion);
      }
}

Pose Lattice::pose(Node node) const {
  const Point here = at(cell(node));
  return {here.x, here.y, yawOf(heading(node))};
}

std::optional<Lattice::Node> Lattice::find(GaitId gait, Cell cell, int heading) const {
  if (cell.x < 0 || cell.y < 0 || cell.x >= columns_ || cell.y >= rows_ || spot_of_cell_[gait].empty())
    return std::nullopt;
  const std::int32_t spot =
      spot_of_cell_[gait][static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
                          static_cast<std::size_t>(cell.x)];
  if (spot < 0 || (spots_[static_cast<std::size_t>(spot)].free >> heading & 1) == 0) return std::nullopt;
  return static_cast<Node>(static_cast<std::size_t>(spot) * headings_.size() +
                           static_cast<std::size_t>(heading));
}

Point Lattice::at(Cell cell) const {
  return transform(checker_->world().bounds().corner,
                   {(cell.x + 0.5) * settings_.cell_m, (cell.y + 0.5) * settings_.cell_m});
}

Point Lattice::inCells(Point at) const {
  const Pose& corner = checker_->world().bounds().corner;
  const Point moved = transform({0.0, 0.0, -corner.yaw}, {at.x - corner.x, at.y - corner.y});
  return {moved.x / settings_.cell_m - 0.5, moved.y / settings_.cell_m - 0.5};
}

double Lattice::yawOf(int heading) const {
  const double yaw = headings_[static_cast<std::size_t>(heading)].yaw;
  const double frame = checker_->world().bounds().corner.yaw;
  return frame == 0.0 ? yaw : normalizedAngle(yaw + frame);
}

int Lattice::nearestHeading(double yaw) const {
  int best = 0;
  for (int k = 1; k < settings_.headings; ++k)
    if (std::abs(normalizedAngle(yaw - yawOf(k))) < std::abs(normalizedAngle(yaw - yawOf(best)))) best = k;
  return best;
}

std::optional<Lattice::Node> Lattice::neighbour(Node node, Step step) const {
  const Cell from = cell(node);
  const int k = heading(node);
  const int count = settings_.headings;
  if (step >= kCounterClockwise)
    return find(gait(node), from, (k + (step == kClockwise ? count - 1 : 1)) % count);
  static constexpr std::array kQuarters{0, 2, 1, 3};  // by Sense, counter-clockwise from the front
  const Heading& along = headings_[static_cast<std::size_t>((k + kQuarters.at(step) * count / 4) % count)];
  return find(gait(node), {from.x + along.x, from.y + along.y}, k);
}

Motion Lattice::motion(Node from, Step step, Node to) const {
  const Gait& gait = gaits_.all[this->gait(from)];
  if (step < kCounterClockwise)
    return translate(*gait.mode(senseOf(step)), senseOf(step), pose(from), at(cell(to)));
  const double yaw = yawOf(heading(to));
  return turn(*gait.turning, pose(from), normalizedAngle(yaw - yawOf(heading(from))), yaw);
}

std::uint8_t Lattice::checkedSteps(Node node) const {
  const Spot& spot = spots_[node / headings_.size()];
  std::vector<Motion> motions;
  std::array<Step, kSteps> of{};
  std::uint8_t free = 0;
  for (Step step = 0; step < kSteps; ++step) {
    const bool is_turn = step >= kCounterClockwise;
    if (!is_turn && !gaits_.all[spot.gait].mode(senseOf(step))) continue;
    const auto to = neighbour(node, step);
    if (!to) continue;
    if (is_turn && spot.is_free_all_round) {
      free = static_cast<std::uint8_t>(free | 1U << step);
      continue;
    }
    of.at(motions.size()) = step;
    motions.push_back(motion(node, step, *to));
  }
  const std::vector<char> are_free = checker_->areFree(motions, settings_.margin_m);
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (are_free[i] != 0) free = static_cast<std::uint8_t>(free | 1U << of.at(i));
  return free;
}

std::optional<Lattice::Node> Lattice::stepped(Node node, Step step) {
  if (free_steps_[node] == kNotChecked) free_steps_[node] = checkedSteps(node);
  if ((free_steps_[node] >> step & 1) == 0) return std::nullopt;
  return neighbour(node, step);
}

std::uint64_t Lattice::checkedSwitches(Node node) const {
  const auto& switches = checker_->robot().switches;
  std::vector<Motion> motions;
  std::vector<std::size_t> of;
  for (std::size_t i = 0; i < switches.size(); ++i) {
    if (gaits_.of_mode[switches[i].from] != gait(node) || gaits_.of_mode[switches[i].to] == gait(node))
      continue;
    motions.push_back(switchModes(switches[i], pose(node)));
    of.push_back(i);
  }
  const std::vector<char> are_free = checker_->areFree(motions, settings_.margin_m);
  std::uint64_t free = 0;
  for (std::size_t i = 0; i < of.size(); ++i) free |= std::uint64_t{are_free[i] != 0} << of[i];
  return free;
}

bool Lattice::maySwitch(Node node, std::size_t change) {
  if (free_switches_[node] == kNoneChecked) free_switches_[node] = checkedSwitches(node);
  return (free_switches_[node] >> change & 1) != 0;
}

}  // namespace underway::bench
