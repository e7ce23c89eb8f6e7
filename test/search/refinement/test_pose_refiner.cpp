#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <set>
#include <utility>

#include "map_matcher/search/refinement/pose_refiner.hpp"
#include "support/random_maps.hpp"

namespace map_matcher::search {
namespace {

constexpr double kResolution = 0.05;
constexpr double kSize = 16.0;  // of the reference map [m]

struct Segment {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

/// Points every centimetre of the segments.
std::vector<Eigen::Vector2d> pointsOn(const std::vector<Segment>& segments) {
  std::vector<Eigen::Vector2d> points;
  for (const Segment& segment : segments) {
    const double length = (segment.to - segment.from).norm();
    for (double s = 0.0; s < length; s += 0.01) {
      points.push_back(segment.from + (segment.to - segment.from) * (s / length));
    }
  }
  return points;
}

/// Rooms of a building that stands at an angle in the map.
std::vector<Segment> rooms(std::mt19937& random, double angle) {
  const grid::Rigid2 turned{8.0, 8.0, angle};
  std::vector<Segment> segments;
  for (int k = 0; k < 14; ++k) {
    const Eigen::Vector2d from(test::randomReal(random, -5.0, 3.0), test::randomReal(random, -5.0, 3.0));
    const double length = test::randomReal(random, 0.5, 4.0);
    const Eigen::Vector2d along = k % 2 == 0 ? Eigen::Vector2d(length, 0.0) : Eigen::Vector2d(0.0, length);
    segments.push_back({turned * from, turned * Eigen::Vector2d(from + along)});
  }
  return segments;
}

std::vector<grid::Cell> draw(const std::vector<Eigen::Vector2d>& points) {
  std::set<std::pair<int, int>> cells;
  for (const Eigen::Vector2d& p : points) {
    cells.emplace(static_cast<int>(std::floor(p.y() / kResolution)), static_cast<int>(std::floor(p.x() / kResolution)));
  }
  std::vector<grid::Cell> result;
  for (const auto& [y, x] : cells) {
    result.push_back({x, y});
  }
  return result;
}

double gaussian(std::mt19937& random) {
  const double u = test::randomReal(random, 1e-12, 1.0);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * M_PI * test::randomReal(random, 0.0, 1.0));
}

/// What a refinement looks at of a reference map with these walls.
DistanceField fieldOf(const std::vector<Segment>& segments) {
  const int size = static_cast<int>(kSize / kResolution);
  return {size, size, draw(pointsOn(segments)), farthestThatMatters(0.05, kResolution)};
}

/// A reference map, a noisy session map of it, and the session's true place.
struct Drive {
  Drive(std::mt19937& random, const std::vector<Segment>& segments, double sigma) : reference(fieldOf(segments)) {
    const grid::Rigid2 T_grids{test::randomReal(random, -3.0, 3.0), test::randomReal(random, -3.0, 3.0),
                               test::randomReal(random, -3.0, 3.0)};
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector2d& p : pointsOn(segments)) {
      const Eigen::Vector2d noise(sigma * gaussian(random), sigma * gaussian(random));
      points.push_back(T_grids.inverse() * Eigen::Vector2d(p + noise));
    }
    session = prepareSessionCells(draw(points), kResolution, kResolution, CellMerging::kNone, 0);
    truth = {T_grids.yaw, T_grids * session.centre};
  }

  /// A pose some centimetres beside the true one, as a search gives it.
  CentrePose searched(std::mt19937& random) const {
    return {
        truth.angle + test::randomReal(random, -0.005, 0.005),
        truth.position + Eigen::Vector2d(test::randomReal(random, -0.06, 0.06), test::randomReal(random, -0.06, 0.06))};
  }

  Eigen::Vector3d error(const CentrePose& pose) const {
    const Eigen::Vector2d offset = pose.position - truth.position;
    return {offset.x(), offset.y(), grid::normalizeAngle(pose.angle - truth.angle)};
  }

