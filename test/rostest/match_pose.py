#!/usr/bin/env python3
"""The robot's pose in the reference map, at the stamp of the session map."""
import geometry_msgs.msg
import rospy
import tf2_ros

from building import RESOLUTION, reference_map, session_map, transformed
from node_fixture import Listener, NodeFixture, run, stamped_transform, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session


class MatchPose(NodeFixture):
    def setUp(self):
        super().setUp()
        self.pose = Listener("match_pose", geometry_msgs.msg.PoseWithCovarianceStamped)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        wait_until(lambda: self.broadcaster.pub_tf.get_num_connections() == 2, "the node and this test listen to /tf")
        self.reference.publish(reference_map())

    def robot_at(self, stamp, pose):
        self.broadcaster.sendTransform(stamped_transform("session_map", "base_link", pose, stamp))

    def test_waits_for_the_robots_pose_at_the_stamp_of_the_session_map(self):
        match = self.match(session_map(START))
        stamp = match.session_stamp

        self.robot_at(stamp - rospy.Duration(1), (1.0, 0.0, 0.0))
        self.robot_at(stamp + rospy.Duration(1), (3.0, 0.0, 0.0))

        pose = self.pose.wait_for(lambda pose: pose.header.stamp == stamp, "match_pose at the session map's stamp")
        expected = transformed((match.x, match.y, match.yaw), 2.0, 0.0)
        self.assertEqual(pose.header.frame_id, "map")
        self.assertAlmostEqual(pose.pose.pose.position.x, expected[0], places=4)
        self.assertAlmostEqual(pose.pose.pose.position.y, expected[1], places=4)
        for k in (0, 7, 35):  # x, y, yaw
            self.assertGreater(pose.pose.covariance[k], 0.0)
            self.assertLess(pose.pose.covariance[k], RESOLUTION ** 2)

    def test_is_not_sent_when_tf_knows_no_robot(self):
        match = self.match(session_map(START))

        self.log.wait_for(lambda line: "match_pose is not sent" in line.msg, "warning")
        self.assertFalse([pose for pose in self.pose.messages if pose.header.stamp == match.session_stamp])


if __name__ == "__main__":
    run("match_pose", MatchPose)
