"""Poses of the robot as rviz's tool sends them."""
import geometry_msgs.msg
import rospy

from building import pose

RVIZ_COVARIANCE = [0.25] + 6 * [0.0] + [0.25] + 27 * [0.0] + [0.06853892326654787]


def initial_pose(frame, x, y, yaw, covariance=None):
    """That the robot is there now, as sure as rviz says it."""
    message = geometry_msgs.msg.PoseWithCovarianceStamped()
    message.header.frame_id, message.header.stamp = frame, rospy.Time.now()
    message.pose.pose = pose(x, y, yaw)
    message.pose.covariance = RVIZ_COVARIANCE if covariance is None else covariance
    return message
