#!/usr/bin/env python3
"""Two lasers among people, replayed as open_lab_replay.launch does it: the mapper begins anew again and again, each start
is written down, none is in a wrong place, and they are drawn."""
import csv
import os
import subprocess
import tempfile
import unittest

import roslib.packages
import rospy
import rostest

from node_runs import run_launch

DRIVE = ["--seed", "3", "--duration", "45", "--rate", "10", "--beams", "271", "--robot", "pepper", "--people", "4"]
PERIOD, PATIENCE = 14.0, 10.0  # [s]
REPLAY_RATE = 2.0  # times faster than driven
REPLAY_DEADLINE = 60.0  # [s]
LARGEST_ERROR = 0.5  # [m]


def run_tool(name, *arguments):
    subprocess.run([roslib.packages.find_node("map_matcher", name)[0], *arguments], check=True)


class OpenLabReplay(unittest.TestCase):
    def test_writes_down_each_start_and_draws_them(self):
        with tempfile.TemporaryDirectory() as directory:
            building, bag, starts, figure = (os.path.join(directory, name) for name in (
                "building.yaml", "drive.bag", "starts.csv", "starts.png"))
            run_tool("generate_building", "--output", building, "--seed", "1", "--resolution", "0.05")
            run_tool("simulate_drive", "--map", building, "--bag", bag, *DRIVE)

            run_launch("open_lab_replay.launch", REPLAY_DEADLINE, "map:=" + building, "bag:=" + bag, "starts:=" + starts,
                       "rear_scan:=sick_laser_rear/scan", "rate:=%g" % REPLAY_RATE, "period:=%g" % PERIOD,
                       "patience:=%g" % PATIENCE,
                       "detections:=[dr_spaam_detections/front, dr_spaam_detections/rear]")

            with open(starts, newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual([row["start"] for row in rows], [str(number) for number in range(len(rows))])
            self.assertGreaterEqual(len(rows), 3, "45 s have three starts, and a fourth that is cut short")
            found = [row for row in rows if row["localized"] == "1"]
            self.assertTrue(found, rows)
            for row in rows:
                self.assertTrue(row["truth_x"], "the truth is known all the time")
                self.assertNotEqual(row["status"], "no_map", "both lasers are drawn after each start")
            for row in found:
                self.assertLess(float(row["translation_error"]), LARGEST_ERROR)
                self.assertLessEqual(float(row["after"]), PATIENCE)

            run_tool("plot_cold_starts", starts, "--map", building, "--output", figure)
            self.assertGreater(os.path.getsize(figure), 10000)


if __name__ == "__main__":
    rospy.init_node("open_lab_replay")
    rostest.rosrun("map_matcher", "open_lab_replay", OpenLabReplay)
