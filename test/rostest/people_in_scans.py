"""Scans of a round room with a laser in its middle, and detections of people in them."""
import math

import geometry_msgs.msg
from sensor_msgs.msg import LaserScan

from map_matcher.msg import PersonDetection, PersonDetections

BEAMS = 361
INCREMENT = math.radians(1.0)
RANGE = 2.0  # [m] of every beam
AHEAD = BEAMS // 2  # index of the beam along x
INTERVAL = 0.07  # [s] between two scans


def scan_message(stamp, ranges=None, frame="laser"):
    scan = LaserScan()
    scan.header.frame_id, scan.header.stamp = frame, stamp
    scan.angle_increment = INCREMENT
    scan.ranges = [RANGE] * BEAMS if ranges is None else ranges
    scan.angle_min = -INCREMENT * AHEAD
    scan.angle_max = scan.angle_min + INCREMENT * (len(scan.ranges) - 1)
    scan.range_min, scan.range_max = 0.05, 20.0
    scan.intensities = [float(i) for i in range(len(scan.ranges))]
    return scan


def pose_array(stamp, positions, frame="laser"):
    message = geometry_msgs.msg.PoseArray()
    message.header.frame_id, message.header.stamp = frame, stamp
    for x, y in positions:
        pose = geometry_msgs.msg.Pose()  # its quaternion stays zero, as DR-SPAAM's
        pose.position.x, pose.position.y = x, y
        message.poses.append(pose)
    return message


def scored_detections(stamp, people):
    message = PersonDetections()
    message.header.frame_id, message.header.stamp = "laser", stamp
    for x, y, score in people:
        detection = PersonDetection(score=score)
        detection.position.x, detection.position.y = x, y
        message.detections.append(detection)
    return message


def removed_beams(scan):
    return [i for i, value in enumerate(scan.ranges) if not math.isfinite(value)]


def beams_near(direction):
    """Those whose points, 2 m away, lie within 0.3 m of one that is 2 m away in this direction [rad]."""
    half_width = 2 * math.asin(0.15 / RANGE)
    angles = [INCREMENT * (i - AHEAD) for i in range(BEAMS)]
    return [i for i, angle in enumerate(angles) if abs(math.remainder(angle - direction, 2 * math.pi)) < half_width]
