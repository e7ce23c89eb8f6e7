#!/usr/bin/env python3
"""global_localization and ~reset make the node forget what it believes and find the robot anew."""
import rospy
from std_srvs.srv import Empty

from building import FREE, OCCUPIED, grid, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import DEADLINE, NodeFixture, run

START = (12.3, 7.1, 0.7)  # T_reference_session
ELSEWHERE = (9.1, 8.0, -2.4)


def of_another_building():
    """Pillars, 0.6 m apart."""
    return grid("session_map", (-4.0, -4.0), (160, 160),
                lambda x, y: OCCUPIED if round(10 * x) % 6 == 0 and round(10 * y) % 6 == 0 else FREE)


class Forget(NodeFixture):
    node_has_reference = False

    def setUp(self):
        super().setUp()
        if not Forget.node_has_reference:  # a second one might come after the first session map, and make it forgotten
            self.reference.publish(reference_map())
            Forget.node_has_reference = True

    def call(self, name):
        rospy.wait_for_service(name, DEADLINE)
        rospy.ServiceProxy(name, Empty)()

    def localize(self):
        """At START, wherever the test before has left the session: a second map confirms it."""
        first = session_map(START, seen=7.9)
        first.header.stamp = rospy.Time.now()
        self.session.publish(first)
        self.map_match.wait_for(lambda match: match.session_stamp == first.header.stamp, "an answer")
        self.match(session_map(START))

    def forgets_what_was_believed(self, service):
        self.localize()
        self.wait_for_tf("map", "session_map")
        self.match(of_another_building(), MapMatch.BELOW_ACCEPTANCE_RATIO)
        self.wait_for_tf("map", "session_map")  # the old alignment is kept
        self.map_match.clear()

        self.call(service)

        self.assertEqual(self.map_match.wait_for(lambda _: True, "an answer about the map at hand").status,
                         MapMatch.BELOW_ACCEPTANCE_RATIO)
        self.assert_no_tf("session_map")
        self.log.wait_for(lambda line: service + " was called" in line.msg, "a line of what was asked for")

    def test_global_localization_takes_the_alignment_off_tf(self):
        self.forgets_what_was_believed("/global_localization")

    def test_reset_takes_the_alignment_off_tf(self):
        self.forgets_what_was_believed("/map_matcher/reset")

    def test_finds_the_robot_at_once_from_the_map_at_hand(self):
        match = self.match(session_map(START))
        self.map_match.clear()

        self.call("/global_localization")

        again = self.map_match.wait_for(lambda m: m.status == MapMatch.MATCHED, "a match of the map at hand")
        self.assertEqual(again.session_stamp, match.session_stamp)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)

    def test_leaves_nothing_that_a_place_elsewhere_has_to_stand_up_to(self):
        self.match(session_map(START))
        self.match(session_map(ELSEWHERE), MapMatch.UNCONFIRMED)
        self.map_match.clear()

        self.call("/global_localization")

        self.map_match.wait_for(lambda m: m.status == MapMatch.MATCHED, "a match of the map at hand")
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, ELSEWHERE)

    def test_before_there_is_a_session_map_is_no_mistake(self):
        self.call("/global_localization")
        self.call("/map_matcher/reset")
        self.match(session_map(START))


if __name__ == "__main__":
    run("forget", Forget)
