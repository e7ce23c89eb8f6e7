#include "map_matcher/mapping/scan_matching.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "map_matcher/mapping/nearby_walls.hpp"

namespace map_matcher::mapping {
namespace {

constexpr double kPointSpacing = 0.05;  // [m] of the beams' ends that are compared
constexpr double kIndependent = 0.3;    // share of these that err independently of each other
constexpr double kSpurious = 0.02;      // of a wall's information that seems to be along it, since its normal errs
constexpr double kNarrowing = 0.7;      // of the weights, at each step
constexpr double kWidest = 0.6;         // [m] of the weights
constexpr double kReach = 2.0;          // of a wall, in widths of the weights
constexpr int kMostSteps = 25;
constexpr double kSmallStep = 1e-4;     // [m], at which the steps end
constexpr double kPieceAngle = 0.025;   // [rad] of half a piece of wall, as seen from the laser
constexpr double kShortestPiece = 0.2;  // [m] to either side
constexpr double kLongestPiece = 0.4;   // [m]
constexpr double kMargin = 1.0;         // [m] around the ends, where walls are looked for

/// An end of a beam, and what it was last compared with.
struct Point {
  Eigen::Vector2d in_base{0.0, 0.0};
  double range = 0.0;
  int wall_point = -1;
  std::optional<WallPiece> piece;
};

/// Sums over the points.
struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double weights = 0.0;
};

/// At most one end for each square of kPointSpacing: near walls have many.
std::vector<Point> thinnedHits(const BeamFan& fan) {
  std::set<std::pair<int, int>> taken;
  std::vector<Point> points;
  for (const Beam& beam : fan.beams) {
    const grid::Cell square = grid::cellOf(beam.end, kPointSpacing);
    if (beam.hit && taken.emplace(square.x, square.y).second) {
      points.push_back({beam.end, (beam.end - fan.origin).norm(), -1, std::nullopt});
    }
  }
  return points;
}

Extent extentOf(const std::vector<Point>& points, const grid::Rigid2& pose) {
  Extent extent{pose.translation(), pose.translation()};
  for (const Point& point : points) {
    const Eigen::Vector2d end = pose * point.in_base;
    extent.min = extent.min.cwiseMin(end);
    extent.max = extent.max.cwiseMax(end);
  }
  return {extent.min.array() - kMargin, extent.max.array() + kMargin};
}

class ScanMatching {
 public:
  ScanMatching(const HitCountingGrid& grid, const BeamFan& fan, const PoseEstimate& predicted,
               const ScanMatchOptions& options)
      : grid_(grid),
        options_(options),
        predicted_(predicted),
        points_(thinnedHits(fan)),
        walls_(grid, options.occ_thresh, extentOf(points_, predicted.T_session_base)) {
    double squares = 0.0;
    for (const Point& point : points_) {
      squares += point.in_base.squaredNorm();
    }
    arm_ = std::max(0.1, std::sqrt(squares / std::max<double>(1.0, static_cast<double>(points_.size()))));
  }

  ScanMatch run() {
    constexpr double kLeastVariance = 1e-8;
    const Eigen::Matrix3d prior = (predicted_.covariance + kLeastVariance * Eigen::Matrix3d::Identity()).inverse();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    Eigen::Matrix3d information = prior;
    double widening = kWidest / narrowest();
    for (int step = 0; step < kMostSteps; ++step) {
      const NormalEquations sums = believable(sumsAt(offset, widening));
      information = prior + sums.information;
      const Eigen::Vector3d change = -information.ldlt().solve(sums.gradient + prior * offset);
      offset += change;
      if (widening <= 1.0 && change.head<2>().norm() + arm_ * std::abs(change.z()) < kSmallStep) {
        break;
      }
      widening = std::max(1.0, kNarrowing * widening);
    }
    ScanMatch match;
    match.estimate.T_session_base = poseAt(offset);
    match.estimate.covariance = information.inverse();
    judge(match);
    return match;
  }

 private:
  double narrowest() const { return 2.0 * options_.sigma; }

  grid::Rigid2 poseAt(const Eigen::Vector3d& offset) const {
    const grid::Rigid2& pose = predicted_.T_session_base;
    return {pose.x + offset.x(), pose.y + offset.y(), grid::normalizeAngle(pose.yaw + offset.z())};
  }

