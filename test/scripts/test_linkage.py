#!/usr/bin/env python3
"""What a robot loads: the nodes that run on one, and the nodelet in a lidar driver's process, need little."""

import os
import subprocess
import unittest
from pathlib import Path

# Only what evaluates, simulates or draws session maps may link to these.
NEEDLESS = ("mrpt", "rosbag", "_bags", "_evaluation", "_simulation", "_trials", "_mapping")
ON_A_ROBOT = ("map_matcher/map_matcher_node", "map_matcher/lidar_scrubber", "liblidar_scrubber_nodelet.so",
             "map_matcher/scan_merger", "libscan_merger_nodelet.so")


def libraries_of(path):
    """All libraries that are loaded with the program or library, those that others need included."""
    done = subprocess.run(["ldd", path], stdout=subprocess.PIPE, text=True, check=True)
    return [line.split()[0] for line in done.stdout.splitlines()]


class Linkage(unittest.TestCase):
    def setUp(self):
        build = os.environ.get("MAP_MATCHER_BUILD")
        if not build:
            self.skipTest("needs MAP_MATCHER_BUILD, a directory that scripts/build has filled")
        self.libraries = Path(build) / "devel/lib"

    def test_robots_load_neither_mrpt_nor_what_evaluates(self):
        for program in ON_A_ROBOT:
            with self.subTest(program):
                libraries = libraries_of(self.libraries / program)
                self.assertTrue(any("map_matcher_core" in library for library in libraries), libraries)
                self.assertEqual([], [library for library in libraries if any(word in library for word in NEEDLESS)])

    def test_session_mapper_loads_no_mrpt(self):
        libraries = libraries_of(self.libraries / "map_matcher/session_mapper")
        self.assertTrue(any("map_matcher_mapping" in library for library in libraries), libraries)
        self.assertEqual([], [library for library in libraries if "mrpt" in library])
