#include "map_matcher/simulation/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace map_matcher::simulation {
namespace {

constexpr double kLookahead = 0.6;        // [m] to the points that are pursued in a straight line, at most
constexpr double kDetourLookahead = 1.5;  // [m] to the points that are made for among people, at most
constexpr double kReach = 0.1;            // [m] the end of the path counts as reached from here
constexpr double kTurnInPlace = 0.6;      // [rad] with a larger heading error the robot turns where it stands
constexpr double kBraking = 0.7;          // share of the acceleration that braking is planned with
constexpr double kCreepSpeed = 0.05;      // [m/s] where there is no room to brake from more
constexpr double kCreepWay = 0.02;        // [m] that must be clear to creep
constexpr double kCreepMargin = 0.002;    // [m] beyond the robot's radius
constexpr double kLineMargin = 0.04;      // [m] that such a line keeps beyond the robot's radius
constexpr double kOnPath = 0.02;          // [m] nearer to the path is on it
constexpr double kClearanceStep = 0.04;   // [m] between the points at which a line is tested

}  // namespace

PathFollower::PathFollower(const World& world, Path path) : world_(world), path_(std::move(path)) {}

Velocity PathFollower::command(const DifferentialDrive& robot, double period, const std::vector<Mover>& others) {
  const RobotOptions& limits = robot.options();
  const grid::Rigid2& pose = robot.T_map_base();
  advance(pose.translation());
  const double to_end = (path_.back() - pose.translation()).norm();
  arrived_ = to_end < kReach;
  if (arrived_) {
    return {};
  }
  const Eigen::Vector2d target =
      pose.inverse() * (others.empty() ? pointToPursue(robot, kLookahead) : detour(robot, others));
  const double error = std::atan2(target.y(), target.x());
  const double braking_turn = std::sqrt(2.0 * kBraking * limits.max_turn_acceleration * std::abs(error));
  if (std::abs(error) > kTurnInPlace) {
    return {0.0, std::copysign(std::min(limits.max_turn_rate, braking_turn), error)};
  }
  const double curvature = 2.0 * target.y() / target.squaredNorm();
  double speed = std::min(limits.max_speed, safeSpeed(robot, period));
  speed = std::min(speed, std::sqrt(2.0 * kBraking * limits.max_acceleration * to_end));
  speed = std::min(speed, limits.max_turn_rate / std::max(std::abs(curvature), 1e-9));
  return {speed, speed * curvature};
}

/// Moves on to the path's point nearest to the robot, never back and never farther than the lookahead.
void PathFollower::advance(const Eigen::Vector2d& position) {
  double travelled = 0.0;
  std::size_t best = nearest_;
  for (std::size_t i = nearest_; i < path_.size() && travelled <= kLookahead; ++i) {
    if ((path_[i] - position).squaredNorm() <= (path_[best] - position).squaredNorm()) {
      best = i;
    }
    travelled += i + 1 < path_.size() ? (path_[i + 1] - path_[i]).norm() : 0.0;
  }
  nearest_ = best;
}

/// The farthest point within the lookahead that can be driven to in a straight line. When there is none the robot has
/// drifted off between obstacles and goes back to the path.
Eigen::Vector2d PathFollower::pointToPursue(const DifferentialDrive& robot, double lookahead) const {
  const Eigen::Vector2d position = robot.T_map_base().translation();
  std::optional<Eigen::Vector2d> farthest;
  for (std::size_t i = nearest_ + 1; i < path_.size() && (path_[i] - position).norm() <= lookahead; ++i) {
    if (isClear(position, path_[i], robot.options().radius + kLineMargin)) {
      farthest = path_[i];
    }
  }
  const bool is_on_path = (path_[nearest_] - position).norm() < kOnPath;
  return farthest ? *farthest : path_[is_on_path ? std::min(nearest_ + 1, path_.size() - 1) : nearest_];
}

/// A point in the direction in which the robot gets past others.
Eigen::Vector2d PathFollower::detour(const DifferentialDrive& robot, const std::vector<Mover>& others) const {
  const RobotOptions& limits = robot.options();
  const grid::Rigid2& pose = robot.T_map_base();
  const Eigen::Vector2d position = pose.translation();
  const Eigen::Vector2d target = pointToPursue(robot, kDetourLookahead);
  const Eigen::Vector2d velocity = robot.velocity().linear * Eigen::Vector2d(std::cos(pose.yaw), std::sin(pose.yaw));
  const Eigen::Vector2d wanted =
      steer(world_, {position, velocity, limits.radius + kLineMargin}, target, limits.max_speed, others);
  const bool is_blocked = wanted.norm() < kCreepSpeed;
  return is_blocked ? target : position + wanted.normalized() * kLookahead;
}

bool PathFollower::isClear(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) const {
  const auto num_steps = static_cast<int>(std::ceil((to - from).norm() / kClearanceStep));
  for (int i = 1; i <= num_steps; ++i) {
    if (!world_.isClear(from + (to - from) * i / num_steps, radius)) {
      return false;
    }
  }
  return true;
}

/// A speed from which the robot can stop within the free space around it, whatever its heading. Where it is not sure
/// of any room the robot may creep as long as the way straight ahead is clear.
double PathFollower::safeSpeed(const DifferentialDrive& robot, double period) const {
  const RobotOptions& limits = robot.options();
  const grid::Rigid2& pose = robot.T_map_base();
  const double room = world_.clearance(pose.translation()) - limits.radius - robot.velocity().linear * period;
  const double speed = std::sqrt(2.0 * kBraking * limits.max_acceleration * std::max(0.0, room));
  const bool may_creep = world_.isClear(pose * Eigen::Vector2d(kCreepWay, 0.0), limits.radius + kCreepMargin);
  return may_creep ? std::max(speed, kCreepSpeed) : speed;
}

}  // namespace map_matcher::simulation
