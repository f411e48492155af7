#include "bench/refusals.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>

#include "bench/random_geometry.hpp"
#include "bench/rooms.hpp"
#include "geometry/map.hpp"
#include "planner/planner.hpp"
#include "planner/proof/blame.hpp"

namespace underway::bench {
namespace {

using Clock = Interrupt::Clock;
using std::chrono::milliseconds;
using std::chrono::seconds;
using RobotPointer = std::shared_ptr<const Robot>;

constexpr unsigned long kRooms = 100;
constexpr unsigned long kSolvable = 1000;
constexpr std::array kMissing_m{0.10, 0.05, 0.02, 0.01};
constexpr std::array kGoals{0.95, 0.95, 0.80, 0.0};  // share proven, by what is missing; 0: none was set
constexpr std::size_t kBlamed = 1;                   // index of what is missing where blame is judged
constexpr double kOpenSlack_m = 0.03;

bool isSolvable(const std::shared_ptr<const World>& world, const Request& request, const RobotPointer& robot,
                Clock::duration within) {
  return Planner(world, robot).plan(request, Clock::now() + within).has_value();
}

/// What was measured of the rooms whose passage was closed by one amount.
struct Closed {
  unsigned long proven = 0;
  std::vector<double> took_ms;
  unsigned long named = 0;        // what was closed is what is blamed, to 1 mm
  unsigned long irreducible = 0;  // shown
  std::vector<double> blame_ms;
};

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::string_view blockedBy(Need need) {
  static constexpr std::array<std::string_view, 5> kOf{"width", "width", "height", "length", "length"};
  return kOf.at(static_cast<std::size_t>(need));
}

void judgeBlame(const Checker& checker, const proof::Proof& proven, const Room& room,
                const RobotPointer& robot, Need need, double missing_m, Closed& closed) {
  const auto start = Clock::now();
  Interrupt interrupt(start + seconds(10), {});
  const proof::Blame told = proof::blame(
      checker, proven,
      [&](const std::shared_ptr<const World>& world) {
        return isSolvable(world, room.request, robot, seconds(1));
      },
      interrupt);
  closed.blame_ms.push_back(millisecondsSince(start));
  closed.irreducible += told.is_irreducible ? 1 : 0;
  const bool is_named = told.blocking.size() == 1 && told.blocking[0].of == blockedBy(need) &&
                        std::abs(told.blocking[0].needs_m - told.blocking[0].has_m - missing_m) < 1e-3;
  closed.named += is_named ? 1 : 0;
}

void closeRoom(Need need, std::uint64_t seed, const RobotPointer& robot,
               std::array<Closed, kMissing_m.size()>& closed) {
  for (std::size_t i = 0; i < kMissing_m.size(); ++i) {
    const Room room = roomWith(need, -kMissing_m[i], seed);
    const Checker checker(room.world, robot);
    const auto start = Clock::now();
    Interrupt interrupt(start + seconds(10), {});
    const auto proof = proof::proveNoPath(checker, room.request, interrupt);
    if (!proof) continue;
    ++closed[i].proven;
    closed[i].took_ms.push_back(millisecondsSince(start));
    if (i == kBlamed) judgeBlame(checker, *proof, room, robot, need, kMissing_m[i], closed[i]);
  }
}

std::array<Closed, kMissing_m.size()> closeRooms(const RobotPointer& robot,
                                                 const std::function<void(double)>& progress) {
  std::array<Closed, kMissing_m.size()> closed;
  std::uint64_t seed = 0;
  for (unsigned long done = 0; done < kRooms; ++seed) {
    const Need need = kNeeds[done % kNeeds.size()];
    const Room open = roomWith(need, kOpenSlack_m, seed);
    if (!isSolvable(open.world, open.request, robot, seconds(3))) continue;
    closeRoom(need, seed, robot, closed);
    progress(static_cast<double>(++done) / kRooms);
  }
  return closed;
}

/// Every other room has one passage, with some millimetres to some centimetres to spare.
Room anyRoom(std::uint64_t seed) {
  if (seed % 2 == 0) return clutteredRoom(seed);
  RandomGeometry random(seed);
  return roomWith(kNeeds[random.oneOf(kNeeds.size())], random.between(0.004, 0.05), seed);
}

struct Solvable {
  std::atomic<std::uint64_t> seed = 0;
  std::atomic<unsigned long> solved = 0;
  std::atomic<unsigned long> proven = 0;  // all of them falsely
};

void proveSolvable(const RobotPointer& robot, Solvable& rooms, const std::function<void(double)>& progress) {
  while (rooms.solved < kSolvable) {
    const Room room = anyRoom(++rooms.seed);
    const Checker checker(room.world, robot);
    if (!isSolvable(room.world, room.request, robot, seconds(2))) continue;
    Interrupt interrupt(Clock::now() + seconds(1), {});
    if (proof::proveNoPath(checker, room.request, interrupt)) ++rooms.proven;
    progress(std::min(1.0, static_cast<double>(++rooms.solved) / kSolvable));
  }
}

void addRows(const std::array<Closed, kMissing_m.size()>& closed, Report& report) {
  for (std::size_t i = 0; i < kMissing_m.size(); ++i) {
    const std::string what = fmt::format("{:.0f} cm missing: ", 100.0 * kMissing_m[i]);
    const auto add = [&](const char* name, double value, const char* unit, double goal) {
      report.rows.push_back({what + name,
                             value,
                             unit,
                             goal > 0.0 ? fmt::format(">= {:.0f}", 100.0 * goal) : "",
                             goal > 0.0 ? std::optional(value >= 100.0 * goal) : std::nullopt,
                             0,
                             kRooms,
                             {},
                             {}});
    };
    add("proven within 10 s", 100.0 * static_cast<double>(closed[i].proven) / kRooms, "%", kGoals[i]);
    if (closed[i].took_ms.empty()) continue;
    add("proof, p50", quantile(closed[i].took_ms, 0.5), "ms", 0.0);
    add("proof, p95", quantile(closed[i].took_ms, 0.95), "ms", 0.0);
    if (i != kBlamed) continue;
    const auto share = [&](unsigned long count) {
      return 100.0 * static_cast<double>(count) / static_cast<double>(closed[i].proven);
    };
    add("of the proven, blamed is what was closed, to 1 mm", share(closed[i].named), "%", 0.0);
    add("of the proven, shown irreducible", share(closed[i].irreducible), "%", 0.0);
    add("blame, p50", quantile(closed[i].blame_ms, 0.5), "ms", 0.0);
  }
}

}  // namespace

Expected<Report> refusals(const std::filesystem::path& data, const std::function<void(double)>& progress) {
  const auto robot = readRobot(data / "robots" / "nao.yaml");
  if (!robot) return tl::unexpected(robot.error());
  const auto shared = std::make_shared<const Robot>(*robot);
  Report report{"refusals", {}};
  addRows(closeRooms(shared, [&](double done) { progress(0.3 * done); }), report);
  Solvable rooms;
  {
    const auto no_progress = [](double) {};
    std::vector<std::jthread> others(std::max(1U, std::thread::hardware_concurrency()) - 1);
    for (std::jthread& other : others)
      other = std::jthread([&] { proveSolvable(shared, rooms, no_progress); });
    proveSolvable(shared, rooms, [&](double done) { progress(0.3 + 0.7 * done); });
  }
  report.rows.push_back({"rooms with a plan: 'proven' to have none",
                         static_cast<double>(rooms.proven.load()),
                         "",
                         "0",
                         rooms.proven == 0,
                         1,
                         rooms.solved,
                         {},
                         {}});
  return report;
}

}  // namespace underway::bench
