#!/usr/bin/env python3
"""Another node that publishes session maps: passes on to session_map what comes on second_mapper_map."""
import rospy
from nav_msgs.msg import OccupancyGrid

if __name__ == "__main__":
    rospy.init_node("second_mapper")
    publisher = rospy.Publisher("session_map", OccupancyGrid, queue_size=10)
    subscriber = rospy.Subscriber("second_mapper_map", OccupancyGrid, publisher.publish, queue_size=10)
    rospy.spin()
