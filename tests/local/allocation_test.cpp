// Counts what is allocated during ticks, by replacing the program's operator new.

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "bench/local_run.hpp"
#include "local/executor.hpp"
#include "tests/planner/fixture.hpp"

namespace {

std::size_t allocations = 0;  // NOLINT: what operator new has to write to

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
// std::stable_sort and others ask this way.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace underway {
namespace {

TEST(Allocations, AreCounted) {
  const std::size_t before = allocations;
  EXPECT_NE(std::make_unique<int>(1), nullptr);
  EXPECT_EQ(allocations, before + 1);
}

TEST(Allocations, AreNoneInATickOfGodzilaTrappedOrNot) {
  const bench::PureRoom room = bench::uInFront(2);
  sim::SimulatedRobot body(room.world, test::nao(), room.start, 0, 2);
  PureSettings settings;
  settings.keeps_traps = true;
  Godzila dut(settings, test::nao()->modes.front().body_m, standingLimits(*test::nao()), Beams{});
  std::size_t in_ticks = 0;
  for (int k = 0; k < 4000; ++k) {
    const Senses& senses = body.sense();
    const std::size_t before = allocations;
    const auto drive = dut.tick(*senses.scan, bearingOf(room.goal, senses.pose->pose));
    in_ticks += allocations - before;
    body.step({drive.velocity, std::nullopt});
  }
  EXPECT_EQ(in_ticks, 0U);
  EXPECT_GT(dut.traps(), 0U) << "the escape has not been tried";
}

TEST(Allocations, AreNoneInATickOfTheExecutorOnAWholeMission) {
  const auto world = test::ourWorld("scenario3");
  Planner planner(world, test::nao());
  Plan plan = *planner.plan(test::requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}), test::soon());
  sim::SimulatedRobot body(world, test::nao(), {0.6, 2.0, 0.0}, 0, 1);
  Executor dut(test::nao());
  dut.follow(std::move(plan), world, *world);
  std::size_t in_ticks = 0;
  for (int k = 0; k < 5000 && dut.state() != State::kArrived; ++k) {
    const Senses& senses = body.sense();
    const std::size_t before = allocations;
    const Tick tick = dut.tick(senses);
    in_ticks += allocations - before;
    body.step(tick.command);
  }
  EXPECT_EQ(dut.state(), State::kArrived);
  EXPECT_EQ(in_ticks, 0U);
}

}  // namespace
}  // namespace underway
