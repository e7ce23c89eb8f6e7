#!/usr/bin/env python3
"""A session_mapper whose parameters are wrong names each of them and ends with exit code 2."""
import unittest

import rospy
import rostest

from node_runs import BAD_INPUT, run_node


class SessionMapperParameters(unittest.TestCase):
    def test_all_are_told_at_once(self):
        code, output = run_node("session_mapper", delta=-0.05, occ_thresh=2, linearUpdate="far")

        self.assertEqual(code, BAD_INPUT)
        self.assertIn("~delta is -0.05, expected 0.001 to 1 m", output)
        self.assertIn("~occ_thresh is 2, expected 0 to 1", output)
        self.assertIn('~linearUpdate is "far", expected', output)

    def test_values_that_contradict_each_other(self):
        code, output = run_node("session_mapper", xmin=5.0, xmax=-5.0, maxUrange=20.0, maxRange=10.0)

        self.assertEqual(code, BAD_INPUT)
        self.assertIn("xmin is 5, expected less than xmax = -5 m", output)
        self.assertIn("maxUrange is 20, expected at most maxRange = 10 m", output)

    def test_equal_frames(self):
        code, output = run_node("session_mapper", map_frame="odom")

        self.assertEqual(code, BAD_INPUT)
        self.assertIn('~map_frame is "odom", expected a name other than ~odom_frame', output)

    def test_a_parameter_of_slam_gmapping_that_it_does_not_have_is_warned_about(self):
        code, output = run_node("session_mapper", particles=30, delta=-1.0)  # the latter so that it ends

        self.assertEqual(code, BAD_INPUT)
        self.assertIn("~particles is 30, but there is no such parameter", output)


if __name__ == "__main__":
    rospy.init_node("session_mapper_parameters")
    rostest.rosrun("map_matcher", "session_mapper_parameters", SessionMapperParameters)
