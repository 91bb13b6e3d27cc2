// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/sumo_traffic.hpp"

#include "core/error.hpp"

#ifndef LANEFUSE_HAS_SUMO

namespace lanefuse {

std::unique_ptr<TrafficModel> sumo_traffic(const Road&, const TrafficConfig&, double, std::uint64_t) {
  throw configuration_error("--traffic sumo", "this program was built without SUMO",
                            "install the package sumo and configure with -DLANEFUSE_SUMO=ON");
}

}  // namespace lanefuse

#else

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <libsumo/libsumo.h>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "simulation/sumo_network.hpp"

namespace lanefuse {
namespace {

constexpr double kStep = 0.05;          ///< [s] of SUMO
constexpr double kReach = 300;          ///< [m] ahead of and behind the ego car
constexpr double kReaction = 0.4;       ///< [s] of the hands and of the car: SUMO moves sideways by jerks
constexpr int kKeepsItsLane = 512;      ///< SUMO's mode of a vehicle that changes no lane by itself
constexpr double kFrontOverhang = 0.9;  ///< [m] of the ego car

/// A folder for SUMO's input files, gone with its owner.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "lanefuse-sumo-XXXXXX").string();
    if (!mkdtemp(name.data())) throw configuration_error(name, "cannot be made", "free room for it");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] std::string write(const char* name, const std::string& text) const {
    std::ofstream file(path_ / name);
    file << text;
    if (!file.flush()) throw configuration_error((path_ / name).string(), "cannot be written");
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

/// Across the road, after the driver's hands and the car: position and speed without jumps.
class Smoothed {
 public:
  explicit Smoothed(double wish) : wish_(wish), hand_(wish), wheel_(wish) {}
  void advance(double wish, double seconds) {
    wish_ = wish;
    hand_ += seconds * (wish_ - hand_) / kReaction;
    wheel_ += seconds * speed();
  }
  [[nodiscard]] double position() const { return wheel_; }
  [[nodiscard]] double speed() const { return (hand_ - wheel_) / kReaction; }
  [[nodiscard]] double acceleration() const { return ((wish_ - hand_) / kReaction - speed()) / kReaction; }

 private:
  double wish_;
  double hand_;
  double wheel_;
};

/// What SUMO said of a vehicle at the last two of its steps.
struct Followed {
  double length;
  double width;
  double station[2];  ///< [m] of the front bumper, at the step before and at the last one
  double lateral[2];  ///< [m]
  double speed[2];    ///< [m/s] along the road
  Smoothed across;
};

class SumoTraffic final : public TrafficModel {
 public:
  SumoTraffic(const Road& road, const TrafficConfig& config, double start, std::uint64_t seed);
  ~SumoTraffic() override { libsumo::Simulation::close(); }
  SumoTraffic(const SumoTraffic&) = delete;
  SumoTraffic& operator=(const SumoTraffic&) = delete;

  void advance(double seconds) override;
  [[nodiscard]] Scene scene(Time time) const override;

 private:
  const Road& road_;
  double since_step_ = 0;                      ///< [s] since the step before
  std::map<std::int64_t, Followed> vehicles_;  ///< by id

  void step();
  [[nodiscard]] double share() const { return std::clamp(since_step_ / kStep, 0.0, 1.0); }
  [[nodiscard]] SceneVehicle show(std::int64_t id, const Followed& vehicle) const;
};

SumoTraffic::SumoTraffic(const Road& road, const TrafficConfig& config, double start, std::uint64_t seed)
    : road_(road) {
  if (libsumo::Simulation::isLoaded()) {
    throw configuration_error("--traffic sumo", "SUMO runs already in this process",
                              "run one drive after the other");
  }
  const ScratchFolder folder;
  const std::string network = folder.write("road.net.xml", sumo_network(road));
  const std::string vehicles = folder.write("road.rou.xml", sumo_vehicles(road, config, start, seed));
  libsumo::Simulation::start({"sumo", "-n", network, "-r", vehicles, "--step-length",
                              fmt::format("{}", kStep), "--step-method.ballistic", "--lateral-resolution",
                              "0.4", "--seed", std::to_string(seed % 2'000'000'000), "--no-warnings",
                              "--no-step-log", "--xml-validation", "never", "--time-to-teleport", "-1"});
  step();
  step();
  if (vehicles_.contains(kEgoId) && config.ego.lane_change_every == TrafficConfig::kNever)
    libsumo::Vehicle::setLaneChangeMode(kSumoEgo, kKeepsItsLane);
  if (!vehicles_.contains(kEgoId))
    throw configuration_error("--traffic sumo", "SUMO found no room for the ego car",
                              "choose a lower density");
}

/// Vehicles that SUMO no longer has are forgotten.
void SumoTraffic::step() {
  libsumo::Simulation::step();
  std::map<std::int64_t, Followed> now;
  for (const std::string& name : libsumo::Vehicle::getIDList()) {
    const std::int64_t id = std::stoll(name);
    const libsumo::TraCIPosition place = libsumo::Vehicle::getPosition(name);
    const double speed = libsumo::Vehicle::getSpeed(name);
    const auto before = vehicles_.find(id);
    if (before == vehicles_.end()) {
      now.emplace(id, Followed{libsumo::Vehicle::getLength(name),
                               libsumo::Vehicle::getWidth(name),
                               {place.x, place.x},
                               {place.y, place.y},
                               {speed, speed},
                               Smoothed(place.y)});
      continue;
    }
    Followed& followed = now.emplace(id, before->second).first->second;
    followed.station[0] = std::exchange(followed.station[1], place.x);
    followed.lateral[0] = std::exchange(followed.lateral[1], place.y);
    followed.speed[0] = std::exchange(followed.speed[1], speed);
  }
  vehicles_ = std::move(now);
}

void SumoTraffic::advance(double seconds) {
  since_step_ += seconds;
  if (since_step_ > kStep + 1e-9) {
    step();
    since_step_ -= kStep;
  }
  for (auto& [id, vehicle] : vehicles_) {
    const double wish = vehicle.lateral[0] + share() * (vehicle.lateral[1] - vehicle.lateral[0]);
    vehicle.across.advance(wish, seconds);
  }
}

/// Along the road at a constant acceleration between SUMO's steps, which is how SUMO moves.
SceneVehicle SumoTraffic::show(std::int64_t id, const Followed& vehicle) const {
  const bool ego = id == kEgoId;
  const double forward = ego ? -kFrontOverhang : -vehicle.length;
  const double way = since_step_ * (vehicle.speed[0] + share() * (vehicle.speed[1] - vehicle.speed[0]) / 2);
  const double speed = vehicle.speed[0] + share() * (vehicle.speed[1] - vehicle.speed[0]);
  SceneVehicle seen;
  seen.id = id;
  seen.station = vehicle.station[0] + way + forward;
  seen.lateral = vehicle.across.position();
  seen.lane = road_.lane_at(seen.station, seen.lateral).value_or(0);
  const double curvature = road_.reference().curvature(seen.station);
  const double along = std::max(speed * (1 - curvature * seen.lateral), 0.5);
  const double crossing = std::atan2(vehicle.across.speed(), along);
  seen.world_from_vehicle = road_.pose(seen.station, seen.lateral) * Pose2{0, 0, crossing};
  seen.speed = std::hypot(speed * (1 - curvature * seen.lateral), vehicle.across.speed());
  seen.yaw_rate = curvature * speed + vehicle.across.acceleration() / along;
  seen.front = ego ? kFrontOverhang : vehicle.length;
  seen.rear = ego ? vehicle.length - kFrontOverhang : 0;
  seen.width = vehicle.width;
  return seen;
}

Scene SumoTraffic::scene(Time time) const {
  Scene scene;
  scene.time = time;
  scene.road = &road_;
  scene.ego = show(kEgoId, vehicles_.at(kEgoId));
  for (const auto& [id, vehicle] : vehicles_) {
    if (id != kEgoId && std::abs(vehicle.station[1] - scene.ego.station) < kReach)
      scene.vehicles.push_back(show(id, vehicle));
  }
  return scene;
}

}  // namespace

std::unique_ptr<TrafficModel> sumo_traffic(const Road& road, const TrafficConfig& config, double start,
                                           std::uint64_t seed) {
  return std::make_unique<SumoTraffic>(road, config, start, seed);
}

}  // namespace lanefuse

#endif
