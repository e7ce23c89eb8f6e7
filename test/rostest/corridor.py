#!/usr/bin/env python3
"""A corridor in which every door looks like the next: nothing is said of the place until the robot has come around the
corner, or somebody says where it is."""
import math

import rospy
import tf2_ros
from geometry_msgs.msg import PoseWithCovarianceStamped

from building import FREE, OCCUPIED, grid, pose, session_map
from map_matcher.msg import MapMatch
from node_fixture import NodeFixture, run, stamped_transform, wait_until

SPACING = 4.0  # of the niches on both sides [m]
LENGTH = 40.0  # [m]
START = (21.3, 4.0, 0.2)  # T_reference_session, in the middle
CORNER = (34.3, 4.0, 0.2)  # within sight of the room at the end
RVIZ_COVARIANCE = [0.25] + 6 * [0.0] + [0.25] + 27 * [0.0] + [0.06853892326654787]


def is_wall(x, y):
    """A corridor along x with niches, and a room with a pillar at its end."""
    if not -0.2 <= x < LENGTH + 6.2 or not 0.0 <= y < 8.0:
        return False
    if x >= LENGTH:
        inside = LENGTH <= x < LENGTH + 6.0 and 1.0 <= y < 7.0
        return not inside or math.hypot(x - LENGTH - 3.5, y - 2.5) < 0.4
    if x < 0.0:
        return 2.8 <= y < 5.2
    niche = math.fmod(x, SPACING) < 1.0
    low, high = (2.4, 5.6) if niche else (2.8, 5.2)
    return low - 0.4 <= y < low or high <= y < high + 0.4


def corridor():
    return grid("map", (-1.0, -1.0), (490, 100), lambda x, y: OCCUPIED if is_wall(x, y) else FREE)


class Corridor(NodeFixture):
    def setUp(self):
        super().setUp()
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.initialpose = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)
        wait_until(lambda: self.broadcaster.pub_tf.get_num_connections() == 2, "the node and this test listen to /tf")
        wait_until(lambda: self.initialpose.get_num_connections() == 1, "the node listens to initialpose")
        self.reference.publish(corridor())

    def tearDown(self):
        self.initialpose.unregister()
        super().tearDown()

    def suppose(self, x):
        """What rviz's tool says of the robot, which stands where the session began."""
        message = PoseWithCovarianceStamped()
        message.header.frame_id, message.header.stamp = "map", rospy.Time.now()
        message.pose.pose = pose(x, START[1], START[2])
        message.pose.covariance = RVIZ_COVARIANCE
        self.broadcaster.sendTransform(
            stamped_transform("session_map", "base_link", (0.0, 0.0, 0.0), message.header.stamp))
        self.map_match.clear()
        self.initialpose.publish(message)

    def test_resolves_itself_around_the_corner(self):
        between = self.match(session_map(CORNER, seen=5.0, wall=is_wall), MapMatch.AMBIGUOUS)
        self.assertTrue(math.isnan(between.x))
        self.assertIn("two places fit nearly equally well", between.reason)
        self.assert_no_tf("session_map")

        around = self.match(session_map(CORNER, origin=(-14.0, -14.0), size=(280, 280), seen=12.0, wall=is_wall))

        self.assert_pose(around.T_reference_session, CORNER)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, CORNER)

    def test_is_resolved_by_an_operator_among_the_places_that_it_may_be(self):
        session = session_map(START, seen=6.0, wall=is_wall)
        self.match(session, MapMatch.AMBIGUOUS)

        self.suppose(START[0] + 0.4)

        told = self.map_match.wait_for(lambda match: match.status == MapMatch.MATCHED, "a match")
        self.assert_pose(told.T_reference_session, START)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)

    def test_does_not_become_a_room_because_an_operator_says_so(self):
        self.match(session_map(START, seen=6.0, wall=is_wall), MapMatch.AMBIGUOUS)

        self.suppose(LENGTH + 3.0)

        after = self.map_match.wait_for(lambda match: True, "map_match")
        self.assertEqual(after.status, MapMatch.AMBIGUOUS, after.reason)
        self.assert_no_tf("session_map")


if __name__ == "__main__":
    run("corridor", Corridor)
