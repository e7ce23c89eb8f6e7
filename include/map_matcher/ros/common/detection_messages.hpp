/// \file
/// Detected people from ROS messages.
#pragma once

#include <geometry_msgs/PoseArray.h>
#include <map_matcher/PersonDetections.h>
#include <ros/time.h>

#include <optional>
#include <string>

#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher::ros_common {

/// The stamp of a message, exactly.
scrubbing::Stamp stampOf(const ros::Time& time);

/// What time it is by the clock of ROS.
scrubbing::Stamp rosNow();

/// The time of a stamp; nothing for one that ros::Time cannot show: before the epoch or after the year 2106.
std::optional<ros::Time> rosTimeOf(scrubbing::Stamp stamp);

/// The people of DR-SPAAM's message, all with score 1; of the poses only the positions are read, since DR-SPAAM leaves
/// the quaternions zero. `source` is the name of the detector. Throws MessageError when there is no frame.
scrubbing::DetectionSet fromMessage(const geometry_msgs::PoseArray& message, const std::string& source);

/// The same for a detector with scores.
scrubbing::DetectionSet fromMessage(const PersonDetections& message, const std::string& source);

}  // namespace map_matcher::ros_common
