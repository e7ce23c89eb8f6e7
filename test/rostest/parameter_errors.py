#!/usr/bin/env python3
"""A node whose parameters are wrong names each of them and ends with exit code 2; a misspelt one is warned about."""
import unittest

import rospy
import rostest

from node_runs import BAD_INPUT, run_node


class ParameterErrors(unittest.TestCase):
    def test_all_are_told_at_once(self):
        code, output = run_node("map_matcher_node", tf_rate=-1, acceptance_ratio=1.5, tf_mode="both", min_session_cells="many")

        self.assertEqual(code, BAD_INPUT)
        self.assertIn("~tf_rate is -1, expected 0.1 to 1000 Hz", output)
        self.assertIn("~acceptance_ratio is 1.5, expected 0 to 1", output)
        self.assertIn('~tf_mode is "both", expected reference_to_session | session_to_reference | none', output)
        self.assertIn('~min_session_cells is "many", expected a whole number', output)

    def test_a_reference_map_that_is_not_there(self):
        code, output = run_node("map_matcher_node", reference_map_file="/nowhere/map.yaml")

        self.assertEqual(code, BAD_INPUT)
        self.assertIn("/nowhere/map.yaml", output)

    def test_a_misspelt_name_is_warned_about_with_the_one_that_was_meant(self):
        code, output = run_node("map_matcher_node", acceptence_ratio=0.6, tf_rate=-1)  # the latter so that it ends

        self.assertEqual(code, BAD_INPUT)
        self.assertIn("~acceptence_ratio is 0.6, but there is no such parameter; did you mean ~acceptance_ratio?", output)


if __name__ == "__main__":
    rospy.init_node("parameter_errors")
    rostest.rosrun("map_matcher", "parameter_errors", ParameterErrors)
