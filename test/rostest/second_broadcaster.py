#!/usr/bin/env python3
"""Another node that broadcasts transforms: passes on to /tf what comes on other_tf."""
import rospy
import tf2_msgs.msg

if __name__ == "__main__":
    rospy.init_node("second_broadcaster")
    publisher = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=10)
    subscriber = rospy.Subscriber("other_tf", tf2_msgs.msg.TFMessage, publisher.publish, queue_size=10)
    rospy.spin()
