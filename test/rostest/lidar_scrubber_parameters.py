#!/usr/bin/env python3
"""A lidar_scrubber whose parameters are wrong names each of them and ends with exit code 2."""
import unittest

import rospy
import rostest

from node_runs import BAD_INPUT, run_node


class LidarScrubberParameters(unittest.TestCase):
    def test_all_are_told_at_once(self):
        code, output = run_node("lidar_scrubber", removal_radius=-0.3, mode="sometimes", removed_range="zero",
                                detection_topics="dr_spaam_detections")

        self.assertEqual(code, BAD_INPUT)
        self.assertIn("~removal_radius is -0.3, expected 0.01 to 5 m", output)
        self.assertIn('~mode is "sometimes", expected cached | synchronised', output)
        self.assertIn('~removed_range is "zero", expected inf | nan | over_range', output)
        self.assertIn('~detection_topics is "dr_spaam_detections", expected a list of texts', output)

    def test_values_that_contradict_each_other(self):
        code, output = run_node("lidar_scrubber", silence_warning=5.0, silence_error=1.0)

        self.assertEqual(code, BAD_INPUT)
        self.assertIn("~silence_error is 1", output)
        self.assertIn("expected at least ~silence_warning = 5", output)

    def test_no_detector_at_all(self):
        rospy.set_param("/under_test/detection_topics", [])  # the command line knows no lists

        code, output = run_node("lidar_scrubber")

        self.assertEqual(code, BAD_INPUT)
        self.assertIn("~detection_topics holds 0 names, expected one or more", output)


if __name__ == "__main__":
    rospy.init_node("lidar_scrubber_parameters")
    rostest.rosrun("map_matcher", "lidar_scrubber_parameters", LidarScrubberParameters)
