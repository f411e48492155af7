#include "planner/exchange.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/random_world.hpp"
#include "tests/planner/found_way.hpp"

namespace underway {
namespace {

using test::requestFor;

/// Ways with stops, and random places near them.
class Stops {
 public:
  Stops(Policy policy, unsigned seed) : found_("scenario3", policy), random_(seed) {}

  [[nodiscard]] Exchange exchange() const {
    return Exchange(*found_.way(requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0})));
  }
  [[nodiscard]] Option beside(const Option& stop) {
    const double margin_m = found_.checker().robot().margin_m;
    return Option::stop({stop.in.x + random_.between(-0.4, 0.4), stop.in.y + random_.between(-0.4, 0.4)},
                        margin_m);
  }
  [[nodiscard]] const test::FoundWay& found() const { return found_; }

 private:
  test::FoundWay found_;
  test::RandomWorld random_;
};

bool isStopOnLegs(const Exchange& exchange, std::size_t i) {
  const auto& steps = exchange.steps();
  return i > 0 && i + 1 < steps.size() && steps[i].option.is_stop && steps[i].way && steps[i + 1].way;
}

/// By every pair of ways, tried one after the other.
bool triedEach(Exchange& exchange, std::size_t i, const Option& stop) {
  bool is_better = false;
  const Legs* legs = exchange.steps()[i].legs;
  for (std::size_t to = 0; to < legs->ways().size(); ++to)
    for (std::size_t on = 0; on < legs->ways().size(); ++on)
      is_better |= exchange.replace(i, 1, std::array{Exchange::NewStep{&stop, legs, to}}, on);
  return is_better;
}

TEST(Exchange, RejoinsAStopAsWellAsTryingAllWaysDoes) {
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Stops dut(seed == 1 ? Policy::kPriority : Policy::kFastest, seed);
    int better = 0;
    Exchange exchange = dut.exchange();
    for (int round = 0; round < 40; ++round)
      for (std::size_t i = 1; i + 1 < exchange.steps().size(); ++i) {
        if (!isStopOnLegs(exchange, i)) continue;
        const Option stop = dut.beside(exchange.steps()[i].option);
        Exchange slowly = exchange;
        EXPECT_EQ(exchange.rejoin(i, 1, stop), triedEach(slowly, i, stop));
        EXPECT_EQ(Exchange(exchange).passage().cost, Exchange(slowly).passage().cost);
        better += exchange.steps()[i].option.in == stop.in ? 1 : 0;
      }
    EXPECT_GT(better, 3);
  }
}

TEST(Exchange, KeepsItsPassageFreeAndItsCostRight) {
  Stops dut(Policy::kFastest, 3);
  Exchange exchange = dut.exchange();
  int changes = 0;
  for (int round = 0; round < 40; ++round)
    for (std::size_t i = 1; i < exchange.steps().size(); ++i) {
      if (!exchange.steps()[i].way) continue;
      changes += exchange.rejoin(i, 0, dut.beside(exchange.steps()[i - 1].option)) ? 1 : 0;
      if (isStopOnLegs(exchange, i))
        changes += exchange.rejoin(i, 1, dut.beside(exchange.steps()[i].option)) ? 1 : 0;
    }
  EXPECT_GT(changes, 5);
  const Passage passage = Exchange(exchange).passage();
  EXPECT_EQ(Exchange(passage).passage().cost, passage.cost);
  const Route route = routeOf(passage);
  ASSERT_FALSE(route.empty());
  for (const Motion& motion : route) EXPECT_TRUE(dut.found().checker().isFree(motion));
}

}  // namespace
}  // namespace underway
