#!/usr/bin/env python3
"""initialpose, as rviz's tool sends it, is taken as a hint; one that makes no sense is told and changes nothing."""
import geometry_msgs.msg
import rospy
import tf2_ros

from building import reference_map, session_map
from initial_poses import RVIZ_COVARIANCE, initial_pose
from node_fixture import Listener, NodeFixture, run, stamped_transform, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session


def initialpose(frame="map", x=12.0, y=7.0, covariance=None):
    return initial_pose(frame, x, y, 0.7, covariance)


class InitialposeIn(NodeFixture):
    def setUp(self):
        super().setUp()
        self.initialpose = rospy.Publisher("initialpose", geometry_msgs.msg.PoseWithCovarianceStamped, queue_size=10)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        wait_until(lambda: self.broadcaster.pub_tf.get_num_connections() == 2, "the node and this test listen to /tf")
        wait_until(lambda: self.initialpose.get_num_connections() >= 1, "the node listens to initialpose")
        self.log.wait_until_served()

    def tearDown(self):
        self.initialpose.unregister()
        super().tearDown()

    def robot_on_tf(self, stamp):
        self.broadcaster.sendTransform(stamped_transform("session_map", "base_link", (0.0, 0.0, 0.0), stamp))

    def assert_ignored(self, message, why):
        self.log.clear()
        self.initialpose.publish(message)
        line = self.log.wait_for(lambda line: "the initialpose of /initialpose_in is ignored" in line.msg, "a warning")
        self.assertEqual(line.level, line.WARN)
        self.assertIn(why, line.msg)

    def test_1_is_ignored_before_there_are_maps(self):
        self.assert_ignored(initialpose(), "there is no reference map yet")
        self.reference.publish(reference_map())
        self.log.wait_for(lambda line: line.msg.startswith("reference map:"), "the reference map in use")
        self.assert_ignored(initialpose(), "there is no session map yet")

    def test_2_is_ignored_when_it_makes_no_sense_and_the_alignment_stays(self):
        self.reference.publish(reference_map())
        self.match(session_map(START))
        not_a_number = list(RVIZ_COVARIANCE)
        not_a_number[7] = float("nan")

        self.assert_ignored(initialpose(frame="odom"), 'it is in the frame "odom", expected that of the reference map, "map"')
        self.assert_ignored(initialpose(x=100.0), "(100 m, 7 m) lies outside the reference map")
        self.assert_ignored(initialpose(covariance=36 * [0.0]), "the variance of x is 0, expected above 0")
        self.assert_ignored(initialpose(covariance=not_a_number), "no finite number")
        self.assert_ignored(initialpose(x=float("nan")), "expected finite numbers")
        unknown_robot = 'tf knows no frame "base_link"'
        self.assert_ignored(initialpose(), unknown_robot)

        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)

    def test_3_waits_for_the_robot_on_tf_and_is_weighed_with_the_map_at_hand(self):
        self.reference.publish(reference_map())
        match = self.match(session_map(START))
        message = initialpose()
        self.robot_on_tf(message.header.stamp - rospy.Duration(0.5))
        answers = Listener("map_match", type(match))
        answers.wait_for(lambda _: True, "the answer so far")
        answers.clear()
        self.log.clear()

        self.initialpose.publish(message)
        self.robot_on_tf(message.header.stamp + rospy.Duration(0.5))

        line = self.log.wait_for(lambda line: "the initialpose of /initialpose_in" in line.msg, "a line")
        self.assertIn("it is weighed against what the next map shows", line.msg)
        again = answers.wait_for(lambda _: True, "the map at hand is matched again")
        self.assertEqual(again.session_stamp, match.session_stamp)


if __name__ == "__main__":
    run("initialpose_in", InitialposeIn)
