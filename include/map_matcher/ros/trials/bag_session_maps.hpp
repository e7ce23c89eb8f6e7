/// \file
/// Session maps that a mapper drew while a bag was recorded.
#pragma once

#include <string>

#include "map_matcher/ros/bags/bag_reading.hpp"
#include "map_matcher/trials/session_matching.hpp"

namespace map_matcher::ros_trials {

/// Where a bag holds a mapper's session maps.
struct BagSessionMapsRequest {
  std::string bag;                       ///< Path of the bag.
  std::string map_topic;                 ///< nav_msgs/OccupancyGrid.
  std::string truth_topic;               ///< geometry_msgs/PoseStamped in the reference map; empty: not known.
  std::string truth_frame;               ///< Frame that the true poses must have; empty: any.
  std::string odom_frame = "odom";       ///< tf frame of the odometry.
  std::string base_frame = "base_link";  ///< tf frame of the robot.
};

/// What a bag gave.
struct BagSessionMapsResult {
  int maps = 0;              ///< Session maps in the bag.
  int maps_left_out = 0;     ///< Those that could not be used.
  std::string last_problem;  ///< Why the last of them could not be used; empty: all could.
};

/// Matches the maps of a topic in the order in which they were recorded, all as maps of one session, with the robot's
/// pose in them from tf and the truth interpolated at their stamps. The way driven is that of the odometry since the
/// first map; the true alignment is that of the first pose of the robot in the session frame. Throws BagError for a bag
/// that cannot be read, lacks a topic or has it with another type, whose true poses are in a wrong frame, or of which
/// no map could be used.
BagSessionMapsResult matchSessionMaps(const BagSessionMapsRequest& request, trials::SessionMatching& matching);

}  // namespace map_matcher::ros_trials
