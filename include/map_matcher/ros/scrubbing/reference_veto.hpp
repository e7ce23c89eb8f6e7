/// \file
/// Finds detections on walls of the reference map, once the robot knows where it is.
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <optional>
#include <string>

#include "map_matcher/grid/near_walls.hpp"
#include "map_matcher/scrubbing/detection_poses.hpp"

namespace map_matcher::ros_scrubbing {

/// Listens to `reference_map` (nav_msgs/OccupancyGrid, latched).
class ReferenceVeto {
 public:
  /// `distance` [m] from a wall within which nobody stands; 0: nothing is false, nothing is subscribed. `transforms`
  /// must outlive this.
  ReferenceVeto(ros::NodeHandle node, const scrubbing::FrameTransforms& transforms, double distance);

  /// Finds the detections on walls of a detector's frame at a stamp. Nothing as long as there is no map, or the
  /// transforms do not tell where the detector was in it then: one that ended up to kMaxTransformAge before is taken,
  /// for tf comes a little later than detections; an older one may be of an alignment that was taken back. The veto
  /// holds as long as this.
  scrubbing::Veto at(const scrubbing::FrameAt& detector) const;

  bool isAskedFor() const { return distance_ > 0.0; }  ///< Whether there is a distance.
  bool hasMap() const { return reference_.has_value(); }
  std::int64_t droppedMaps() const { return dropped_maps_; }  ///< Maps that could not be used.

 private:
  /// A reference map.
  struct Reference {
    std::string frame;
    grid::NearWalls near_walls;
  };

  void onMap(const nav_msgs::OccupancyGrid& message);

  const scrubbing::FrameTransforms& transforms_;
  double distance_;
  std::optional<Reference> reference_;
  std::int64_t dropped_maps_ = 0;
  ros::Subscriber subscriber_;
};

}  // namespace map_matcher::ros_scrubbing
