#!/usr/bin/env python3
"""Maps are matched when a caller asks for it, with parameters and priors of the caller's own."""
import math

import rospy
from std_srvs.srv import Trigger

from building import reference_map, session_map
from map_matcher.msg import MapMatch
from map_matcher.srv import MatchToReference, MatchToReferenceRequest
from node_fixture import DEADLINE, NodeFixture, run

START = (12.3, 7.1, 0.7)  # T_reference_session


class Services(NodeFixture):
    def setUp(self):
        super().setUp()
        self.match_to_reference = self.service("match_to_reference", MatchToReference)
        self.match_now = self.service("map_matcher/match_now", Trigger)

    @staticmethod
    def service(name, kind):
        rospy.wait_for_service(name, DEADLINE)
        return rospy.ServiceProxy(name, kind)

    def ask(self, **fields):
        return self.match_to_reference(MatchToReferenceRequest(session_map=session_map(START), **fields)).match

    def test_1_say_what_is_missing(self):
        self.assertEqual(self.ask().status, MapMatch.NO_REFERENCE)
        answer = self.match_now()
        self.assertFalse(answer.success)
        self.assertEqual(answer.message, "there is no session map yet")

    def test_2_match_a_given_map_without_broadcasting_it(self):
        self.give_reference()

        match = self.ask()

        self.assertEqual(match.status, MapMatch.MATCHED)
        self.assertEqual((match.reference_frame, match.session_frame), ("map", "session_map"))
        self.assert_pose(match.T_reference_session, START)
        self.assertFalse(self.map_match.messages)
        self.assert_no_tf("session_map")

    def test_3_take_parameters_instead_of_the_nodes(self):
        self.give_reference()

        strict = self.ask(acceptance_ratio=0.999)
        self.assertEqual(strict.status, MapMatch.BELOW_ACCEPTANCE_RATIO, strict.reason)
        self.assertEqual(self.ask(hits_sample_threshold=150).total_cells, 150)
        finer, coarser = self.ask(rotation_downsampling=1.0), self.ask(rotation_downsampling=4.0)
        self.assertGreater(finer.stages[0].rotations, 3 * coarser.stages[0].rotations)
        self.assertEqual(self.ask(acceptance_ratio=float("nan")).status, MapMatch.MATCHED)

    def test_4_refuse_values_out_of_range(self):
        self.give_reference()

        match = self.ask(acceptance_ratio=1.5, rotation_downsampling=-1.0)

        self.assertEqual(match.status, MapMatch.INVALID_REQUEST)
        self.assertIn("acceptance_ratio is 1.5, expected 0 to 1", match.reason)
        self.assertIn("rotation_downsampling is -1, expected", match.reason)
        match = self.ask(use_heading_prior=True, heading=float("inf"))
        self.assertEqual(match.status, MapMatch.INVALID_REQUEST)
        self.assertIn("heading is inf", match.reason)

    def test_5_search_where_the_priors_say(self):
        self.give_reference()
        there = {"use_heading_prior": True, "heading": START[2], "heading_half_width": 0.2,
                 "use_window_prior": True, "window_centre_x": START[0], "window_centre_y": START[1],
                 "window_half_size_x": 1.0, "window_half_size_y": 1.0}
        elsewhere = {**there, "heading": START[2] + math.pi / 2, "window_centre_x": START[0] + 5.0}

        match = self.ask(**there)
        self.assertEqual(match.status, MapMatch.MATCHED, match.reason)
        self.assert_pose(match.T_reference_session, START)
        self.assertLess(self.ask(**there).stages[0].rotations, self.ask().stages[0].rotations / 5)
        self.assertNotEqual(self.ask(**elsewhere, acceptance_ratio=0.8).status, MapMatch.MATCHED)

    def test_6_report_a_bad_map_to_the_caller(self):
        self.give_reference()
        bad = session_map(START)
        bad.data = []

        match = self.match_to_reference(MatchToReferenceRequest(session_map=bad)).match

        self.assertEqual(match.status, MapMatch.INVALID_MAP)
        self.assertIn("0 values", match.reason)

    def test_7_match_the_last_session_map_again(self):
        self.give_reference()
        first = self.match(session_map(START))
        self.map_match.clear()

        answer = self.match_now()

        self.assertTrue(answer.success, answer.message)
        self.assertTrue(answer.message.startswith("matched: "), answer.message)
        again = self.map_match.wait_for(lambda match: match.header.stamp > first.header.stamp, "second map_match")
        self.assertEqual(again.session_stamp, first.session_stamp)

    def give_reference(self):
        """Publishes the reference map, latched, and waits until the node uses it."""
        self.reference.publish(reference_map())
        self.log.wait_for(lambda line: line.msg.startswith("reference map: 240 x 160"), "reference map")


if __name__ == "__main__":
    run("services", Services)
