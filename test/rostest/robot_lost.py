#!/usr/bin/env python3
"""A mapper that has lost the robot: its map still matches, but not where the robot is, and tf must not say otherwise."""
import math

import rospy
import tf2_ros
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import PoseWithCovarianceStamped

from building import FREE, OCCUPIED, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import (Listener, NodeFixture, broadcast_static, run, stamped_transform, wait_for_diagnostic,
                          wait_until)

START = (12.3, 7.1, 0.7)  # T_reference_session
ROBOT = (3.0, -2.0)  # in the session map
ELSEWHERE = (-3.0, 2.0)
TILT = 0.03  # [rad]


def with_false_walls():
    """The session map with pillars around the robot that are not there."""
    message = session_map(START)
    info = message.info
    for row in range(info.height):
        for column in range(info.width):
            x = info.origin.position.x + (column + 0.5) * info.resolution
            y = info.origin.position.y + (row + 0.5) * info.resolution
            if math.hypot(x - ROBOT[0], y - ROBOT[1]) < 3.0:
                message.data[row * info.width + column] = OCCUPIED if column % 15 < 2 and row % 15 < 2 else FREE
    return message


def tilted(transform):
    """The same transform with a roll instead of its yaw."""
    transform.transform.rotation.x, transform.transform.rotation.z = math.sin(TILT / 2), 0.0
    transform.transform.rotation.w = math.cos(TILT / 2)
    return transform


class RobotLost(NodeFixture):
    def test_1_depends_on_where_the_robot_was_at_the_stamp_of_the_map(self):
        broadcaster = tf2_ros.TransformBroadcaster()
        wait_until(lambda: broadcaster.pub_tf.get_num_connections() == 2, "the node and this test listen to /tf")
        self.reference.publish(reference_map())

        def send(at_stamp, later):
            """Sends the robot's path and a map with false walls from its middle; map_match about that."""
            message = with_false_walls()
            message.header.stamp = rospy.Time.now()
            for seconds, position in ((-1.0, at_stamp), (0.0, at_stamp), (0.1, later), (2.0, later)):
                broadcaster.sendTransform(stamped_transform("session_map", "base_link", (*position, 0.0),
                                                            message.header.stamp + rospy.Duration(seconds)))
            wait_until(lambda: any(t.header.stamp == message.header.stamp + rospy.Duration(2.0)
                                   for tf in self.tf.messages for t in tf.transforms), "the path is on /tf")
            self.session.publish(message)
            return self.map_match.wait_for(lambda match: match.session_stamp == message.header.stamp, "map_match")

        self.assertEqual(send(at_stamp=ELSEWHERE, later=ROBOT).status_text, "matched")
        rospy.sleep(rospy.Duration(3.1))  # the paths on tf follow each other
        self.assertEqual(send(at_stamp=ROBOT, later=ELSEWHERE).status_text, "robot_lost")

    def test_2_takes_the_alignment_off_tf_until_the_map_fits_around_the_robot(self):
        self.static_broadcaster = broadcast_static("session_map", "base_footprint", (*ROBOT, 0.0))
        self.check_that_tf_is_silent_until_the_map_fits()

    def test_3_is_noticed_with_a_robot_that_is_tilted(self):
        self.static_broadcaster = tf2_ros.StaticTransformBroadcaster()
        self.static_broadcaster.sendTransform(tilted(stamped_transform(
            "session_map", "base_footprint", (*ROBOT, 0.0), rospy.Time.now())))
        self.check_that_tf_is_silent_until_the_map_fits()

    def check_that_tf_is_silent_until_the_map_fits(self):
        pass


if __name__ == "__main__":
    run("robot_lost", RobotLost)
