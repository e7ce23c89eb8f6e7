#include "map_matcher/search/refinement/pose_refiner.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

namespace map_matcher::search {
namespace {

constexpr int kMaxSteps = 30;
constexpr double kSmallStep = 1e-3;         // [cells], at which the steps end
constexpr double kFirstSmallStep = 1e-2;    // [cells], at which those of a sample end
constexpr std::size_t kFewCells = 4000;     // that the first steps look at, at least
constexpr std::size_t kManyCells = 12000;   // that the last ones look at, at least: neighbours say the same
constexpr double kCorrelationLength = 1.0;  // of the cells' errors, along a wall [m]
/// Curvature for each cell, as a share of that across a wall, below which a direction is not told by the walls but by
/// the steps that they are drawn in.
constexpr double kLeastCurvature = 0.05;
constexpr double kFarthestOfTolerance = 4.0;  // distance from which a cell has no effect at all [tolerances]

/// The sums of a Gauss-Newton step, in cells and radians.
struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double squares = 0.0;  // weighted, of the distances
  double weights = 0.0;
};

double scaleOf(double tolerance, double resolution) { return std::max(tolerance / resolution, 1.0); }

/// Makes use of the steps before: where walls are blurred, each step of Gauss and Newton leaves two thirds of the way
/// to go, since it takes the weights for constant (Anderson's acceleration; Walker and Ni 2011).
class Acceleration {
 public:
  /// The step to take from `position` where that of Gauss and Newton is `step`, both in cells.
  Eigen::Vector3d accelerated(const Eigen::Vector3d& position, const Eigen::Vector3d& step) {
    Eigen::Vector3d result = step;
    if (has_last_) {
      const Eigen::Index column = num_known_++ % kMemory;
      moves_.col(column) = position - last_position_;
      changes_.col(column) = step - last_step_;
    }
    const Eigen::Index size = std::min<Eigen::Index>(num_known_, kMemory);
    if (size > 0) {
      Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3Xd> solver;
      solver.setThreshold(kIndependent);
      solver.compute(changes_.leftCols(size));
      result -= (moves_ + changes_).leftCols(size) * solver.solve(step);
    }
    has_last_ = true;
    last_position_ = position;
    last_step_ = step;
    const double longest = kLongest * step.norm();
    return result.norm() > longest ? Eigen::Vector3d(result * (longest / result.norm())) : result;
  }

  /// Takes the next step for the first one of a problem much like the last one.
  void beginAnew() { has_last_ = false; }

 private:
  static constexpr Eigen::Index kMemory = 3;    // as many as there are directions
  static constexpr double kIndependent = 1e-2;  // of the steps' changes, below which one says nothing new
  static constexpr double kLongest = 5.0;       // [steps of Gauss and Newton]
  bool has_last_ = false;                       // a step to compare the next one with
  Eigen::Index num_known_ = 0;
  Eigen::Matrix3d moves_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d changes_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d last_position_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d last_step_ = Eigen::Vector3d::Zero();
};

class Refinement {
 public:
  Refinement(const DistanceField& walls, const SessionCells& session, const CentrePose& pose, double tolerance)
      : field_(walls), session_(session), start_(pose), scale_(scaleOf(tolerance, session.resolution)) {}

  RefinedPose run() const {
    RefinedPose result;
    const Eigen::Vector2d start = start_.position / session_.resolution;
    const double arm = std::max(1.0, 0.5 * session_.diagonal);  // so that a turn is an arc [cells]
    Eigen::Vector3d moved(0.0, 0.0, 0.0);
    Acceleration acceleration;
    std::size_t every = everyFor(kFewCells);
    const std::size_t last_every = everyFor(kManyCells);
    for (int step = 0; step < kMaxSteps && !result.converged; ++step) {
      const Eigen::Vector3d plain = Eigen::Vector3d(1.0, 1.0, arm).asDiagonal() *
                                    stepFrom(sumsAt(start + moved.head<2>(), start_.angle + moved.z() / arm, every));
      moved += acceleration.accelerated(moved, plain);
      const double size = plain.head<2>().norm() + std::abs(plain.z());
      result.converged = every == last_every && size < kSmallStep;
      if (every > last_every && size < kFirstSmallStep) {
        every = last_every;
        acceleration.beginAnew();
      }
      if (!(moved.head<2>().norm() <= 3.0 * scale_)) {
        break;
      }
    }
    result.pose = result.converged
                      ? CentrePose{start_.angle + moved.z() / arm, (start + moved.head<2>()) * session_.resolution}
                      : start_;
    result.covariance = covarianceAt(result.pose.position / session_.resolution, result.pose.angle);
    return result;
  }

