#!/usr/bin/env python3
"""The test for other people's robots, launch/localized.test, passes for a good drive and fails for others, and says why."""
import os
import subprocess
import tempfile
import unittest

import rospy
import rostest

from node_runs import run_tool

DRIVE = ["--seed", "3", "--duration", "20", "--rate", "10", "--beams", "271"]
DEADLINE = 90.0  # [s]


class LocalizedInBag(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.map, cls.other_map, cls.bag = (os.path.join(directory.name, name)
                                           for name in ("building.yaml", "other.yaml", "drive.bag"))
        run_tool("generate_building", "--output", cls.map, "--seed", "1", "--resolution", "0.05")
        run_tool("generate_building", "--output", cls.other_map, "--seed", "2", "--resolution", "0.05")
        run_tool("simulate_drive", "--map", cls.map, "--bag", cls.bag, *DRIVE)

    def rostest(self, **arguments):
        """Exit code and output of a rostest with a roscore of its own."""
        words = ["rostest", "map_matcher", "localized.test", "bag:=" + self.bag, "rate:=4",
                 *("%s:=%s" % item for item in arguments.items())]
        done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=DEADLINE, check=False,
                              universal_newlines=True)
        lines = done.stdout.replace("\r", "\n").split("\n")
        return done.returncode, "\n".join(line for line in lines if "Bag Time:" not in line)

    def test_passes_where_the_robot_is_found(self):
        status, output = self.rostest(map=self.map)

        self.assertEqual(0, status, output)
        self.assertIn("test_is_never_elsewhere][passed]", output)

    def test_fails_in_the_map_of_another_building(self):
        status, output = self.rostest(map=self.other_map)

        self.assertNotEqual(0, status, output)
        self.assertIn("the robot was not found in 20", output)

    def test_fails_for_poses_that_are_off(self):
        status, output = self.rostest(map=self.map, error="0.000001")

        self.assertNotEqual(0, status, output)
        self.assertIn("poses are off, expected at most 1e-06 m", output)

    def test_names_a_limit_that_is_none(self):
        status, output = self.rostest(map=self.map, within=-1)

        self.assertNotEqual(0, status, output)
        self.assertIn("~within is -1, expected a number of at least 0", output)


if __name__ == "__main__":
    rospy.init_node("localized_in_bag")
    rostest.rosrun("map_matcher", "localized_in_bag", LocalizedInBag)