  /// Width of the weights for a point [m]: at first, as far as the prediction may be wrong there.
  double widthFor(const Point& point, double widening) const {
    const double doubt = 2.0 * (std::sqrt(predicted_.covariance.topLeftCorner<2, 2>().trace()) +
                                std::sqrt(predicted_.covariance(2, 2)) * point.range);
    return std::max(narrowest(), std::min({kWidest, doubt, narrowest() * widening}));
  }

  NormalEquations sumsAt(const Eigen::Vector3d& offset, double widening) {
    NormalEquations sums;
    const grid::Rigid2 pose = poseAt(offset);
    const Eigen::Matrix2d rotation = pose.rotation();
    for (Point& point : points_) {
      const Eigen::Vector2d arm = rotation * point.in_base;
      const Eigen::Vector2d end = pose.translation() + arm;
      const double width = widthFor(point, widening);
      findPiece(point, end, kReach * width);
      if (!point.piece) {
        continue;
      }
      const double distance = point.piece->normal.dot(end - point.piece->middle);
      const double root = width * width / (width * width + distance * distance);
      const double weight = kIndependent * root * root / (options_.sigma * options_.sigma + point.piece->variance);
      const Eigen::Vector3d jacobian(point.piece->normal.x(), point.piece->normal.y(),
                                     point.piece->normal.dot(Eigen::Vector2d(-arm.y(), arm.x())));
      sums.information += weight * jacobian * jacobian.transpose();
      sums.gradient += weight * distance * jacobian;
      sums.weights += weight;
    }
    return sums;
  }

  void findPiece(Point& point, const Eigen::Vector2d& end, double reach) {
    const std::optional<int> nearest = walls_.nearest(end, reach);
    if (!nearest) {
      point.wall_point = -1;
      point.piece.reset();
    } else if (*nearest != point.wall_point) {
      point.wall_point = *nearest;
      point.piece = walls_.pieceAround(*nearest, std::clamp(kPieceAngle * point.range, kShortestPiece, kLongestPiece));
    }
  }

  /// Without what the errors of the walls' directions feign to know.
  NormalEquations believable(const NormalEquations& sums) const {
    const Eigen::Vector3d units(1.0, 1.0, 1.0 / arm_);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(units.asDiagonal() * sums.information *
                                                                units.asDiagonal());
    Eigen::Vector3d shares;
    for (int k = 0; k < 3; ++k) {
      const double value = solver.eigenvalues()[k];
      shares[k] = value > 0.0 ? std::max(0.0, value - kSpurious * sums.weights) / value : 0.0;
    }
    const Eigen::Matrix3d& directions = solver.eigenvectors();
    const Eigen::Vector3d back = units.cwiseInverse();
    NormalEquations result = sums;
    result.information = back.asDiagonal() * directions * shares.cwiseProduct(solver.eigenvalues()).asDiagonal() *
                         directions.transpose() * back.asDiagonal();
    result.gradient = back.asDiagonal() * directions * shares.asDiagonal() * directions.transpose() *
                      units.asDiagonal() * sums.gradient;
    return result;
  }

  void judge(ScanMatch& match) {
    int at_walls = 0;
    const double width = narrowest();
    const double most = kIndependent * 0.5 * width * width / (options_.sigma * options_.sigma);
    for (Point& point : points_) {
      const Eigen::Vector2d end = match.estimate.T_session_base * point.in_base;
      const bool at_wall = walls_.nearest(end, 1.5 * width).has_value();
      at_walls += at_wall ? 1 : 0;
      findPiece(point, end, kReach * width);
      const double distance = point.piece             ? point.piece->normal.dot(end - point.piece->middle)
                              : point.wall_point >= 0 ? (end - walls_.at(point.wall_point).position).norm()
                                                      : kWidest;
      match.misfit += most * distance * distance / (width * width + distance * distance);
      match.points += at_wall || grid_.isKnown(end) ? 1 : 0;
    }
    match.all_fit = points_.empty() ? 0.0 : static_cast<double>(at_walls) / static_cast<double>(points_.size());
    match.fit = match.points > 0 ? static_cast<double>(at_walls) / match.points : 0.0;
  }

  const HitCountingGrid& grid_;
  ScanMatchOptions options_;
  PoseEstimate predicted_;
  std::vector<Point> points_;
  NearbyWalls walls_;
  double arm_;
};

}  // namespace

ScanMatch matchScan(const HitCountingGrid& grid, const BeamFan& fan, const PoseEstimate& predicted,
                    const ScanMatchOptions& options) {
  return ScanMatching(grid, fan, predicted, options).run();
}

}  // namespace map_matcher::mapping
