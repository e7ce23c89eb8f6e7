/// \file
/// Draws session maps from a bag, without a roscore.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/evaluation/trajectory_error.hpp"
#include "map_matcher/ros/bags/bag_reading.hpp"
#include "map_matcher/ros/mapping/session_mapping.hpp"

namespace map_matcher::ros_trials {

/// Which part of which bag to draw, and how.
struct BagMappingRequest {
  std::string bag;  ///< Path of the bag.
  /// Topics of sensor_msgs/LaserScan, of a laser each; none: the only one in the bag.
  std::vector<std::string> scan_topics;
  double from = 0.0;            ///< Scans before this are left out [s since the bag begins].
  std::optional<double> until;  ///< Scans after this are left out [s since the bag begins]; nullopt: none.
  ros_mapping::SessionMappingOptions options;
};

/// What mapping a bag gave besides the maps.
struct BagMappingResult {
  std::vector<std::string> scan_topics;       ///< The topics of the scans.
  ros::Time begin;                            ///< When the bag begins.
  int scans = 0;                              ///< Scans in the part of the bag, of all lasers.
  int scans_drawn = 0;                        ///< Scans in the map.
  int scans_not_fitting = 0;                  ///< Scans that did not fit the map.
  int scans_without_tf = 0;                   ///< Scans whose transforms are not in the bag.
  int scans_refused = 0;                      ///< Scans that could not be used for another reason.
  std::string last_problem;                   ///< The latest reason why a scan could not be used; empty: none.
  std::vector<evaluation::StampedPose> path;  ///< T_session_base at the scans that were used; times are stamps [s].
};

/// Draws session maps from the scans and the /tf and /tf_static of a bag, as the session_mapper node would. `on_map` is
/// called in the order of time with each map that is due (map_update_interval), and at the end with the last map once
/// more when scans were drawn since. Throws BagError for a bag that cannot be read or does not have what it takes, and
/// when not one scan could be used; std::invalid_argument for options out of range.
BagMappingResult mapBag(const BagMappingRequest& request,
                        const std::function<void(const ros_mapping::SessionSnapshot&)>& on_map);

}  // namespace map_matcher::ros_trials
