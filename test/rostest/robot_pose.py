#!/usr/bin/env python3
"""The robot's pose in the reference map while it drives, less and less certain since the last match."""
import geometry_msgs.msg
import rospy
import tf2_ros
from std_srvs.srv import Empty

from building import reference_map, session_map, transformed
from map_matcher.msg import MapMatch
from node_fixture import DEADLINE, Listener, NodeFixture, run, stamped_transform, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session
RATE = 20.0  # [Hz], of robot_pose: see robot_pose.test
X, Y, YAW = 0, 7, 35  # in the covariance


class RobotPose(NodeFixture):
    def setUp(self):
        super().setUp()
        self.pose = Listener("robot_pose", geometry_msgs.msg.PoseWithCovarianceStamped)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.robot = (0.0, 0.0, 0.0)  # in the session map
        wait_until(lambda: self.broadcaster.pub_tf.get_num_connections() == 2, "the node and this test listen to /tf")
        self.sending = rospy.Timer(rospy.Duration(0.02), lambda _: self.broadcaster.sendTransform(
            stamped_transform("session_map", "base_link", self.robot, rospy.Time.now())))
        self.reference.publish(reference_map())

    def tearDown(self):
        self.sending.shutdown()
        super().tearDown()

    def pose_at(self, match, robot):
        """The next pose of the robot where tf has it in the session map."""
        expected = transformed((match.x, match.y, match.yaw), robot[0], robot[1])
        self.pose.clear()
        return self.pose.wait_for(
            lambda pose: abs(pose.pose.pose.position.x - expected[0]) < 1e-3 and
            abs(pose.pose.pose.position.y - expected[1]) < 1e-3, "robot_pose at (%.3f, %.3f)" % expected)

    def test_follows_the_robot_and_is_less_certain_with_the_way(self):
        match = self.match(session_map(START))
        first = self.pose_at(match, self.robot)
        self.assertEqual(first.header.frame_id, "map")
        self.assertLess((rospy.Time.now() - first.header.stamp).to_sec(), 1.0)
        for k in (X, Y, YAW):
            self.assertGreater(first.pose.covariance[k], 0.0)

        for metre in (1.0, 2.0, 3.0):
            self.robot = (metre, 0.0, 0.0)
            self.pose_at(match, self.robot)
        later = self.pose_at(match, self.robot)

        for k in (X, Y, YAW):
            self.assertGreater(later.pose.covariance[k], first.pose.covariance[k])
        self.assertAlmostEqual(later.pose.covariance[YAW] - first.pose.covariance[YAW], 3 * 0.0105 ** 2, delta=2e-5)

        self.match(session_map(START, seen=7.9))
        self.pose.wait_for(lambda pose: pose.pose.covariance[YAW] < later.pose.covariance[YAW] / 2,
                           "a pose that is certain again")

    def test_comes_at_its_rate(self):
        self.match(session_map(START))
        self.pose.wait_for(lambda _: len(self.pose.messages) >= 41, "41 poses")

        stamps = [pose.header.stamp.to_sec() for pose in self.pose.messages]

        self.assertEqual(sorted(set(stamps)), stamps)
        self.assertAlmostEqual((stamps[40] - stamps[0]) / 40, 1 / RATE, delta=0.5 / RATE)

    def test_is_silent_while_nothing_is_known(self):
        self.match(session_map(START))
        self.pose.wait_for(lambda _: True, "robot_pose")
        empty = session_map(START, seen=0.5)
        self.match(empty, MapMatch.TOO_FEW_SESSION_CELLS)
        rospy.wait_for_service("global_localization", DEADLINE)
        rospy.ServiceProxy("global_localization", Empty)()
        self.map_match.wait_for(lambda match: match.status == MapMatch.TOO_FEW_SESSION_CELLS, "an answer")
        self.assert_no_tf("session_map")
        self.pose.clear()

        self.assert_no_tf("session_map")

        self.assertFalse(self.pose.messages)


if __name__ == "__main__":
    run("robot_pose", RobotPose)
