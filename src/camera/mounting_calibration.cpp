// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/mounting_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Cholesky>

#include "camera/ground_projection.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kShared = 4;   ///< height, roll, pitch, yaw
constexpr int kPerView = 4;  ///< offset, heading, pitch, lane width
constexpr int kBundles = 8;  ///< of a marking's points: neighbours err together

/// The middle of one marking's paint over some rows.
struct Bundle {
  Eigen::Vector2d direction;
  double side = 1;  ///< 1: left, -1: right
};

void bundle(std::vector<Eigen::Vector2d> points, double side, std::vector<Bundle>& bundles) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
  for (std::size_t i = 0; i < kBundles; ++i) {
    const std::size_t begin = points.size() * i / kBundles;
    const std::size_t end = points.size() * (i + 1) / kBundles;
    if (begin == end) continue;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t k = begin; k < end; ++k) sum += points[k];
    bundles.push_back({sum / static_cast<double>(end - begin), side});
  }
}

double median(std::span<const StraightRoadView> views, double (*of)(const StraightRoadView&)) {
  std::vector<double> values;
  for (const StraightRoadView& view : views) values.push_back(of(view));
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What most views say.
struct Consensus {
  Eigen::Vector2d vanishing;
  double width;  ///< of the lane, in camera heights

  explicit Consensus(std::span<const StraightRoadView> views)
      : vanishing(median(views, [](const StraightRoadView& v) { return v.vanishing.x(); }),
                  median(views, [](const StraightRoadView& v) { return v.vanishing.y(); })),
        width(median(views, width_of)) {}

  [[nodiscard]] bool holds(const StraightRoadView& view, const MountingCalibrationConfig& config) const {
    return (view.vanishing - vanishing).norm() < config.outlier_deg * kDegree &&
           std::abs(width_of(view) / width - 1) < config.outlier_width;
  }

  static double width_of(const StraightRoadView& view) { return view.right_slope - view.left_slope; }
};

/// Least squares over the mounting and, for every view, how the car stood in its lane.
class Problem {
 public:
  Problem(std::vector<const StraightRoadView*> views, const CameraModel& camera, const Mounting& start,
          const MountingCalibrationConfig& config)
      : config_(config), start_(start), pinhole_(without_distortion(camera.intrinsics())) {
    for (const StraightRoadView* view : views) {
      std::vector<Bundle>& bundles = bundles_.emplace_back();
      bundle(view->left, 1, bundles);
      bundle(view->right, -1, bundles);
    }
    const Eigen::Index count = kShared + kPerView * static_cast<Eigen::Index>(views.size());
    state_ = Eigen::VectorXd::Zero(count);
    prior_mean_ = Eigen::VectorXd::Zero(count);
    prior_weight_ = Eigen::VectorXd::Zero(count);
    prior_weight_[1] = weight(config.roll_sigma_deg * kDegree);
    for (Eigen::Index i = kShared; i < count; i += kPerView) {
      prior_mean_[i + 3] = config.lane_width;
      state_[i + 3] = config.lane_width;
      prior_weight_[i] = weight(config.offset_sigma);
      prior_weight_[i + 1] = weight(config.heading_sigma_deg * kDegree);
      prior_weight_[i + 2] = weight(config.pitch_sigma_deg * kDegree);
      prior_weight_[i + 3] = weight(config.lane_width_sigma);
    }
  }

  void start_at(const Eigen::Vector2d& vanishing, double height) {
    state_[0] = height;
    state_[2] = -std::atan(vanishing.y());
    state_[3] = std::atan(vanishing.x());
  }

  void solve() {
    constexpr int kIterations = 12;
    for (int i = 0; i < kIterations; ++i) {
      linearise();
      state_ -= information_.ldlt().solve(gradient_);
      state_[0] = std::max(state_[0], 0.1);
    }
    linearise();
  }

  [[nodiscard]] Mounting mounting() const {
    return {start_.x, start_.y, state_[0], state_[1], state_[2], state_[3]};
  }

  [[nodiscard]] Eigen::Matrix4d covariance() const {
    const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(state_.size(), kShared);
    const Eigen::MatrixXd columns = information_.ldlt().solve(unit);
    const Eigen::Matrix4d covariance = columns.topRows<kShared>();
    return (covariance + covariance.transpose()) / 2;
  }

  [[nodiscard]] double offset(std::size_t view) const { return state_[first_of(view)]; }

  [[nodiscard]] double rms_px(const StraightRoadView& view, std::size_t index) const {
    double sum = 0;
    for (const auto& p : view.left) sum += std::pow(residual_px({p, 1}, index, state_), 2);
    for (const auto& p : view.right) sum += std::pow(residual_px({p, -1}, index, state_), 2);
    return std::sqrt(sum / static_cast<double>(view.left.size() + view.right.size()));
  }

 private:
  MountingCalibrationConfig config_;
  Mounting start_;
  CameraModel pinhole_;
  std::vector<std::vector<Bundle>> bundles_;
  Eigen::VectorXd state_;
  Eigen::VectorXd prior_mean_;
  Eigen::VectorXd prior_weight_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;

  static double weight(double sigma) { return 1 / (sigma * sigma); }
  static Eigen::Index first_of(std::size_t view) {
    return kShared + kPerView * static_cast<Eigen::Index>(view);
  }

  static CameraIntrinsics without_distortion(CameraIntrinsics camera) {
    camera.distortion = {};
    return camera;
  }

  /// How far right of its marking [px] a bundle is seen; 0 where the road is not there at all.
  [[nodiscard]] double residual_px(const Bundle& seen, std::size_t view, const Eigen::VectorXd& x) const {
    const Eigen::Index i = first_of(view);
    CameraPose pose;
    pose.mounting = {start_.x, start_.y, x[0], x[1], x[2] + x[i + 2], x[3]};
    const GroundProjection projection(pinhole_, pose);
    const auto ground = projection.ground_of_direction(seen.direction);
    if (!ground) return 0;
    const double lateral = seen.side * x[i + 3] / 2 - x[i] - x[i + 1] * (ground->x() - start_.x);
    const auto expected = projection.pixel({ground->x(), lateral});
    const CameraIntrinsics& c = pinhole_.intrinsics();
    return expected ? c.cx + c.fx * seen.direction.x() - expected->x() : 0;
  }

  void linearise() {
    information_ = prior_weight_.asDiagonal();
    gradient_ = prior_weight_.cwiseProduct(state_ - prior_mean_);
    for (std::size_t view = 0; view < bundles_.size(); ++view) {
      for (const Bundle& seen : bundles_[view]) add(seen, view);
    }
  }

  void add(const Bundle& seen, std::size_t view) {
    constexpr double kStep = 1e-6;
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(state_.size());
    Eigen::VectorXd moved = state_;
    const auto differ = [&](Eigen::Index i) {
      moved[i] = state_[i] + kStep;
      const double more = residual_px(seen, view, moved);
      moved[i] = state_[i] - kStep;
      slope[i] = (more - residual_px(seen, view, moved)) / (2 * kStep);
      moved[i] = state_[i];
    };
    for (Eigen::Index i = 0; i < kShared; ++i) differ(i);
    for (Eigen::Index i = 0; i < kPerView; ++i) differ(first_of(view) + i);
    const double w = weight(config_.point_sigma_px);
    information_ += w * slope * slope.transpose();
    gradient_ += w * residual_px(seen, view, state_) * slope;
  }
};

}  // namespace

