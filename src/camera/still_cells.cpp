// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/still_cells.hpp"

#include "camera/ground_projection.hpp"

namespace lanefuse {
namespace {

constexpr double kTellsMotion = 0.25;    ///< forward_share() of a cell that can be judged
constexpr float kFits = 0.6F;            ///< correlation
constexpr double kStandingShare = 0.85;  ///< of the texture

}  // namespace

double forward_share(const CellMatch& match, const RoadPlaneWarp::Jacobian& jacobian) {
  const Eigen::Vector2d flow = jacobian.col(PlaneMotion::kForward);
  const double length = flow.squaredNorm();
  const Eigen::Matrix2d curvature = match.curvature.cast<double>();
  if (!(length > 0)) return 0;
  return flow.dot(curvature * flow) / (length * curvature.trace() + 1e-9);
}

double forward_fit(const std::vector<CellMatch>& matches,
                   const std::vector<RoadPlaneWarp::Jacobian>& jacobians) {
  double fits = 0;
  double all = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!matches[i].has_texture()) continue;
    const double share = forward_share(matches[i], jacobians[i]);
    const double weight = share * share * static_cast<double>(matches[i].energy);
    fits += weight * static_cast<double>(matches[i].correlation);
    all += weight;
  }
  return all > 0 ? fits / all : 0;
}

void StillCells::judge(const RoadPair& pair, const CameraPose& pose,
                       const std::vector<RoadPlaneWarp::Jacobian>& jacobians) {
  const std::vector<CellMatch> unmoved = match_cells(pair, pair.warp.map(pose, {}));
  double energy = 0;
  double still_energy = 0;
  for (std::size_t i = 0; i < unmoved.size(); ++i) {
    const bool telling = unmoved[i].has_texture() && forward_share(unmoved[i], jacobians[i]) > kTellsMotion;
    const bool still = telling && unmoved[i].correlation > kFits;
    stillness_[i] = still ? 1.0F : (1 - kMemory) * stillness_[i];
    if (telling) energy += static_cast<double>(unmoved[i].energy);
    if (still) still_energy += static_cast<double>(unmoved[i].energy);
  }
  car_stands_ = energy > 0 && still_energy > kStandingShare * energy;
}

}  // namespace lanefuse
