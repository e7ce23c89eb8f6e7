#!/usr/bin/env python3
"""A planner set up wrongly: its obstacle layer reads scrubbed scans, and its static layer the session map."""
import rospy
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan


def ignore(_):
    """What is read does not matter: that it is read does."""


if __name__ == "__main__":
    rospy.init_node("move_base")
    subscribers = [rospy.Subscriber("scan_scrubbed", LaserScan, ignore),
                   rospy.Subscriber("session_map", OccupancyGrid, ignore)]
    rospy.spin()
