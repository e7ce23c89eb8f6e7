#!/usr/bin/env python3
"""A mapper that begins anew in the same frame: the alignment of its last session is off tf as soon as its first map is
there, before that is matched, and the new one is broadcast at once when it is found."""
import random
import time

import rospy
from diagnostic_msgs.msg import DiagnosticStatus
from nav_msgs.msg import OccupancyGrid

from building import FREE, OCCUPIED, grid, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import QUIET, Listener, NodeFixture, run, wait_for_diagnostic, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session
AFTERWARDS = (9.1, 8.0, -2.4)
TOLERANCE = 0.1  # [s], transforms are stamped ahead by this (~transform_tolerance)


def first_map():
    """What a mapper draws first: few cells. They fit nowhere, which takes the search long."""
    noise = random.Random(1)
    return grid("session_map", (-3.0, -3.0), (60, 60), lambda x, y: OCCUPIED if noise.random() < 0.15 else FREE)


class MapperRestarted(NodeFixture):
    def setUp(self):
        super().setUp()
        self.second = rospy.Publisher("second_mapper_map", OccupancyGrid, queue_size=10)
        self.arrived = Listener("session_map", OccupancyGrid)
        wait_until(lambda: self.second.get_num_connections() == 1, "the second mapper listens")
        self.arrived.wait_until_served()
        self.reference.publish(reference_map())

    def tearDown(self):
        self.second.unregister()
        super().tearDown()

    def stamps_on_tf(self):
        return [t.header.stamp for tf in self.tf.messages for t in tf.transforms if t.child_frame_id == "session_map"]

    def assert_begins_anew(self, mapper):
        """`mapper` publishes the first maps of a new session while the node is localized."""
        self.wait_for_tf("map", "session_map")
        first = first_map()
        first.header.stamp = rospy.Time.now()

        mapper.publish(first)

        answer = self.map_match.wait_for(lambda match: match.session_stamp == first.header.stamp, "map_match")
        self.assertNotEqual(answer.status, MapMatch.MATCHED)
        time.sleep(QUIET)  # what is still on its way arrives
        last = max(self.stamps_on_tf()) - rospy.Duration(TOLERANCE)
        begin_of_search = answer.header.stamp - rospy.Duration(answer.search_time)
        self.assertLess(last, begin_of_search, "the old alignment was sent until the answer was there")
        wait_for_diagnostic("map_matcher: alignment",
                            lambda s: s.level == DiagnosticStatus.WARN and "new session" in s.message)

        second = session_map(AFTERWARDS)
        second.header.stamp = rospy.Time.now()
        mapper.publish(second)

        match = self.map_match.wait_for(lambda m: m.session_stamp == second.header.stamp, "map_match")
        self.assertEqual(match.status_text, "matched", match.reason)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, AFTERWARDS)

    def test_1_with_far_fewer_cells(self):
        self.match(session_map(START))
        self.assert_begins_anew(self.session)

    def test_2_as_another_node(self):
        self.match(first_map(), MapMatch.BELOW_ACCEPTANCE_RATIO)  # the last test's session ends
        self.match(session_map(START))
        self.assert_begins_anew(self.second)


if __name__ == "__main__":
    run("mapper_restarted", MapperRestarted)
