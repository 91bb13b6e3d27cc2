// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/results_file.hpp"

#include <algorithm>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/synthetic_results.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

using testing::drives;
using ::testing::HasSubstr;
using testing::result_line;
using testing::seed;
using ::testing::SizeIs;

std::string refusal(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    return error.what();
  }
  return {};
}

std::string content(const std::filesystem::path& path) {
  const auto bytes = testing::read_file(path);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class ResultsOnDisk : public ::testing::Test {
 protected:
  void write(const std::string& text) { std::ofstream(path_, std::ios::binary) << text; }

  testing::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "results.jsonl";
};

TEST(ResultLines, TheNoiseIsPartOfTheKeyAndOneUnlessSaid) {
  DriveKey noisy = seed(1);
  noisy.noise = 0.5;
  EXPECT_EQ(result_line(noisy, 0.1).key, noisy);
  EXPECT_EQ(to_string(noisy), to_string(seed(1)) + ", noise x 0.5");
  const ResultLine unsaid = result_line(seed(1), 0.1);
  EXPECT_FALSE(unsaid.json.contains("noise")) << "as in files from before";
  nlohmann::ordered_json json = unsaid.json;
  json["noise"] = 1;
  const ResultLine said = parse_line(json.dump(), "here");
  EXPECT_EQ(said.key, seed(1));
  EXPECT_TRUE(same_figures(unsaid, said));
  json["noise"] = -1;
  EXPECT_THROW(parse_line(json.dump(), "here"), Error);
}

TEST_F(ResultsOnDisk, WhatIsWrittenIsRead) {
  const auto written = drives({0.1, 0.2});
  {
    ResultsWriter writer(path_, 0);
    for (const ResultLine& line : written) writer.append(line.text);
  }
  const ResultsFile file = read_results(path_);
  ASSERT_THAT(file.lines, SizeIs(2));
  EXPECT_FALSE(file.cut_off);
  EXPECT_EQ(file.whole_bytes, std::filesystem::file_size(path_));
  EXPECT_EQ(file.lines[1].key, seed(2));
  EXPECT_EQ(file.lines[1].text, written[1].text);
  EXPECT_EQ(file.lines[1].provenance, (Provenance{"1", "p", "s", "c"}));
}

TEST_F(ResultsOnDisk, ACutLineIsNoticedAndWrittenAnewWhereverItWasCut) {
  const auto lines = drives({0.1, 0.2});
  const std::string first = lines[0].text + "\n";
  for (std::size_t kept = 1; kept <= lines[1].text.size(); ++kept) {
    write(first + lines[1].text.substr(0, kept));
    const ResultsFile file = read_results(path_);
    ASSERT_TRUE(file.cut_off) << kept;
    ASSERT_THAT(file.lines, SizeIs(1));
    if (kept % 100 != 1) continue;
    ResultsWriter(path_, file.whole_bytes).append(lines[1].text);
    ASSERT_EQ(content(path_), first + lines[1].text + "\n");
  }
}

TEST_F(ResultsOnDisk, AnothersFileIsRefusedAndKept) {
  for (const char* text :
       {"a poem without an end of line", "a poem\n", "{}\n", "[1]\n", "{\"scene\": 3}\n", "\n"}) {
    write(text);
    EXPECT_THAT(refusal([&] { read_results(path_); }), HasSubstr("results.jsonl:1")) << text;
    EXPECT_EQ(content(path_), text);
  }
  EXPECT_THAT(refusal([&] { read_results(folder_ / "none"); }), HasSubstr("cannot be read"));
}

TEST_F(ResultsOnDisk, ABrokenLineIsNamed) {
  write(drives({0.1})[0].text + "\n{\"scene\":\"nominal\"}\n");
  EXPECT_THAT(refusal([&] { read_results(path_); }), HasSubstr("results.jsonl:2"));
}

ResultsFile file_of(std::vector<ResultLine> lines) { return {"x", std::move(lines), 0, false}; }

TEST(Merge, SortsAndDropsRepeats) {
  const auto lines = drives({0.1, 0.2, 0.3});
  const auto merged = merge_results({file_of({lines[2], lines[0]}), file_of({lines[1], lines[2]})});
  ASSERT_THAT(merged, SizeIs(3));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(merged[i].text, lines[i].text);
}

TEST(Merge, WallClockTimesAreNoContradiction) {
  ResultLine timed = drives({0.1})[0];
  timed.json["wall_s"] = 3.5;
  timed.json["cycle_ms"] = {{"p50", 1.0}};
  EXPECT_THAT(merge_results({file_of({drives({0.1})[0]}), file_of({timed})}), SizeIs(1));
}

TEST(Merge, OtherFiguresOfOneDriveAreAContradiction) {
  EXPECT_THAT(refusal([] {
                merge_results({file_of(drives({0.1})), file_of(drives({0.2}))});
              }),
              HasSubstr("contradicts"));
}

TEST(Merge, OtherOriginsOfOneDriveAreNamed) {
  const auto refusal_of = [](const Provenance& other) {
    return refusal([&] {
      merge_results({file_of({result_line(seed(1), 0.1)}), file_of({result_line(seed(1), 0.1, other)})});
    });
  };
  EXPECT_THAT(refusal_of({"1", "other", "s", "c"}), HasSubstr("preset"));
  EXPECT_THAT(refusal_of({"1", "p", "s", "other"}), HasSubstr("configuration"));
  EXPECT_THAT(refusal_of({"1", "p", "other", "c"}), HasSubstr("scene"));
  EXPECT_THAT(refusal_of({"2", "p", "s", "c"}), HasSubstr("version"));
}

TEST(Merge, VariantsOfOneDriveAreTwoDrives) {
  DriveKey other = seed(1);
  other.variant = "no-width";
  EXPECT_THAT(
      merge_results({file_of({result_line(seed(1), 0.1), result_line(other, 0.2, {"1", "p", "s", "d"})})}),
      SizeIs(2));
}

}  // namespace
}  // namespace lanefuse
