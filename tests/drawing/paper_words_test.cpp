// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/paper_words.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "evaluation/table_one.hpp"

namespace lanefuse {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The paper's own figures, with so many deviations each.
EvaluationResult the_papers_own() {
  EvaluationResult result;
  for (const PaperRow& row : kTableOne) {
    const auto of = [&row](const PaperFigures& paper) {
      return DeviationStatistics{row.distance, paper.mean, paper.sigma, paper.rmse, 2 * paper.rmse, 1, 1000};
    };
    result.lanes.ego.push_back(of(row.ego));
    result.lanes.adjacent.push_back(of(row.adjacent));
  }
  return result;
}

TEST(WordsOnTableOne, SayThatAllIsAlike) {
  const auto words = words_on_table_one(the_papers_own());
  ASSERT_EQ(words.size(), 1U);
  EXPECT_TRUE(contains(words[0], "Every RMSE is within 35 %"));
}

TEST(WordsOnTableOne, NameWhatIsWorseAndWhatOfItTheFiguresExplain) {
  EvaluationResult result = the_papers_own();
  result.lanes.ego[3] = {60, -0.5, 0.1, 0.51, 0.6, 1, 1000};
  result.by_gap_ahead.push_back({20, 40, 500, {}});
  result.by_gap_ahead[0].lanes.ego.push_back({60, 0, 0.9, 0.9, 1, 1, 400});
  const auto words = words_on_table_one(result);
  ASSERT_EQ(words.size(), 1U);
  EXPECT_TRUE(contains(words[0], "Worse than Table I"));
  EXPECT_TRUE(contains(words[0], "ego lane at 60 m (0.51 m, 1.82 times the paper's)"));
  EXPECT_TRUE(contains(words[0], "a bias, mean -0.50 m"));
  EXPECT_TRUE(contains(words[0], "with the next vehicle 20 to 40 m ahead: 0.90 m"));
}

TEST(WordsOnTableOne, TellGrossErrorsFromScatter) {
  EvaluationResult result = the_papers_own();
  result.cycles_with_ego_lane = 1000;
  result.cycles_in_wrong_lane = 30;
  result.lanes.adjacent[0] = {0, 0, 0.6, 0.6, 0.3, 1, 1000};
  const auto words = words_on_table_one(result);
  EXPECT_TRUE(contains(words[0], "A few gross errors make it"));
  EXPECT_TRUE(contains(words[0], "the wrong lane in 3.0 % of the cycles"));
}

TEST(WordsOnTableOne, DoubtWhatIsTooGood) {
  EvaluationResult result = the_papers_own();
  result.lanes.adjacent[6].rmse_m = 0.3;
  EXPECT_TRUE(contains(words_on_table_one(result)[0], "the truth, which has no error here"));
  result.surveyed = SurveyedTruthConfig{0.2, 0.2, 0, 1};
  result.serial_camera.emplace();
  result.serial_camera->extrapolated = result.lanes.ego;
  const auto words = words_on_table_one(result);
  EXPECT_TRUE(contains(words[0], "Better than Table I"));
  EXPECT_TRUE(
      contains(words[0], "At 120 m the truth's own error is 0.20 m of it; without that 0.22 m are left"));
  EXPECT_TRUE(contains(words[0], "sensors that are kinder"));
  EXPECT_TRUE(contains(words[0],
                       "The serial camera alone, extrapolated, is off by 0.64 m at 120 m in the ego lane."));
}

TEST(WordsOnTableOne, SayThatNothingWasJudged) {
  EXPECT_EQ(words_on_table_one({}).size(), 1U);
  EXPECT_TRUE(contains(words_on_table_one({})[0], "Nothing could be compared"));
}

}  // namespace
}  // namespace lanefuse
