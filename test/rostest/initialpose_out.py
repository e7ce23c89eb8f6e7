#!/usr/bin/env python3
"""initialpose for amcl: once each time the robot was found, with the stamp of the session map."""
import geometry_msgs.msg
import rospy
import tf2_ros
from std_srvs.srv import Empty

from building import reference_map, session_map, transformed
from map_matcher.msg import MapMatch
from node_fixture import DEADLINE, Listener, NodeFixture, run, stamped_transform, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session
ELSEWHERE = (9.1, 8.0, -2.4)
ROBOT = (2.0, 1.0, 0.3)  # in the session map


class InitialposeOut(NodeFixture):
    def setUp(self):
        super().setUp()
        self.broadcaster = tf2_ros.TransformBroadcaster()
        wait_until(lambda: self.broadcaster.pub_tf.get_num_connections() == 2, "the node and this test listen to /tf")
        self.sending = rospy.Timer(rospy.Duration(0.02), lambda _: self.broadcaster.sendTransform(
            stamped_transform("session_map", "base_link", ROBOT, rospy.Time.now())))
        self.reference.publish(reference_map())
        rospy.wait_for_service("global_localization", DEADLINE)
        self.forget = rospy.ServiceProxy("global_localization", Empty)

    def tearDown(self):
        self.sending.shutdown()
        super().tearDown()

    def test_is_sent_once_for_each_time_that_the_robot_was_found(self):
        earlier = self.match(session_map(START))  # while nobody listens
        match = self.match(session_map(START, seen=7.9))

        initialpose = Listener("initialpose", geometry_msgs.msg.PoseWithCovarianceStamped)
        pose = initialpose.wait_for(lambda _: True, "initialpose for who listens now")

        self.assertGreater(match.session_stamp, earlier.session_stamp)
        self.assertEqual(pose.header.stamp, match.session_stamp)
        self.assertEqual(pose.header.frame_id, "map")
        expected = transformed((match.x, match.y, match.yaw), ROBOT[0], ROBOT[1])
        self.assertAlmostEqual(pose.pose.pose.position.x, expected[0], places=4)
        self.assertAlmostEqual(pose.pose.pose.position.y, expected[1], places=4)
        self.assertGreater(pose.pose.covariance[0], 0.0)

        self.match(session_map(START))  # found already
        self.assert_no_tf("nobody")
        self.assertEqual(len(initialpose.messages), 1)

        initialpose.clear()
        self.forget()
        initialpose.wait_for(lambda _: True, "initialpose after the node had forgotten all")

        initialpose.clear()
        self.match(session_map(ELSEWHERE, seen=7.9), MapMatch.UNCONFIRMED)
        match = self.match(session_map(ELSEWHERE))
        pose = initialpose.wait_for(lambda _: True, "initialpose of the other place")
        self.assertEqual(pose.header.stamp, match.session_stamp)

        self.assertFalse([line.msg for line in self.log.messages if "the initialpose of" in line.msg],
                         "the node listens to itself")


if __name__ == "__main__":
    run("initialpose_out", InitialposeOut)
