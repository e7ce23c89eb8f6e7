/// \file
/// Laser scans and their transforms from ROS messages.
#pragma once

#include <geometry_msgs/Transform.h>
#include <sensor_msgs/LaserScan.h>

#include <string>

#include "map_matcher/scan/planar_scan.hpp"
#include "map_matcher/scrubbing/scrubbed_scan.hpp"

namespace map_matcher::ros_common {

/// Where the beams of a message point and how far they reach, as it says; not checked.
scan::ScanLayout layoutOf(const sensor_msgs::LaserScan& message);

/// Throws MessageError, naming the field, its value and what was expected, unless the message has ranges, a valid
/// layout, and an angle_max that agrees with angle_min, angle_increment and the number of ranges to within two beams.
void checkLayout(const sensor_msgs::LaserScan& message);

/// The scan of a message as the scrubber takes it; the ranges are those of the message, which they keep alive. Throws
/// MessageError as checkLayout(), and when there is no frame.
scrubbing::RawScan rawScanOf(const sensor_msgs::LaserScanConstPtr& message);

/// The message with other ranges. It is the very message that was given when nothing was removed.
sensor_msgs::LaserScanConstPtr scrubbedMessage(const sensor_msgs::LaserScanConstPtr& message,
                                               const scrubbing::RangeRemoval& removal);

/// The scan of a message. Throws MessageError that names the field, its value and what was expected.
scan::PlanarScan fromMessage(const sensor_msgs::LaserScan& message);

/// How a laser sits on the robot, from the transform base <- laser. Throws MessageError for a translation that is not
/// within 1e8 m, a quaternion that is not normalised, and a laser whose scan plane is tilted by more than about 2.5
/// degrees (slam_gmapping's limit).
scan::LaserMount laserMountFrom(const geometry_msgs::Transform& T_base_laser);

/// The part of a transform in the plane: x, y and yaw; height, roll and pitch are dropped, as slam_gmapping does with
/// odometry. Throws MessageError, naming `name`, for a translation that is not within 1e8 m or a quaternion that is not
/// normalised.
grid::Rigid2 projectToPlane(const geometry_msgs::Transform& transform, const std::string& name);

}  // namespace map_matcher::ros_common