MountingCalibration calibrate_mounting(std::span<const StraightRoadView> views, const CameraModel& camera,
                                       const Mounting& start, const MountingCalibrationConfig& config) {
  if (views.empty()) {
    throw input_error("mounting", "no image shows the two markings of a straight lane",
                      "take images on a straight road with visible paint");
  }
  const Consensus consensus(views);
  MountingCalibration result;
  std::vector<const StraightRoadView*> used;
  for (const StraightRoadView& view : views) {
    const bool is_used = consensus.holds(view, config);
    result.views.push_back({is_used, 0, 0});
    if (is_used) used.push_back(&view);
  }
  if (used.size() < std::min<std::size_t>(views.size(), 2)) {
    throw input_error("mounting", "no two images agree on where the road runs and how wide the lane is",
                      "take images on a straight road, in the middle of a lane");
  }
  Problem problem(used, camera, start, config);
  problem.start_at(consensus.vanishing, config.lane_width / consensus.width);
  problem.solve();
  result.mounting = problem.mounting();
  result.covariance = problem.covariance();
  result.views_used = static_cast<int>(used.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!result.views[i].used) continue;
    result.views[i].rms_px = problem.rms_px(views[i], next);
    result.views[i].offset = problem.offset(next);
    ++next;
  }
  return result;
}

}  // namespace lanefuse
