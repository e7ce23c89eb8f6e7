#!/usr/bin/env python3
"""Whoever subscribes after a match learns of it: results are latched."""
import geometry_msgs.msg
import rospy
from nav_msgs.msg import OccupancyGrid
from visualization_msgs.msg import Marker

from building import RESOLUTION, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import Listener, NodeFixture, broadcast_static, run

START = (12.3, 7.1, 0.7)  # T_reference_session
ROBOT = (0.4, -0.3, 0.2)  # T_session_base


class LateSubscriber(NodeFixture):
    def test_receives_the_match_the_pose_the_overlay_and_the_reference_map(self):
        self.static_broadcaster = broadcast_static("session_map", "base_link", ROBOT)
        self.reference.publish(reference_map())
        pose_while_there = Listener("match_pose", geometry_msgs.msg.PoseWithCovarianceStamped)
        match = self.match(session_map(START))
        pose_while_there.wait_for(lambda pose: True, "match_pose")

        self.assertEqual(self.late("map_match", MapMatch), match)
        self.assertEqual(self.late("match_pose", geometry_msgs.msg.PoseWithCovarianceStamped).header.frame_id, "map")
        self.assertEqual(self.late("map_matcher/reference_map", OccupancyGrid).data, tuple(reference_map().data))
        self.assert_overlay(match)

    def assert_overlay(self, match):
        matched = self.late("matched_cells", Marker)
        self.assertEqual(matched.header.frame_id, "session_map")
        self.assertEqual((matched.color.r, matched.color.g, matched.color.b), (1.0, 0.0, 0.0))
        self.assertAlmostEqual(matched.scale.x, RESOLUTION)
        self.assertGreater(len(matched.points), 0.8 * match.total_cells)
        unmatched = self.late("unmatched_cells", Marker)
        self.assertNotEqual(unmatched.color, matched.color)
        self.assertEqual(len(matched.points) + len(unmatched.points), match.total_cells)

    def late(self, topic, kind):
        """The first message that a subscriber gets who comes now."""
        return rospy.wait_for_message(topic, kind, timeout=10.0)


if __name__ == "__main__":
    run("late_subscriber", LateSubscriber)
