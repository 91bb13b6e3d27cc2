// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/image_faces.hpp"
#include "simulation/road_ahead.hpp"
#include "simulation/scene.hpp"

namespace lanefuse {

/// The box around a vehicle of the scene, which does not say how high it is: cars 1.4-1.6 m, vans 2 m, trucks
/// 3.6-4 m.
struct VehicleBody {
  bool truck = false;
  double length = 0;  ///< [m] from the reference point, its rear, ahead
  double width = 0;   ///< [m]
  double height = 0;  ///< [m]
};
VehicleBody body_of(const SceneVehicle& vehicle);

/// Where a vehicle stands in the vehicle frame of the scene's ego car.
struct VehiclePlace {
  Pose2 ego_from_vehicle;
  double ground = 0;  ///< [m] height of the road under its rear, over the plane under the ego car
};
VehiclePlace place_of_vehicle(const SceneVehicle& vehicle, const Scene& scene);

/// A vehicle as boxes: body, windows, lights, tyres.
void add_vehicle(const SceneVehicle& vehicle, const Scene& scene, ImageFaces& faces);

/// Its image in a wet road.
void add_mirrored_vehicle(const SceneVehicle& vehicle, const Scene& scene, ImageFaces& faces);

/// What it does to the light on the road: the sun's shadow and the dark under it.
void add_vehicle_shadow(const SceneVehicle& vehicle, const Scene& scene, ImageFaces& faces);

}  // namespace lanefuse