 private:
  /// The largest step through the cells that takes `num_cells` of them or more.
  std::size_t everyFor(std::size_t num_cells) const {
    return std::max<std::size_t>(1, session_.points.size() / num_cells);
  }

  /// Of every `every`-th cell.
  NormalEquations sumsAt(const Eigen::Vector2d& position, double angle, std::size_t every = 1) const {
    NormalEquations sums;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    for (std::size_t k = 0; k < session_.points.size(); k += every) {
      const Eigen::Vector2d& p = session_.points[k];
      const Eigen::Vector2d arm(c * p.x() - s * p.y(), s * p.x() + c * p.y());
      const DistanceField::Sample sample = field_.at(position + arm);
      const double square = sample.gradient.squaredNorm();
      const double root = scale_ * scale_ / (scale_ * scale_ + square);
      const double weight = root * root;  // Geman and McClure's
      Eigen::Matrix<double, 2, 3> jacobian;
      jacobian << 1.0, 0.0, -arm.y(), 0.0, 1.0, arm.x();
      sums.information += weight * jacobian.transpose() * sample.curvature * jacobian;
      sums.gradient += weight * jacobian.transpose() * sample.gradient;
      const double share = std::min(1.0, sample.curvature.trace());  // of a cell that has a wall near it
      sums.squares += weight * std::max(0.0, share) * square;
      sums.weights += weight * std::max(0.0, share);
    }
    return sums;
  }

  /// Variance of a cell's distance from its wall [cells^2], not below that of two maps in whole cells.
  static double varianceOf(const NormalEquations& sums) {
    return sums.squares / std::max(1.0, sums.weights) + 2.0 / 12.0;
  }

  double correlatedCells() const { return std::max(1.0, kCorrelationLength / session_.resolution); }

  /// Directions of (x, y, angle) that the walls determine, as columns, and their information.
  struct Directions {
    Eigen::Matrix3d directions;    // orthonormal once angles are arcs of the mean cell
    Eigen::Vector3d informations;  // 0 for those that are not determined
    double arm;                    // of the mean cell [cells]
  };

  Directions directionsOf(const NormalEquations& sums) const {
    double squared_arms = 0.0;
    for (const Eigen::Vector2d& p : session_.points) {
      squared_arms += p.squaredNorm();
    }
    const double arm = std::max(1.0, std::sqrt(squared_arms / static_cast<double>(session_.points.size())));
    const Eigen::Vector3d units(1.0, 1.0, 1.0 / arm);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(units.asDiagonal() * sums.information *
                                                                units.asDiagonal());
    const double least = kLeastCurvature * sums.weights;
    Directions result{solver.eigenvectors(), solver.eigenvalues(), arm};
    result.informations = (result.informations.array() > least).select(result.informations, 0.0);
    return result;
  }

  /// The Gauss-Newton step in the directions that the walls determine; no step in the others (Zhang, Kaess, Singh 2016,
  /// solution remapping).
  Eigen::Vector3d stepFrom(const NormalEquations& sums) const {
    const Directions known = directionsOf(sums);
    const Eigen::Vector3d units(1.0, 1.0, 1.0 / known.arm);
    Eigen::Vector3d along = -known.directions.transpose() * units.asDiagonal() * sums.gradient;
    for (int k = 0; k < 3; ++k) {
      along[k] = known.informations[k] > 0.0 ? along[k] / known.informations[k] : 0.0;
    }
    return units.asDiagonal() * known.directions * along;
  }

  Eigen::Matrix3d covarianceAt(const Eigen::Vector2d& position, double angle) const {
    const std::size_t every = everyFor(kManyCells);
    const NormalEquations sums = sumsAt(position, angle, every);
    const Directions known = directionsOf(sums);
    const double noise = varianceOf(sums) * correlatedCells();
    const double prior = kPriorDeviation / session_.resolution;
    const Eigen::Vector3d variances =
        (known.informations.array() * static_cast<double>(every) / noise + 1.0 / (prior * prior)).inverse();
    const Eigen::Vector3d units(session_.resolution, session_.resolution, 1.0 / known.arm);
    return units.asDiagonal() * known.directions * variances.asDiagonal() * known.directions.transpose() *
           units.asDiagonal();
  }

  const DistanceField& field_;
  const SessionCells& session_;
  CentrePose start_;
  double scale_;  // of the weights [cells]
};

}  // namespace

double farthestThatMatters(double tolerance, double resolution) {
  return kFarthestOfTolerance * scaleOf(tolerance, resolution);
}

RefinedPose refine(const DistanceField& walls, const SessionCells& session, const CentrePose& pose, double tolerance) {
  return Refinement(walls, session, pose, tolerance).run();
}

}  // namespace map_matcher::search
