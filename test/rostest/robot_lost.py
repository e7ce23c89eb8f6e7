#!/usr/bin/env python3
"""A mapper that has lost the robot: its map still matches, but not where the robot is, and tf must not say otherwise."""
import math

import rospy
import tf2_ros
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import PoseWithCovarianceStamped
from std_msgs.msg import String

from building import FREE, OCCUPIED, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import Listener, NodeFixture, run, stamped_transform, wait_for_diagnostic, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session
ROBOT = (3.0, -2.0)  # in the session map
ELSEWHERE = (-3.5, 2.0)
TILT = 0.03  # [rad], of the robot
FOUND, LOST = "I know where I am, in map.", "I am lost."


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


def robot_at(position, stamp):
    """The robot there on tf, tilted as on a ramp."""
    transform = stamped_transform("session_map", "base_link", (*position, 0.0), stamp)
    transform.transform.rotation.x, transform.transform.rotation.w = math.sin(TILT / 2), math.cos(TILT / 2)
    return transform


class RobotLost(NodeFixture):
    def setUp(self):
        super().setUp()
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.pose = Listener("match_pose", PoseWithCovarianceStamped)
        wait_until(lambda: self.broadcaster.pub_tf.get_num_connections() == 2, "the node and this test listen to /tf")
        self.reference.publish(reference_map())

    def match_with_robot(self, session, position, later=None):
        """map_match about the session map, with the robot at `position` at its stamp, and elsewhere at present."""
        session.header.stamp = rospy.Time.now()
        for seconds, there in ((-0.1, position), (0.01, position), (0.02, later or position)):
            self.broadcaster.sendTransform(robot_at(there, session.header.stamp + rospy.Duration(seconds)))
        last = session.header.stamp + rospy.Duration(0.02)
        self.tf.wait_for(lambda tf: any(t.header.stamp == last for t in tf.transforms), "the robot on tf")
        self.session.publish(session)
        return self.map_match.wait_for(lambda match: match.session_stamp == session.header.stamp, "map_match")

    def assert_said(self, speech, *sentences):
        """These were the last sentences."""
        wait_until(lambda: [said.data for said in speech.messages[-len(sentences):]] == list(sentences),
                   "the robot says %s" % " ".join(sentences))

    def test_takes_the_alignment_off_tf_until_the_map_fits_around_the_robot(self):
        speech = Listener("speech", String)
        match = self.match_with_robot(session_map(START), ROBOT)
        self.assert_said(speech, FOUND)
        self.pose.wait_for(lambda _: True, "match_pose: the node knows where the robot is")
        self.assertGreater(match.nearby_cells, 30)
        self.assertGreater(match.nearby_ratio, 0.9)
        self.wait_for_tf("map", "session_map")

        lost = self.match_with_robot(with_false_walls(), ROBOT)

        self.assertEqual(lost.status, MapMatch.ROBOT_LOST, lost.reason)
        self.assertEqual(lost.status_text, "robot_lost")
        self.assert_said(speech, FOUND, LOST)
        self.assertLess(lost.nearby_ratio, 0.5)
        self.assertGreater(lost.hit_ratio, 0.6)
        self.assertTrue(math.isnan(lost.T_reference_session.translation.x))
        self.log.wait_for(lambda line: line.level == line.ERROR and "the alignment is not broadcast" in line.msg, "error")
        self.assert_no_tf("session_map")
        wait_for_diagnostic("map_matcher: alignment",
                            lambda s: s.level == DiagnosticStatus.ERROR and "not where the robot is" in s.message)

        self.assertEqual(self.match_with_robot(session_map(START), ROBOT).status_text, "matched")
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)
        self.assertEqual(self.match_with_robot(session_map(START), ROBOT).status_text, "matched")
        self.assert_said(speech, FOUND, LOST, FOUND)

    def test_is_asked_of_where_the_robot_was_at_the_stamp_of_the_map(self):
        self.assertEqual(self.match_with_robot(session_map(START), ELSEWHERE).status_text, "matched")

        self.assertEqual(self.match_with_robot(with_false_walls(), ELSEWHERE, later=ROBOT).status_text, "matched")

        self.assertEqual(self.match_with_robot(with_false_walls(), ROBOT, later=ELSEWHERE).status_text, "robot_lost")


if __name__ == "__main__":
    run("robot_lost", RobotLost)
