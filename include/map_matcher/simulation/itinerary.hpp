/// \file
/// Where a simulated robot goes.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/simulation/path_planner.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/world.hpp"

namespace map_matcher {

/// What an itinerary goes by.
struct ItineraryOptions {
  double robot_radius = 0.25;          ///< [m]
  double min_waypoint_distance = 8.0;  ///< [m] Straight distance of a random waypoint from the last, where possible.
  std::optional<Rigid2> start;         ///< Pose in the map frame; random when there is none.
  std::vector<Eigen::Vector2d> waypoints;  ///< [m] In the map frame, visited in this order; none: random ones for ever.
};

/// A start, and a way to one waypoint after the other.
class Itinerary {
 public:
  /// `world` must outlive the itinerary. Throws std::invalid_argument for a map without room for the robot, a start or
  /// waypoint that the robot does not fit in or cannot reach.
  Itinerary(const World& world, ItineraryOptions options, const RandomNumbers& random);

  const Rigid2& start() const { return start_; }

  /// The way from the last waypoint to the next one, std::nullopt after the last.
  std::optional<Path> nextWay();

  /// A way for a robot that cannot get on: from where it is to another random waypoint, or again to the given one.
  /// std::nullopt when there is none.
  std::optional<Path> otherWay(const Eigen::Vector2d& position);

 private:
  Rigid2 chooseStart();
  Eigen::Vector2d randomPlaceFarFrom(const Eigen::Vector2d& position);
  Path plan(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const std::string& name) const;

  const World& world_;
  ItineraryOptions options_;
  PathPlanner planner_;
  RandomNumbers random_;
  Rigid2 start_;
  Eigen::Vector2d last_place_;    // the last random waypoint
  std::vector<Path> given_ways_;  // to the waypoints of the options
  std::size_t num_given_ = 0;     // how many of them were handed out
};

}  // namespace map_matcher
