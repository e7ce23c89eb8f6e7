"""A robot in a rectangular room under simulated time: it publishes /clock, /tf and scans for a mapper."""
import math

import rospy
import tf2_msgs.msg
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan

from node_fixture import stamped_transform

LEFT, RIGHT, LOWER, UPPER = -3.0, 4.02, -2.0, 2.52  # walls [m], in the odometry frame
MOUNT = (0.25, 0.0, 0.1)  # T_base_laser
BEAMS = 360
APERTURE = 1.5 * math.pi  # [rad]
RANGE_MAX = 20.0  # [m]


def distance_to_wall(x, y):
    return min(abs(x - LEFT), abs(x - RIGHT), abs(y - LOWER), abs(y - UPPER))


def range_in_room(x, y, direction):
    """Distance from a point in the room to its walls in a direction [rad]."""
    dx, dy = math.cos(direction), math.sin(direction)
    along_x = ((RIGHT if dx > 0 else LEFT) - x) / dx if dx else math.inf
    along_y = ((UPPER if dy > 0 else LOWER) - y) / dy if dy else math.inf
    return min(along_x, along_y)


class RobotInRoom:
    """Its odometry is perfect. Every step advances the time and sends the transforms and then the scan of a pose."""

    def __init__(self):
        self.clock = rospy.Publisher("/clock", Clock, queue_size=10)
        self.tf = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=100)
        self.scan = rospy.Publisher("scan", LaserScan, queue_size=10)

    def is_heard(self):
        """Whether a mapper has subscribed to everything."""
        return all(publisher.get_num_connections() > 0 for publisher in (self.clock, self.tf, self.scan))

    def set_time(self, time):
        self.clock.publish(Clock(rospy.Time.from_sec(time)))

    def step(self, time, pose, beams=BEAMS):
        stamp = rospy.Time.from_sec(time)
        self.set_time(time)
        self.tf.publish(tf2_msgs.msg.TFMessage([stamped_transform("odom", "base_link", pose, stamp),
                                                stamped_transform("base_link", "laser", MOUNT, stamp)]))
        self.scan.publish(self.scan_message(stamp, pose, beams))

    def scan_message(self, stamp, pose, beams):
        message = LaserScan(angle_min=-APERTURE / 2, angle_max=APERTURE / 2, angle_increment=APERTURE / (beams - 1),
                            range_min=0.05, range_max=RANGE_MAX)
        message.header.stamp, message.header.frame_id = stamp, "laser"
        x = pose[0] + math.cos(pose[2]) * MOUNT[0] - math.sin(pose[2]) * MOUNT[1]
        y = pose[1] + math.sin(pose[2]) * MOUNT[0] + math.cos(pose[2]) * MOUNT[1]
        message.ranges = [range_in_room(x, y, pose[2] + MOUNT[2] + message.angle_min + i * message.angle_increment)
                          for i in range(beams)]
        return message
