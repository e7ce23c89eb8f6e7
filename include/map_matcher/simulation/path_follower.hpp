/// \file
/// Drives a robot along a path.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "map_matcher/simulation/path_planner.hpp"
#include "map_matcher/simulation/robot.hpp"
#include "map_matcher/simulation/steering.hpp"
#include "map_matcher/simulation/world.hpp"

namespace map_matcher::simulation {

/// Pure pursuit (Coulter: "Implementation of the pure pursuit path tracking algorithm", 1992) of the farthest point
/// ahead on the path that a straight line reaches without touching anything. The robot never drives faster than it can
/// brake within the free space around it, so it cannot collide.
class PathFollower {
 public:
  /// `world` must outlive the follower; the path has at least one point.
  PathFollower(const World& world, Path path);

  /// The velocity to command now; `period` [s] is the time until the next command. Where there are `others`, the robot
  /// leaves the path to get past them by steer().
  Velocity command(const DifferentialDrive& robot, double period, const std::vector<Mover>& others = {});

  /// Whether the robot stood within reach of the path's end at the last command.
  bool arrived() const { return arrived_; }

 private:
  void advance(const Eigen::Vector2d& position);
  Eigen::Vector2d pointToPursue(const DifferentialDrive& robot, double lookahead) const;
  Eigen::Vector2d detour(const DifferentialDrive& robot, const std::vector<Mover>& others) const;
  bool isClear(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) const;
  double safeSpeed(const DifferentialDrive& robot, double period) const;

  const World& world_;
  Path path_;
  std::size_t nearest_ = 0;  // index of the path's point that the robot has come to
  bool arrived_ = false;
};

}  // namespace map_matcher::simulation
