#include "bench/number_table.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace underway::bench {
namespace {

class NumberTable : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(file_) << "id,x,y,by\n0,1.5,-2,someone\n1,3,4e1,\n"; }
  void TearDown() override { std::filesystem::remove(file_); }
  const std::filesystem::path file_ =
      std::filesystem::path(testing::TempDir()) / "underway_number_table_test.csv";
};

TEST_F(NumberTable, GivesTheColumnsInTheOrderAskedFor) {
  const std::vector<std::string> columns{"y", "x"};
  const auto dut = readNumbers(file_, columns);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(*dut, (std::vector<std::vector<double>>{{-2.0, 1.5}, {40.0, 3.0}}));
}

TEST_F(NumberTable, NamesWhatItCannotRead) {
  const std::vector<std::string> words{"by"};
  const std::vector<std::string> missing{"z"};
  EXPECT_NE(readNumbers(file_, words).error().message.find(":2: column by"), std::string::npos);
  EXPECT_NE(readNumbers(file_, missing).error().message.find("no column z"), std::string::npos);
  EXPECT_FALSE(readNumbers(file_ / "nowhere", words));
}

}  // namespace
}  // namespace underway::bench
