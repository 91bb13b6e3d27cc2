// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/sensor_suite.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

/// Says that it looked.
class Watch final : public SensorModel {
 public:
  explicit Watch(double hz) : hz_(hz) {}
  [[nodiscard]] SensorDescription description() const override {
    return {7, SensorKind::long_range_radar, "watch", {}};
  }
  [[nodiscard]] double hz() const override { return hz_; }
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override {
    measurements.emplace_back(RadarScan{stamp(description(), scene.time, 0), {}});
  }

 private:
  double hz_;
};

/// The ticks in which a sensor of that rate looks.
std::vector<int> looks(double hz, int ticks) {
  SensorSuite suite(12.5);
  suite.add(std::make_unique<Watch>(hz));
  std::vector<int> looks;
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  for (int tick = 0; tick < ticks; ++tick) {
    Scene scene;
    scene.time = suite.next();
    suite.look(scene, false, measurements, truth);
    if (!measurements.empty()) looks.push_back(tick);
  }
  return looks;
}

TEST(SensorSuite, LooksAtTheFirstTickOfEachPeriod) {
  EXPECT_THAT(looks(12.5, 13), testing::ElementsAre(0, 4, 8, 12));
  EXPECT_THAT(looks(15, 15), testing::ElementsAre(0, 4, 7, 10, 14));
  EXPECT_THAT(looks(20, 11), testing::ElementsAre(0, 3, 5, 8, 10));
  EXPECT_EQ(looks(50, 100).size(), 100u);
  EXPECT_EQ(looks(15, 50'000).size(), 15'000u);
}

TEST(SensorSuite, RefusesSensorsFasterThanItsTicks) {
  SensorSuite suite(12.5);
  EXPECT_THROW(suite.add(std::make_unique<Watch>(51)), Error);
  EXPECT_THROW(suite.add(std::make_unique<Watch>(0)), Error);
  EXPECT_THROW(SensorSuite(100), Error);
}

}  // namespace
}  // namespace lanefuse
