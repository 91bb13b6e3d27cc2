// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/report.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "drawing/html.hpp"
#include "support/markup.hpp"
#include "support/picture_scene.hpp"

namespace lanefuse {
namespace {

using testing::believable_exact_result;
using testing::believable_path_result;
using testing::believable_report;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Numbers, AreRoundedForReaders) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(metres(0.1249), "0.12");
  EXPECT_EQ(metres(-0.001), "0.00");
  EXPECT_EQ(metres(-0.26), "-0.26");
  EXPECT_EQ(metres(kNan), "-");
  EXPECT_EQ(percent(1), "100 %");
  EXPECT_EQ(percent(0.9996), "> 99.9 %");
  EXPECT_EQ(percent(0.0004), "< 0.1 %");
  EXPECT_EQ(percent(0), "0.0 %");
  EXPECT_EQ(percent(0.985), "98.5 %");
  EXPECT_EQ(percent(kNan), "-");
  EXPECT_EQ(factor(1.234), "1.23");
  EXPECT_EQ(factor(123.4), "123");
  EXPECT_EQ(grouped(7), "7");
  EXPECT_EQ(grouped(123456), "123,456");
  EXPECT_EQ(grouped(1234567), "1,234,567");
}

TEST(WriteReport, IsOnePageThatNeedsNothingElse) {
  for (const EvaluationResult& result :
       {believable_exact_result(), believable_path_result(), EvaluationResult{}}) {
    const std::string html = write_report(believable_report(result));
    EXPECT_EQ(testing::malformed(html), "");
    EXPECT_TRUE(testing::addresses(html).empty());
    EXPECT_FALSE(testing::prints_nan(html));
    EXPECT_EQ(html, write_report(believable_report(result)));
  }
}

TEST(WriteReport, WithNothingToTellSaysNoData) {
  const std::string html = write_report({});
  EXPECT_EQ(testing::malformed(html), "");
  EXPECT_FALSE(testing::prints_nan(html));
  EXPECT_TRUE(contains(html, "No data: the run has no cycles."));
}

TEST(WriteReport, NamesTheWitnessRule) {
  EXPECT_TRUE(contains(write_report(believable_report(believable_path_result())), "witness: radar_only"));
  EXPECT_TRUE(
      contains(write_report(believable_report(believable_exact_result())), "witness: radar_and_camera"));
}

TEST(WriteReport, EscapesWhatComesFromOutside) {
  Report report = believable_report(believable_exact_result());
  report.title = "<b>&";
  report.evaluation.drive.name = "a<b>\"c\"";
  report.moments[0].caption = "x < y & z";
  const std::string html = write_report(report);
  EXPECT_EQ(testing::malformed(html), "");
  EXPECT_TRUE(contains(html, "a&lt;b&gt;&quot;c&quot;"));
  EXPECT_TRUE(contains(html, "x &lt; y &amp; z"));
}

TEST(WriteReport, HasARowForEveryDistanceAndAFigureForEveryMoment) {
  const Report report = believable_report(believable_exact_result());
  const std::string html = write_report(report);
  // Two rows of headings and one a distance, of the errors and of what is said of them; the same at every
  // other distance beside Table I; the traffic's two tables have a row a range.
  const int ranges =
      static_cast<int>(report.evaluation.by_vehicles_ahead.size() + report.evaluation.by_gap_ahead.size());
  EXPECT_EQ(testing::occurrences(html, "<tr>"),
            2 * (2 + static_cast<int>(kDistanceCount)) + 2 + 7 + 4 + ranges);
  EXPECT_EQ(testing::occurrences(html, "<figure>"), 1);
  EXPECT_TRUE(contains(html, "<td>" + metres(report.evaluation.lanes.ego[6].rmse_m) + "</td>"));
  EXPECT_TRUE(contains(html, "51,234"));
}

TEST(WriteReport, AgainstTheDrivenPathIsSilentOnTableOneAndTraffic) {
  const std::string html = write_report(believable_report(believable_path_result()));
  for (const char* section : {"Table I", "Error and traffic", "On the map", "serial camera alone"}) {
    EXPECT_FALSE(contains(html, section)) << section;
  }
}

