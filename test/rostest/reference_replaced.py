#!/usr/bin/env python3
"""A new reference map replaces the old one at once: the last session map is matched to it, no other one is needed."""
from building import reference_map, session_map
from map_matcher.srv import SetReferenceMap
from node_fixture import DEADLINE, NodeFixture, run
import rospy

START = (12.3, 7.1, 0.7)  # T_reference_session
SHIFT = (5.0, -3.0)  # of the second reference map's building [m]
SHIFTED = (START[0] + SHIFT[0], START[1] + SHIFT[1], START[2])


class ReferenceReplaced(NodeFixture):
    def setUp(self):
        super().setUp()
        self.reference.publish(reference_map())
        first = self.match(session_map(START), reference_frame="map")  # the node may still have another test's map
        self.assert_pose(first.T_reference_session, START)
        self.map_match.clear()

    def assert_replaced(self):
        match = self.map_match.wait_for(lambda match: match.reference_frame == "other_map", "match in the other map")
        self.assertEqual(match.status_text, "matched")
        self.assert_pose(match.T_reference_session, SHIFTED)
        self.assert_pose(self.wait_for_tf("other_map", "session_map").transform, SHIFTED)
        self.tf.clear()
        for _ in range(3):
            transforms = self.tf.wait_for(lambda tf: True, "tf").transforms
            self.assertFalse([t for t in transforms if t.header.frame_id == "map"])

    def test_by_topic(self):
        self.reference.publish(reference_map("other_map", SHIFT))
        self.assert_replaced()

    def test_by_service(self):
        rospy.wait_for_service("set_reference_map", DEADLINE)
        set_reference_map = rospy.ServiceProxy("set_reference_map", SetReferenceMap)

        answer = set_reference_map(reference_map("other_map", SHIFT))

        self.assertTrue(answer.accepted)
        self.assertIn("240 x 160", answer.message)
        self.assert_replaced()

    def test_not_by_a_bad_map(self):
        rospy.wait_for_service("set_reference_map", DEADLINE)
        set_reference_map = rospy.ServiceProxy("set_reference_map", SetReferenceMap)
        bad = reference_map("other_map")
        bad.data = bad.data[:10]

        answer = set_reference_map(bad)

        self.assertFalse(answer.accepted)
        self.assertIn("10 values, expected width x height = 240 x 160", answer.message)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)


if __name__ == "__main__":
    run("reference_replaced", ReferenceReplaced)
