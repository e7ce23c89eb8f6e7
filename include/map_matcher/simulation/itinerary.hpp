/// \file
/// Where a simulated robot goes.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/simulation/exploration.hpp"
#include "map_matcher/simulation/lidar.hpp"
#include "map_matcher/simulation/path_planner.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/rectangle.hpp"
#include "map_matcher/simulation/world.hpp"

namespace map_matcher::simulation {

/// What an itinerary goes by.
struct ItineraryOptions {
  double robot_radius = 0.25;          ///< [m]
  double min_waypoint_distance = 8.0;  ///< [m] Straight distance of a random waypoint from the last, where possible.
  std::optional<grid::Rigid2> start;   ///< Pose in the map frame; random when there is none.
  std::optional<Rectangle> area;       ///< Where random starts and waypoints lie [m, map frame]; none: anywhere.
  std::vector<Eigen::Vector2d> waypoints;  ///< [m] In the map frame, visited in this order; none: random ones for ever.
  bool explore = false;                    ///< Whether to go where nothing was seen yet; without waypoints.
};

/// A start, and a way to one waypoint after the other.
class Itinerary {
 public:
  /// `world` must outlive the itinerary. Throws std::invalid_argument for a map without room for the robot, a start or
  /// waypoint that the robot does not fit in or cannot reach, an area without room for the robot.
  Itinerary(const World& world, ItineraryOptions options, const RandomNumbers& random);

  const grid::Rigid2& start() const { return start_; }

  /// Tells an exploration what was seen from the true pose of a lidar.
  void see(const scan::PlanarScan& scan, const grid::Rigid2& T_map_lidar);

  /// Whether there still is a reason to go on to this goal [m]: a frontier may be seen from afar.
  bool isWorthwhile(const Eigen::Vector2d& goal) const { return !exploration_ || exploration_->isFrontier(goal); }

  /// The way from the last waypoint to the next one; of an exploration from `position` [m]. std::nullopt after the last
  /// waypoint, and when nothing is left to be seen.
  std::optional<Path> nextWay(const Eigen::Vector2d& position);

  /// A way for a robot that cannot get on to its goal [m]: from where it is to another waypoint or frontier, or again
  /// to the given one. std::nullopt when there is none.
  std::optional<Path> otherWay(const Eigen::Vector2d& position, const Eigen::Vector2d& goal);

 private:
  std::vector<Eigen::Vector2d> randomPlaces() const;
  grid::Rigid2 chooseStart();
  Eigen::Vector2d randomPlaceFarFrom(const Eigen::Vector2d& position);
  Path plan(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const std::string& name) const;

  const World& world_;
  ItineraryOptions options_;
  PathPlanner planner_;
  std::optional<Exploration> exploration_;
  RandomNumbers random_;
  std::vector<Eigen::Vector2d> places_;  // that random starts and waypoints are among
  grid::Rigid2 start_;
  Eigen::Vector2d last_place_;    // the last random waypoint
  std::vector<Path> given_ways_;  // to the waypoints of the options
  std::size_t num_given_ = 0;     // how many of them were handed out
};

}  // namespace map_matcher::simulation
