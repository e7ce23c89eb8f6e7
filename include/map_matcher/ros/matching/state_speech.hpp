/// \file
/// What a robot that talks says of itself.
#pragma once

#include <map_matcher/MapMatch.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <string>

namespace map_matcher::ros_matching {

/// Sends a sentence on `speech` (std_msgs/String) when the robot is found, in another reference map too, and when it is
/// lost or begins to search anew. Not thread-safe.
class StateSpeech {
 public:
  /// Sends nothing at all unless `enabled`.
  StateSpeech(ros::NodeHandle node, bool enabled);

  /// What came of a map.
  void tell(const MapMatch& report);

 private:
  std::uint8_t state_ = MapMatch::SEARCHING;  // that was told of
  std::string reference_;                     // where it was found
  ros::Publisher publisher_;
};

}  // namespace map_matcher::ros_matching
