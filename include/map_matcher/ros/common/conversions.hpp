/// \file
/// ROS messages to and from the types of the rooms below.
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/time.h>
#include <std_msgs/Header.h>

#include <stdexcept>
#include <string>

#include "map_matcher/grid/occupancy_grid.hpp"

namespace map_matcher::ros_common {

/// A message that cannot be used; the text names the field, its value and what was expected.
class MessageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Planar pose of a message. Throws MessageError for a position that is not finite, a quaternion that is not normalised
/// within 1e-3, or a rotation that is not about z (roll or pitch above 1e-3 rad). `name` stands in the error text.
grid::Rigid2 fromMessage(const geometry_msgs::Pose& pose, const std::string& name);

/// Planar part of a transform; the same checks.
grid::Rigid2 fromMessage(const geometry_msgs::Transform& transform, const std::string& name);

geometry_msgs::Pose toPoseMessage(const grid::Rigid2& pose);
geometry_msgs::Transform toTransformMessage(const grid::Rigid2& transform);

/// The grid of a message. Throws MessageError for one that does not keep to the limits of map_limits.hpp, a number
/// of values other than width x height, a value outside [-1, 100], or a bad origin. nav_msgs stores the resolution in
/// 32 bits: it is rounded to seven decimal digits, so that 0.05f is 0.05 again.
grid::OccupancyGrid fromMessage(const nav_msgs::OccupancyGrid& message);

/// A frame's name without the leading slash that older nodes write and tf2 refuses.
std::string frameName(const std::string& frame_id);

/// The frame of a message, by frameName(). Throws MessageError when it is empty or has blanks or line breaks.
std::string frameOf(const std_msgs::Header& header);

nav_msgs::OccupancyGrid toMessage(const grid::OccupancyGrid& grid, const std::string& frame_id, const ros::Time& stamp);

}  // namespace map_matcher::ros_common