TEST(WriteReport, ShowsTheDriveAndItsMomentsOnTheMap) {
  Report report = believable_report(believable_exact_result());
  EXPECT_FALSE(contains(write_report(report), "On the map"));
  for (int i = 0; i < 50; ++i) report.trace.push_back({{30.0 * i, 0.1 * i * i}, 0.02 * i});
  report.trace[20].error = std::numeric_limits<double>::quiet_NaN();
  report.moments[0].world_from_vehicle = Pose2{100, -40, 0.6};
  const std::string html = write_report(report);
  EXPECT_TRUE(contains(html, "On the map"));
  EXPECT_TRUE(contains(html, "along the drive"));
  EXPECT_FALSE(testing::prints_nan(html));
  EXPECT_EQ(testing::malformed(html), "");
}

TEST(WriteReport, PutsTheSerialCameraBesideTheEgoLane) {
  EvaluationResult result = believable_exact_result();
  result.serial_camera = SerialCameraStatistics{result.lanes.ego, result.lanes.ego};
  const std::string html = write_report(believable_report(result));
  EXPECT_TRUE(contains(html, "Beside the serial camera alone"));
  EXPECT_TRUE(contains(html, "serial camera, within its range [m]"));
}

TEST(WriteReport, TellsOfTheVehiclesTracked) {
  EvaluationResult result = believable_exact_result();
  EXPECT_FALSE(contains(write_report(believable_report(result)), "Vehicles tracked"));
  TrackingFigures& tracking = result.tracking.emplace();
  tracking.frames = 1000;
  tracking.hours = 0.5;
  tracking.gospa_sum = 1230;
  tracking.all = {.vehicles = 5000, .hits = 4900, .false_tracks = 10, .id_switches = 2, .id_hits = 4800};
  tracking.tracks = 40;
  tracking.false_confirmed = 3;
  for (int i = 0; i < 100; ++i) tracking.ahead[2].add(0.25, 0.2, 0.01);
  const std::string html = write_report(believable_report(result));
  EXPECT_EQ(testing::malformed(html), "");
  EXPECT_FALSE(testing::prints_nan(html));
  for (const char* part : {"Vehicles tracked", "1.23 m a frame", "3 of 40, 6.00 an hour", "<td>40-60</td>",
                           "<td>0.25</td>", "lateral RMSE by range", "<td>98.0 %</td>"}) {
    EXPECT_TRUE(contains(html, part)) << part;
  }
}

DeviationStatistics at(double distance, double rmse, double availability) {
  return {distance, 0, rmse, rmse, 2 * rmse, availability, 100};
}

EvaluationResult round_figures() {
  EvaluationResult result;
  result.cycles = result.cycles_ok = result.cycles_with_truth = 100;
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    result.lanes.ego.push_back(at(distance_at(i), 0.01 * static_cast<double>(i), 0.5));
  }
  return result;
}

TEST(Verdict, StatesTheFiguresThatMatter) {
  EvaluationResult result = round_figures();
  result.lanes.adjacent = result.lanes.ego;
  EXPECT_EQ(verdict(result),
            "The ego lane's boundaries are off by 0.06 m at 60 m and 0.10 m at 100 m (RMSE), and reach 60 m "
            "in 50.0 % of "
            "the cycles. Adjacent lanes: 0.06 m at 60 m and 0.10 m at 100 m, reaching 60 m in 50.0 %.");
  result.lanes.adjacent.clear();
  EXPECT_TRUE(contains(verdict(result), "No adjacent lane could be judged."));
}

TEST(Verdict, PutsTheBaselinesBesideTheEgoPath) {
  EvaluationResult result = round_figures();
  result.baselines.emplace();
  result.baselines->arc = result.lanes.ego;
  result.baselines->straight = result.lanes.ego;
  result.availability_with_vehicle_ahead.assign(kDistanceCount, {60, 0.9, 40});
  const std::string text = verdict(result);
  EXPECT_TRUE(contains(text, "the arc of the current yaw rate by 0.06 m at 60 m and 0.10 m at 100 m"));
  EXPECT_TRUE(contains(text, "90.0 % of those with a moving vehicle tracked ahead."));
}

TEST(Verdict, IsHonestAboutWhatIsMissing) {
  EvaluationResult result;
  result.cycles = 5;
  EXPECT_TRUE(contains(verdict(result), "none of the 5 cycles has truth"));
  result.cycles_with_truth = 5;
  EXPECT_TRUE(contains(verdict(result), "in none of the 5 cycles with truth was there an ego lane"));
}

}  // namespace
}  // namespace lanefuse
