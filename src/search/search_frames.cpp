#include "map_matcher/search/search_frames.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::search {
namespace {

/// The part of a box that lies where maps may lie: the sums of numbers that are too large are none.
WindowPrior bounded(const WindowPrior& box) {
  constexpr double kFarthest = 1e12;  // [m]
  if ((box.centre.cwiseAbs() + box.half_size).maxCoeff() <= kFarthest) {
    return box;
  }
  const auto within = [&](const Eigen::Vector2d& corner) -> Eigen::Vector2d {
    return corner.cwiseMax(-kFarthest).cwiseMin(kFarthest);
  };
  const Eigen::Vector2d low = within(box.centre - box.half_size);
  const Eigen::Vector2d high = within(box.centre + box.half_size);
  return {0.5 * (low + high), 0.5 * (high - low)};
}

}  // namespace

grid::Rigid2 SearchFrames::mapPose(const CentrePose& pose, const Eigen::Vector2d& centre) const {
  const Eigen::Vector2d t = pose.position - grid::Rigid2{0.0, 0.0, pose.angle} * centre;
  return T_reference_grid_ * grid::Rigid2{t.x(), t.y(), pose.angle} * T_session_grid_.inverse();
}

Eigen::Matrix3d SearchFrames::mapCovariance(const Eigen::Matrix3d& covariance, double angle,
                                            const Eigen::Vector2d& centre) const {
  // The origin of the session map frame lies `arm` from the centre; turning about the centre moves it along.
  const Eigen::Vector2d arm = grid::Rigid2{0.0, 0.0, T_reference_grid_.yaw + angle} *
                              Eigen::Vector2d(T_session_grid_.inverse().translation() - centre);
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian.topLeftCorner<2, 2>() = T_reference_grid_.rotation();
  jacobian(0, 2) = -arm.y();
  jacobian(1, 2) = arm.x();
  return jacobian * covariance * jacobian.transpose();
}

CentrePose SearchFrames::centrePose(const grid::Rigid2& T_reference_session, const Eigen::Vector2d& centre) const {
  const grid::Rigid2 T_grids = T_reference_grid_.inverse() * T_reference_session * T_session_grid_;
  return {T_grids.yaw, T_grids * centre};
}

double SearchFrames::headingError(const HeadingPrior& prior, double angle) const {
  return std::abs(grid::normalizeAngle(angle - angleAt(prior.yaw)));
}

SearchWindow SearchFrames::window(const std::optional<WindowPrior>& prior, const Eigen::Vector2d& centre,
                                  double resolution, double angle) const {
  if (!prior) {
    return everywhere();
  }
  const grid::Rigid2 T_grid_reference = T_reference_grid_.inverse();
  const WindowPrior box = bounded(*prior);
  const Eigen::Vector2d box_centre = T_grid_reference * box.centre;
  const Eigen::Vector2d half_size = T_grid_reference.rotation().cwiseAbs() * box.half_size;
  const Eigen::Vector2d origin_in_grid = T_session_grid_.inverse().translation();
  const Eigen::Vector2d origin_from_centre = grid::Rigid2{0.0, 0.0, angle} * Eigen::Vector2d(origin_in_grid - centre);
  const Eigen::Vector2d middle = (box_centre - origin_from_centre) / resolution;
  const Eigen::Vector2d reach = half_size / resolution;
  const Eigen::Vector2d first = (middle - reach).array().floor();
  const Eigen::Vector2d last = (middle + reach).array().ceil();
  const auto clamped = [](double value) {
    return static_cast<int>(std::clamp<double>(value, everywhere().first.x, everywhere().last.x));
  };
  return {{clamped(first.x()), clamped(first.y())}, {clamped(last.x()), clamped(last.y())}};
}

}  // namespace map_matcher::search
