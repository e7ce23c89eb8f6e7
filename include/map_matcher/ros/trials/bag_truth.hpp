/// \file
/// Where the robot of a recorded drive really was.
#pragma once

#include <rosbag/bag.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/ros/bags/bag_reading.hpp"

namespace map_matcher::ros_trials {

/// What a topic of true poses has to be.
struct BagTruthRequest {
  std::string topic;                      ///< geometry_msgs/PoseStamped, the robot in the frame of the reference map.
  std::string frame;                      ///< Frame that the poses must have; empty: any but those below.
  std::vector<std::string> wrong_frames;  ///< Frames that cannot be that of the reference map.
};

/// The true poses of a bag, interpolated.
class BagTruth {
 public:
  /// Reads all of them; `path` names the bag. Throws BagError for a topic that is not there, has another type or no
  /// message, and for poses in a wrong frame or in different ones.
  BagTruth(const rosbag::Bag& bag, const std::string& path, const BagTruthRequest& request);

  /// Pose at a time [s], between the two nearest true ones; nothing where these are more than 10 s apart.
  std::optional<grid::Rigid2> at(double time) const;

 private:
  std::map<double, grid::Rigid2> poses_;  // by the stamp [s]
};

/// The true poses of a topic; nothing when no topic is asked for.
std::optional<BagTruth> readTruth(const rosbag::Bag& bag, const std::string& path, const BagTruthRequest& request);

}  // namespace map_matcher::ros_trials
