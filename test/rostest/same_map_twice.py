#!/usr/bin/env python3
"""A session map does not bear witness for itself: one at odds with the alignment changes nothing, however often it is
published or asked for, until a map with other cells lies there, too."""
import rospy
from std_srvs.srv import Trigger

from building import reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import DEADLINE, NodeFixture, is_between, run

START = (12.3, 7.1, -2.4)  # T_reference_session
ELSEWHERE = (9.1, 8.0, 0.6)
TIMES = 20  # that the map is published, 10 times a second
TRANSFORMS = 2  # of the node between two of them, at 20 Hz


class SameMapTwice(NodeFixture):
    def setUp(self):
        super().setUp()
        rospy.wait_for_service("map_matcher/match_now", DEADLINE)
        self.match_now = rospy.ServiceProxy("map_matcher/match_now", Trigger)
        self.reference.publish(reference_map())
        self.match(session_map(START))

    def assert_alignment_stays(self):
        """The next transforms of the node are those of the first alignment."""
        for _ in range(TRANSFORMS):
            self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)
        self.assertFalse([m for m in self.map_match.messages if m.status == MapMatch.MATCHED and m.x < 11.0])

    def test_confirms_nothing(self):
        contradicting = session_map(ELSEWHERE)
        self.match(contradicting, MapMatch.UNCONFIRMED)

        for _ in range(TIMES):
            self.session.publish(contradicting)
            self.assert_alignment_stays()
        for _ in range(3):
            self.assertFalse(self.match_now().success)
            self.assert_alignment_stays()
        contradicting.header.stamp = rospy.Time.now()  # stamped anew, but with the same cells
        self.session.publish(contradicting)
        self.map_match.wait_for(lambda match: match.session_stamp == contradicting.header.stamp, "map_match")
        self.assert_alignment_stays()

        other_cells = self.match(session_map(ELSEWHERE, seen=8.5))

        self.assert_pose(other_cells.T_reference_session, ELSEWHERE)
        self.tf.clear()
        self.tf.wait_for(lambda tf: any(is_between(t, "map", "session_map") and t.transform.translation.x < 11.0
                                        for t in tf.transforms), "the new alignment on tf")


if __name__ == "__main__":
    run("same_map_twice", SameMapTwice)
