// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/tracking_judge.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "evaluation/tracking_json.hpp"
#include "evaluation/vehicle_sight.hpp"

namespace lanefuse {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(100);
constexpr double kDegree = std::numbers::pi / 180;

/// A drive along a slanted road, so that a mix-up of frames shows.
const Pose2 kWorldFromVehicle{120, -40, 0.6};

struct Frame {
  TrueFrame truth;
  std::vector<TrackedObject> tracks;

  explicit Frame(int index) {
    truth.time = Time{} + (index + 10) * kStep;
    truth.world_from_vehicle = kWorldFromVehicle;
  }
  Frame& vehicle(std::int64_t id, Pose2 rear, double length = 4.5) {
    truth.objects.push_back({id, kWorldFromVehicle * rear, 30, length, 1.8});
    return *this;
  }
  Frame& track(std::int64_t id, Pose2 rear, bool witness = false) {
    TrackedObject object;
    object.id = id;
    object.x = rear.x;
    object.y = rear.y;
    object.heading = rear.heading;
    object.witness = witness;
    tracks.push_back(object);
    return *this;
  }
};

/// `count` frames, each as `make` fills it by its index.
template <typename Make>
TrackingFigures judge(int count, Make make) {
  TrackingJudge judge{TrackingJudgeConfig{}};
  for (int index = 0; index < count; ++index) {
    Frame frame(index);
    make(frame, index);
    judge.add(frame.truth, frame.tracks);
  }
  return judge.figures();
}

TEST(TrackingJudge, PerfectTracksArePerfect) {
  const TrackingFigures figures = judge(11, [](Frame& frame, int index) {
    frame.vehicle(7, {30.0 + index, 0, 0.02}).track(3, {30.0 + index, 0, 0.02}, true);
    frame.vehicle(8, {-20, 3.5, 0}).track(4, {-20, 3.5, 0});
  });
  EXPECT_NEAR(figures.gospa(), 0, 1e-6);
  EXPECT_EQ(figures.all.mota(), 1);
  EXPECT_EQ(figures.all.idf1(), 1);
  EXPECT_EQ(figures.all.recall(), 1);
  EXPECT_EQ(figures.all.precision(), 1);
  EXPECT_EQ(figures.all.id_switches, 0U);
  EXPECT_EQ(figures.tracks, 2U);
  EXPECT_EQ(figures.false_confirmed, 0U);
  EXPECT_EQ(figures.witnesses, 1U);
  EXPECT_EQ(figures.false_witnesses, 0U);
  EXPECT_NEAR(figures.hours * 3600, 1, 1e-9);
  EXPECT_NEAR(figures.all.vehicle_hours * 3600, 2, 1e-9);
  EXPECT_NEAR(figures.confirm_s.quantile(1), 0, 1e-9);
  EXPECT_NEAR(figures.ahead[1].lateral_rmse(), 0, 1e-9);
}

TEST(TrackingJudge, ASwapOfIdsIsTwoSwitchesAndHalvesTheIdentities) {
  const TrackingFigures figures = judge(10, [](Frame& frame, int index) {
    const bool swapped = index >= 5;
    frame.vehicle(1, {30, 0, 0}).vehicle(2, {60, 3.5, 0});
    frame.track(swapped ? 12 : 11, {30, 0, 0}).track(swapped ? 11 : 12, {60, 3.5, 0});
  });
  EXPECT_EQ(figures.all.id_switches, 2U);
  EXPECT_DOUBLE_EQ(figures.all.mota(), 1 - 2.0 / 20);
  EXPECT_DOUBLE_EQ(figures.all.idf1(), 0.5);
  EXPECT_NEAR(figures.all.id_switches_per_vehicle_hour(), 2 / (2 * 0.9 / 3600), 1e-6);
  EXPECT_NEAR(figures.gospa(), 0, 1e-6);  // who is who is not its business
}

TEST(TrackingJudge, AMissedVehicleCostsHalfOfTheSquaredCutoff) {
  const TrackingFigures figures = judge(40, [](Frame& frame, int) {
    frame.vehicle(1, {30, 0, 0}).vehicle(2, {60, 3.5, 0}).track(11, {30, 0, 0});
  });
  EXPECT_NEAR(figures.gospa(), std::sqrt(8), 1e-9);
  EXPECT_NEAR(figures.a_frame(figures.missed_sum), 8, 1e-9);
  EXPECT_EQ(figures.false_sum, 0);
  EXPECT_DOUBLE_EQ(figures.all.recall(), 0.5);
  EXPECT_DOUBLE_EQ(figures.all.mota(), 0.5);
  EXPECT_DOUBLE_EQ(figures.all.idf1(), 2.0 * 40 / (80 + 40));
  EXPECT_EQ(figures.confirmed, 1U);
  EXPECT_EQ(figures.never_confirmed, 1U);
}

TEST(TrackingJudge, AFalseTrackIsCountedOnceAnHour) {
  const TrackingFigures figures = judge(37, [](Frame& frame, int) {
    frame.vehicle(1, {30, 0, 0}).track(11, {31, 0, 0}).track(12, {30, 9, 0}, true);
  });
  EXPECT_NEAR(figures.gospa(), 3, 1e-9);  // 1 m off, and one false
  EXPECT_DOUBLE_EQ(figures.all.precision(), 0.5);
  EXPECT_NEAR(figures.all.mota(), 0, 1e-12);
  EXPECT_EQ(figures.tracks, 2U);
  EXPECT_EQ(figures.false_confirmed, 1U);
  EXPECT_EQ(figures.false_witnesses, 1U);
  EXPECT_NEAR(figures.an_hour(figures.false_confirmed), 1000, 1e-6);  // one in 3.6 s
}

TEST(TrackingJudge, AWitnessMayBeOffAlongButNotAcross) {
  const auto false_witnesses = [](double along, double across) {
    return judge(3,
                 [=](Frame& frame, int) {
                   const Pose2 rear{60, 3.5, 0.3};
                   frame.vehicle(1, rear).track(11, rear * Pose2{along, across, 0}, true);
                 })
        .false_witnesses;
  };
  EXPECT_EQ(false_witnesses(7.9, 0), 0U);
  EXPECT_EQ(false_witnesses(0, -1.9), 0U);
  EXPECT_EQ(false_witnesses(8.1, 0), 1U);
  EXPECT_EQ(false_witnesses(0, 2.1), 1U);
}

TEST(TrackingJudge, LateralAndHeadingErrorsAreAcrossTheVehicleAndByRange) {
  const Pose2 near{30, 0, 0.5};
  const Pose2 far{90, 10, -0.5};
  const TrackingFigures figures = judge(4, [&](Frame& frame, int index) {
    const double side = index % 2 == 0 ? 1 : -1;
    frame.vehicle(1, near).track(11, near * Pose2{1.5, 0.2 * side, 1 * kDegree});
    frame.vehicle(2, far).track(12, far * Pose2{-2, 0.5, -3 * kDegree});
  });
  EXPECT_EQ(figures.ahead[1].n, 4U);
  EXPECT_NEAR(figures.ahead[1].lateral_rmse(), 0.2, 1e-9);
  EXPECT_NEAR(figures.ahead[1].heading_rmse(), 1 * kDegree, 1e-9);
  EXPECT_NEAR(figures.ahead[1].lateral_nees(), 0.04, 1e-9);  // stated: 1 m
  EXPECT_EQ(figures.ahead[4].n, 4U);
  EXPECT_NEAR(figures.ahead[4].lateral_rmse(), 0.5, 1e-9);
  EXPECT_NEAR(figures.ahead[4].heading_rmse(), 3 * kDegree, 1e-9);
  EXPECT_TRUE(std::isnan(figures.ahead[0].lateral_rmse()));
}

TEST(TrackingJudge, AVehicleLongHiddenIsIgnored) {
  // From the sixth frame on a truck stands between the car and vehicle 1; 2 s later nobody asks for it.
  const auto hidden_for = [](int frames, bool tracked) {
    return judge(5 + frames, [=](Frame& frame, int index) {
      frame.vehicle(1, {60, 0, 0});
      if (index >= 5) frame.vehicle(2, {20, 0, 0}, 14).track(12, {20, 0, 0});
      if (tracked) frame.track(11, {60, 0, 0});
    });
  };
  EXPECT_EQ(hidden_for(20, false).all.vehicles, 25U + 20U);
  EXPECT_EQ(hidden_for(60, false).all.vehicles, 25U + 60U);
  const TrackingFigures tracked = hidden_for(60, true);
  EXPECT_EQ(tracked.all.hits, 25U + 60U);
  EXPECT_EQ(tracked.all.false_tracks, 0U);  // neither right nor wrong while it is ignored
  EXPECT_EQ(tracked.all.idf1(), 1);
  EXPECT_EQ(tracked.false_confirmed, 0U);
  EXPECT_NEAR(tracked.gospa(), 0, 1e-6);
}

TEST(TrackingJudge, WhoWasLongHiddenMayComeBackUnderAnotherId) {
  const auto switches_after = [](int hidden_frames) {
    return judge(5 + hidden_frames + 5,
                 [=](Frame& frame, int index) {
                   frame.vehicle(1, {60, 0, 0});
                   const bool hidden = index >= 5 && index < 5 + hidden_frames;
                   if (hidden) frame.vehicle(2, {20, 0, 0}, 14);
                   if (!hidden) frame.track(index < 5 ? 11 : 12, {60, 0, 0});
                 })
        .all.id_switches;
  };
  EXPECT_EQ(switches_after(15), 1U);
  EXPECT_EQ(switches_after(30), 0U);
}

TEST(TrackingJudge, OutOfRangeNobodyIsAskedForNorFalse) {
  const TrackingFigures figures = judge(5, [](Frame& frame, int) {
    frame.vehicle(1, {151, 5, 0}).vehicle(2, {-51, 5, 0});
    frame.track(11, {149.5, 5, 0}).track(12, {170, -5, 0}).track(13, {-60, 0, 0});
  });
  EXPECT_EQ(figures.all.vehicles, 0U);
  EXPECT_EQ(figures.all.false_tracks, 0U);
  EXPECT_EQ(figures.gospa(), 0);
  EXPECT_FALSE(figures.judged());
}

TEST(TrackingJudge, FiguresOfNearbyVehiclesLeaveOutTheFar) {
  const TrackingFigures figures = judge(5, [](Frame& frame, int) {
    frame.vehicle(1, {50, 0, 0}).track(11, {50, 0, 0});
    frame.vehicle(2, {120, 10, 0}).track(12, {130, -10, 0});
  });
  EXPECT_EQ(figures.near.vehicles, 5U);
  EXPECT_EQ(figures.near.mota(), 1);
  EXPECT_EQ(figures.near.idf1(), 1);
  EXPECT_EQ(figures.all.vehicles, 10U);
  EXPECT_NEAR(figures.all.mota(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(figures.all.idf1(), 0.5);
}

TEST(TrackingJudge, TimeToConfirmBeginsWhereAVehicleBeginsToCount) {
  const TrackingFigures figures = judge(30, [](Frame& frame, int index) {
    frame.vehicle(1, {155.0 - index, 5, 0});  // counts from the sixth or so frame on
    if (index >= 16) frame.track(11, {155.0 - index, 5, 0});
  });
  EXPECT_EQ(figures.confirmed, 1U);
  EXPECT_NEAR(figures.confirm_s.quantile(0.5), 1.0, 0.01);  // in range from index 6 on
}

TEST(TrackingFigures, OfTwoDrivesAreThoseOfBoth) {
  const auto drive = [](bool tracked) {
    return judge(11, [=](Frame& frame, int) {
      frame.vehicle(1, {30, 0, 0});
      if (tracked) frame.track(11, {30, 0.3, 0});
    });
  };
  TrackingFigures sum = drive(true);
  sum += drive(false);
  EXPECT_EQ(sum.frames, 22U);
  EXPECT_NEAR(sum.hours * 3600, 2, 1e-9);
  EXPECT_DOUBLE_EQ(sum.all.recall(), 0.5);
  EXPECT_DOUBLE_EQ(sum.all.idf1(), 2.0 * 11 / (22 + 11));
  EXPECT_NEAR(sum.gospa(), (0.3 + std::sqrt(8)) / 2, 1e-9);
  EXPECT_NEAR(sum.ahead[1].lateral_rmse(), 0.3, 1e-9);
  EXPECT_EQ(sum.confirmed, 1U);
}

TEST(TrackingFigures, AreToldInJson) {
  const auto json = to_json(judge(3, [](Frame& frame, int) {
    frame.vehicle(1, {30, 0, 0}).track(11, {30, 0.25, 0});
  }));
  EXPECT_NEAR(json.at("gospa_m").get<double>(), 0.25, 1e-9);
  EXPECT_EQ(json.at("mota"), 1);
  EXPECT_EQ(json.at("lateral_rmse_m").size(), TrackingFigures::kBins);
  EXPECT_TRUE(json.at("lateral_rmse_m")[0].is_null());
  EXPECT_NEAR(json.at("lateral_rmse_m")[1].get<double>(), 0.25, 1e-9);
  EXPECT_EQ(json.at("near").at("range_m"), 100);
  EXPECT_EQ(json.at("false_witnesses_per_hour"), 0);
}

TEST(VehicleSight, SharesOfWhatIsPartlyHidden) {
  Frame frame(0);
  frame.vehicle(1, {20, 0, 0}).vehicle(2, {60, 0, 0}).vehicle(3, {60, 20, 0}).vehicle(4, {60, 2.8, 0});
  const std::vector<double> shares = shares_in_sight(frame.truth);
  EXPECT_EQ(shares[0], 1);
  EXPECT_EQ(shares[1], 0);  // the same size, three times as far
  EXPECT_EQ(shares[2], 1);
  EXPECT_GT(shares[3], 0.3);  // its right edge is behind the first one
  EXPECT_LT(shares[3], 0.9);
}

}  // namespace
}  // namespace lanefuse
