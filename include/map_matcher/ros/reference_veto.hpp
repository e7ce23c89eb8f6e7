/// \file
/// Takes out detections on walls of the reference map, once the robot knows where it is.
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "map_matcher/grid/near_walls.hpp"
#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher {

/// Listens to `reference_map` (nav_msgs/OccupancyGrid, latched).
class ReferenceVeto {
 public:
  /// `distance` [m] from a wall within which nobody stands; 0: nothing is taken out, nothing is subscribed. `tf` must
  /// outlive this.
  ReferenceVeto(ros::NodeHandle node, const tf2::BufferCore& tf, double distance);

  /// Takes the detections on walls out of the set and returns how many those were; 0 as long as there is no map, or tf
  /// does not know where the detector is in it.
  int apply(DetectionSet& set) const;

 private:
  void onMap(const nav_msgs::OccupancyGrid& message);

  const tf2::BufferCore& tf_;
  double distance_;
  std::string reference_frame_;
  std::optional<NearWalls> near_walls_;
  ros::Subscriber subscriber_;
};

}  // namespace map_matcher
