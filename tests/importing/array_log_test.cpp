// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/array_log.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "importing/npy_writer.hpp"

namespace lanefuse {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class ArrayLogTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path(::testing::TempDir()) /
        (std::string("lanefuse_log_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    files_ = {folder_ / "t", {{folder_ / "value", 2, {0}}}};
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Stamps 0, 1, 2, ... s; values equal the row in the kept column and NaN in the other.
  void write(std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
      times_.push_back(static_cast<double>(row));
      values_.push_back({static_cast<double>(row), kNaN});
    }
  }

  ArrayLog read() {
    testing::write_list(folder_ / "t", times_);
    testing::write_table(folder_ / "value", values_);
    return read_array_log(files_, notes_);
  }

  std::filesystem::path folder_;
  ArrayLogFiles files_;
  std::vector<double> times_;
  std::vector<std::vector<double>> values_;
  std::vector<std::string> notes_;
};

TEST_F(ArrayLogTest, KeepsTheColumnsOfInterest) {
  write(3);
  const ArrayLog log = read();
  EXPECT_THAT(log.times, ElementsAre(from_nanoseconds(0), from_nanoseconds(1'000'000'000),
                                     from_nanoseconds(2'000'000'000)));
  EXPECT_EQ(log.values.columns(), 1U);
  EXPECT_EQ(log.values(2, 0), 2);
  EXPECT_THAT(notes_, IsEmpty());
}

TEST_F(ArrayLogTest, EqualStampsAreNoError) {
  write(30);
  times_[4] = times_[3];
  EXPECT_EQ(read().times.size(), 30U);
}

TEST_F(ArrayLogTest, LeavesOutASingleNaN) {
  write(30);
  values_[7][0] = kNaN;
  const ArrayLog log = read();
  EXPECT_EQ(log.times.size(), 29U);
  EXPECT_EQ(log.values(7, 0), 8);
  EXPECT_THAT(notes_,
              ElementsAre(::testing::AllOf(HasSubstr("value"), HasSubstr("1 of 30"), HasSubstr("row 7"))));
}

TEST_F(ArrayLogTest, LeavesOutAStampThatRunsBack) {
  write(30);
  times_[9] = 2.5;
  EXPECT_EQ(read().times.size(), 29U);
  EXPECT_THAT(notes_, ElementsAre(HasSubstr("time runs back")));
}

TEST_F(ArrayLogTest, AStampFarAheadCostsOnlyItself) {
  write(30);
  times_[9] = 1e6;
  const ArrayLog log = read();
  ASSERT_EQ(log.times.size(), 29U);
  EXPECT_EQ(log.values(9, 0), 10);
}

TEST_F(ArrayLogTest, RefusesAHopelessLog) {
  write(30);
  values_[7][0] = values_[11][0] = kNaN;
  EXPECT_THAT([&] { read(); }, ::testing::ThrowsMessage<Error>(
                                   ::testing::AllOf(HasSubstr("value: row 7"), HasSubstr("2 of 30"))));
}

TEST_F(ArrayLogTest, RefusesStampsThatAreNone) {
  write(1);
  times_[0] = -1;
  EXPECT_THAT([&] { read(); }, ::testing::ThrowsMessage<Error>(HasSubstr("t: row 0: -1 is no stamp")));
}

TEST_F(ArrayLogTest, RefusesDifferentLengths) {
  write(30);
  times_.pop_back();
  EXPECT_THAT([&] { read(); },
              ::testing::ThrowsMessage<Error>(::testing::AllOf(HasSubstr("30 rows"), HasSubstr("29"))));
}

TEST_F(ArrayLogTest, RefusesOtherColumns) {
  write(3);
  for (auto& row : values_) row.push_back(0);
  EXPECT_THAT([&] { read(); }, ::testing::ThrowsMessage<Error>(HasSubstr("3 columns instead of 2")));
}

TEST_F(ArrayLogTest, RefusesAnEmptyLog) {
  testing::write_list(folder_ / "t", {});
  testing::write_file(folder_ / "value",
                      testing::npy_bytes(testing::npy_header("<f8", "(0, 2)"), std::vector<double>{}));
  EXPECT_THAT([&] { read_array_log(files_, notes_); },
              ::testing::ThrowsMessage<Error>(HasSubstr("holds nothing")));
}

}  // namespace
}  // namespace lanefuse
