// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/npy.hpp"

#include <ostream>

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "importing/npy_writer.hpp"

namespace lanefuse {
namespace {

using ::testing::HasSubstr;
using testing::npy_bytes;
using testing::npy_header;

std::string error_of(const std::string& bytes) {
  try {
    parse_npy(bytes, "some/array");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    EXPECT_THAT(error.what(), ::testing::StartsWith("some/array: "));
    return error.what();
  }
  return "no error";
}

const std::vector<double> kSix = {1, 2, 3, 4, 5, 6};

TEST(Npy, ReadsATableRowByRow) {
  const NpyTable table = parse_npy(npy_bytes(npy_header("<f8", "(3, 2)"), kSix), "array");
  ASSERT_EQ(table.rows(), 3U);
  ASSERT_EQ(table.columns(), 2U);
  EXPECT_EQ(table(0, 1), 2);
  EXPECT_EQ(table(2, 0), 5);
}

TEST(Npy, ReadsFortranOrderColumnByColumn) {
  const NpyTable table = parse_npy(npy_bytes(npy_header("<f8", "(3, 2)", true), kSix), "array");
  EXPECT_EQ(table(0, 1), 4);
  EXPECT_EQ(table(2, 0), 3);
}

TEST(Npy, ReadsAListAsOneColumn) {
  const NpyTable table = parse_npy(npy_bytes(npy_header("<f8", "(6,)"), kSix), "array");
  EXPECT_EQ(table.rows(), 6U);
  EXPECT_EQ(table.columns(), 1U);
  EXPECT_EQ(table(5, 0), 6);
}

TEST(Npy, ReadsAnEmptyList) {
  EXPECT_EQ(parse_npy(npy_bytes(npy_header("<f8", "(0,)"), std::vector<double>{}), "array").rows(), 0U);
}

TEST(Npy, ReadsVersionTwoAndPythonTwosSizes) {
  const NpyTable table = parse_npy(npy_bytes(npy_header("<f8", "(3L, 2L)"), kSix, 2), "array");
  EXPECT_EQ(table(2, 1), 6);
}

template <typename Number>
void expect_minus_or_one(const std::string& type) {
  const std::vector<Number> numbers = {static_cast<Number>(-1), 7};
  const NpyTable table = parse_npy(npy_bytes(npy_header(type, "(2,)"), numbers), type);
  EXPECT_EQ(table(0, 0), static_cast<double>(static_cast<Number>(-1))) << type;
  EXPECT_EQ(table(1, 0), 7) << type;
}

TEST(Npy, ReadsEveryNumberType) {
  expect_minus_or_one<double>("<f8");
  expect_minus_or_one<float>("<f4");
  expect_minus_or_one<std::int64_t>("<i8");
  expect_minus_or_one<std::int32_t>("<i4");
  expect_minus_or_one<std::int16_t>("<i2");
  expect_minus_or_one<std::int8_t>("|i1");
  expect_minus_or_one<std::uint32_t>("<u4");
  expect_minus_or_one<std::uint16_t>("<u2");
  expect_minus_or_one<std::uint8_t>("|u1");
}

TEST(Npy, ReadsTruthValues) {
  const std::vector<std::uint8_t> bits = {0, 1};
  EXPECT_EQ(parse_npy(npy_bytes(npy_header("|b1", "(2,)"), bits), "array")(1, 0), 1);
}

TEST(Npy, RefusesWholeNumbersThatADoubleCannotHold) {
  const std::vector<std::uint64_t> numbers = {1, (std::uint64_t{1} << 53U) + 2};
  EXPECT_THAT(error_of(npy_bytes(npy_header("<u8", "(2,)"), numbers)), HasSubstr("row 1"));
}

TEST(Npy, RefusesWhatIsNoArray) {
  EXPECT_THAT(error_of("PK\x03\x04 a zip file"), HasSubstr("no NumPy array"));
}

TEST(Npy, RefusesAnUnknownVersion) {
  EXPECT_THAT(error_of(npy_bytes(npy_header("<f8", "(6,)"), kSix, 3)), HasSubstr("version 3"));
}

struct Refusal {
  std::string header;
  std::string reason;

  /// Names the test in reports.
  friend std::ostream& operator<<(std::ostream& stream, const Refusal& refusal) {
    return stream << refusal.reason;
  }
};

class NpyRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(NpyRefusal, NamesItsReason) {
  EXPECT_THAT(error_of(npy_bytes(GetParam().header, kSix)), HasSubstr(GetParam().reason));
}

INSTANTIATE_TEST_SUITE_P(
    Headers, NpyRefusal,
    ::testing::Values(
        Refusal{npy_header(">f8", "(6,)"), "big-endian"}, Refusal{npy_header("|O", "(6,)"), "Python objects"},
        Refusal{npy_header("<c16", "(3,)"), "'<c16' is not read"},
        Refusal{npy_header("<f2", "(6,)"), "not read"}, Refusal{npy_header("<f8", "()"), "0 dimensions"},
        Refusal{npy_header("<f8", "(1, 2, 3)"), "3 dimensions"},
        Refusal{npy_header("<f8", "(5,)"), "needs 40 bytes, 48 follow"},
        Refusal{npy_header("<f8", "(7,)"), "48 bytes"},
        Refusal{npy_header("<f8", "(4294967296, 4294967296)"), "needs more than"},
        Refusal{npy_header("<f8", "(99999999999999999999999,)"), "beyond all bounds"},
        Refusal{npy_header("<f8", "(-6,)"), "not a tuple of sizes"},
        Refusal{npy_header("<f8", "6"), "'(' is missing"},
        Refusal{"{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (6,)}", "structured"},
        Refusal{"{'descr': '<f8', 'fortran_order': 0, 'shape': (6,)}", "neither True nor False"},
        Refusal{"{'descr': '<f8', 'shape': (6,)}", "needed once each"},
        Refusal{"{'descr': '<f8', 'descr': '<f8', 'fortran_order': False, 'shape': (6,)}", "twice"},
        Refusal{"{'descr': '<f8', 'fortran_order': False, 'shape': (6,), 'more': 1}", "unknown entry 'more'"},
        Refusal{"{'descr': '<f8', 'fortran_order': False, 'shape': (6,)} 7", "behind the dictionary"},
        Refusal{"{'descr: <f8", "does not end"}, Refusal{"", "'{' is missing"}));

TEST(Npy, RefusesEveryTruncation) {
  const std::string whole = npy_bytes(npy_header("<f8", "(3, 2)"), kSix);
  ASSERT_NO_THROW(parse_npy(whole, "array"));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_NE(error_of(whole.substr(0, length)), "no error") << "cut after " << length << " bytes";
  }
}

TEST(Npy, RefusesBytesBehindTheArray) {
  EXPECT_THAT(error_of(npy_bytes(npy_header("<f8", "(6,)"), kSix) + "x"), HasSubstr("49 follow"));
}

TEST(Npy, NamesAFileThatIsNotThere) {
  EXPECT_THAT([] { read_npy("no/such/file"); }, ::testing::ThrowsMessage<Error>(HasSubstr("no/such/file")));
}

}  // namespace
}  // namespace lanefuse
