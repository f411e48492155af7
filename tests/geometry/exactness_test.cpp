#include "bench/exactness.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "geometry/overlap_simd.hpp"

/// The engine against the slow reference on random cases, many within nanometres of contact; the benchmark
/// runs a hundred times as many.
namespace underway {
namespace {

constexpr std::uint64_t kSeed = 20;  // the benchmark's cases are others

void expectExact(const bench::Exactness& found) {
  EXPECT_EQ(found.missed, 0U) << "of " << found.collisions << " collisions";
  EXPECT_EQ(found.false_alarms, 0U) << "of " << found.cases << " cases";
  EXPECT_EQ(found.disagreements, 0U) << "one by one, in a batch and by visiting must be the same";
  EXPECT_EQ(found.doubtful, 0U) << "the two references must agree beyond 1 um from contact";
  EXPECT_GT(found.collisions, found.cases / 20) << "the cases are too easy";
  EXPECT_GT(found.near_contact, found.cases / 100) << "the cases are too easy";
  EXPECT_LT(found.near_contact, found.cases / 10) << "too many cases are not decided";
}

TEST(Exactness, AMillionBodiesAndObstaclesAreToldAsTheReferenceTellsThem) {
  const auto found = bench::comparePairs(kSeed, 1'000'000);
  expectExact(found);
  EXPECT_EQ(found.fcl_false_alarms + found.fcl_missed, 0U) << "FCL's booleans on boxes are right";
}

TEST(Exactness, AHundredThousandMotionsAreToldAsTheReferenceTellsThem) {
  const auto found = bench::compareMotions(kSeed, 100'000);
  expectExact(found);
  EXPECT_EQ(found.fcl_false_alarms, 0U);
}

TEST(Exactness, ClearancesAreNeverAboveTheTruthAndHardlyBelow) {
  const auto found = bench::compareClearances(kSeed, 10'000);
  EXPECT_EQ(found.above_truth, 0U);
  EXPECT_LE(found.shortfall_of_poses_m, 1e-6);
  EXPECT_LE(found.shortfall_of_turns_m, 1e-3);
}

class InstructionSets : public testing::Test {
 protected:
  void TearDown() override { useInstructionSet(instructionSets().front()); }
};

TEST_F(InstructionSets, AllGiveTheSameAnswers) {
  if (instructionSets().size() < 2)
    GTEST_SKIP() << "NOT TESTED: this machine has only " << instructionSets()[0];
  std::optional<std::uint64_t> first;
  for (const std::string& name : instructionSets()) {
    SCOPED_TRACE(name);
    useInstructionSet(name);
    const auto pairs = bench::comparePairs(kSeed + 1, 200'000);
    const auto motions = bench::compareMotions(kSeed + 1, 10'000);
    expectExact(pairs);
    expectExact(motions);
    const std::uint64_t answers = pairs.answers + 31 * motions.answers;
    EXPECT_EQ(answers, first.value_or(answers));
    first = answers;
  }
}

TEST_F(InstructionSets, OneThatIsNotThereIsRefused) {
  EXPECT_THROW(useInstructionSet("abacus"), std::invalid_argument);
}

}  // namespace
}  // namespace underway