  DistanceField reference;
  SessionCells session;
  CentrePose truth;
};

/// Root mean square error of the position [m] and mean normalised square of the error.
struct Consistency {
  double error = 0.0;
  double normalised_square = 0.0;  // three degrees of freedom: 3 is consistent, more is overconfident
};

Consistency consistencyOf(std::mt19937& random, bool turned) {
  constexpr int kDrives = 200;
  Consistency sums;
  for (int drive = 0; drive < kDrives; ++drive) {
    SCOPED_TRACE("drive " + std::to_string(drive));
    const Drive scene(random, rooms(random, turned ? test::randomReal(random, 0.0, 3.0) : 0.0), 0.02);
    const RefinedPose refined = refine(scene.reference, scene.session, scene.searched(random), 0.05);
    EXPECT_TRUE(refined.converged);
    const Eigen::Vector3d error = scene.error(refined.pose);
    sums.error += error.head<2>().squaredNorm();
    sums.normalised_square += error.dot(refined.covariance.inverse() * error);
  }
  return {std::sqrt(sums.error / kDrives), sums.normalised_square / kDrives};
}

TEST(PoseRefiner, IsFinerThanTheGridAndKnowsHowFine) {
  std::mt19937 random(1);

  const Consistency consistency = consistencyOf(random, false);

  EXPECT_LT(consistency.error, 0.2 * kResolution);
  EXPECT_GT(consistency.normalised_square, 1.0);
  EXPECT_LT(consistency.normalised_square, 4.0);
}

TEST(PoseRefiner, IsFinerStillAndNotOverconfidentWhereWallsStandAtAnAngleToTheGrid) {
  std::mt19937 random(2);

  const Consistency consistency = consistencyOf(random, true);

  EXPECT_LT(consistency.error, 0.05 * kResolution);
  EXPECT_LT(consistency.normalised_square, 4.0);
}

TEST(PoseRefiner, IsSureAcrossACorridorButNotAlongIt) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 20; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const double heading = test::randomReal(random, 0.0, 3.0);
    const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector2d middle(8.0, 8.0);
    Drive scene(random,
                {{middle + across - 3.0 * along, middle + across + 3.0 * along},
                 {middle - across - 3.0 * along, middle - across + 3.0 * along}},
                0.02);
    const std::vector<Segment> corridor{{middle + across - 6.0 * along, middle + across + 6.0 * along},
                                        {middle - across - 6.0 * along, middle - across + 6.0 * along}};
    scene.reference = fieldOf(corridor);

    const RefinedPose refined = refine(scene.reference, scene.session, scene.searched(random), 0.05);

    const Eigen::Matrix2d covariance = refined.covariance.topLeftCorner<2, 2>();
    EXPECT_TRUE(refined.converged);
    EXPECT_GT(std::sqrt(along.dot(covariance * along)), 0.9 * kPriorDeviation);
    EXPECT_LT(std::sqrt(across.dot(covariance * across)), 0.02);
    EXPECT_LT(std::abs(across.dot(scene.error(refined.pose).head<2>())), 0.005);
  }
}

TEST(PoseRefiner, LeavesAPoseFarFromAllWallsAsItIs) {
  std::mt19937 random(3);
  const Drive scene(random, rooms(random, 0.5), 0.02);
  const CentrePose far{0.3, {-500.0, 20.0}};

  const RefinedPose refined = refine(scene.reference, scene.session, far, 0.05);

  EXPECT_LT((refined.pose.position - far.position).norm(), 1e-6);
  EXPECT_NEAR(std::sqrt(refined.covariance(0, 0)), kPriorDeviation, 0.01);
}

TEST(PoseRefiner, TakesASingleCell) {
  std::mt19937 random(4);
  const DistanceField reference(10, 10, {{5, 5}}, farthestThatMatters(0.0, kResolution));
  const SessionCells session = prepareSessionCells({{0, 0}}, kResolution, kResolution, CellMerging::kNone, 0);

  const RefinedPose refined = refine(reference, session, {0.1, {0.28, 0.28}}, 0.0);

  EXPECT_TRUE(refined.covariance.allFinite());
  EXPECT_NEAR(refined.pose.position.x(), 0.275, 0.01);
}

}  // namespace
}  // namespace map_matcher::search
