#!/usr/bin/env python3
"""A crowd_simulator whose parameters are wrong names each of them and ends with exit code 2."""
import unittest

import rospy
import rostest

from node_runs import BAD_INPUT, run_node


class CrowdSimulatorParameters(unittest.TestCase):
    def refuses(self, *complaints, **parameters):
        code, output = run_node("crowd_simulator", **parameters)

        self.assertEqual(code, BAD_INPUT, output)
        for complaint in complaints:
            self.assertIn(complaint, output)

    def test_all_are_told_at_once(self):
        self.refuses("~real_time_factor is -1, expected 0 to 1000", "~density is 5, expected 0 to 3 1/m^2",
                     '~beams is "many", expected a whole number', "~itinerary is \"home\", expected random | explore",
                     real_time_factor=-1, density=5, beams="many", itinerary="home")

    def test_texts_that_are_not_numbers(self):
        self.refuses('~start is "1 2", expected three numbers, x y yaw [m m rad]', start="1 2")
        self.refuses("~waypoints has 3 numbers, expected an x and a y for each place [m]", waypoints="1 2 3")

    def test_a_map_that_is_not_there(self):
        self.refuses("nowhere.yaml' does not exist", map_file="nowhere.yaml")

    def test_places_that_the_robot_cannot_get_to(self):
        self.refuses("start is (-50, 2) m", start="-50 2 0")
        self.refuses("waypoint 1 is (99, 99) m", waypoints="99 99")

    def test_places_to_visit_for_a_robot_that_explores(self):
        self.refuses("there are waypoints, expected none for a robot that explores", waypoints="5 5",
                     itinerary="explore")

    def test_frames_of_the_same_name(self):
        self.refuses('~base_frame is "odom", expected a name that no other frame has', base_frame="odom")

    def test_a_misspelt_one_is_warned_about(self):
        self.refuses("~real_time_facto is 2, but there is no such parameter; did you mean ~real_time_factor?",
                     real_time_facto=2, density=-1.0)  # the latter so that it ends


if __name__ == "__main__":
    rospy.init_node("crowd_simulator_parameters")
    rostest.rosrun("map_matcher", "crowd_simulator_parameters", CrowdSimulatorParameters)
