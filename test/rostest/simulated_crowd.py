#!/usr/bin/env python3
"""Everything of simulated_crowd.launch together: the robot finds itself among people, who are scrubbed."""
import math
import os
import tempfile
import unittest

import geometry_msgs.msg
import rospy
import rostest
import tf2_ros
from sensor_msgs.msg import LaserScan

from map_matcher.msg import MapMatch
from node_fixture import Listener
from node_runs import run_launch
from pose_errors import position_errors

DEADLINE = 120.0  # [s], for the drive to end
LAUNCH = ["building_seed:=1", "seed:=3", "density:=0.15", "duration:=40", "real_time_factor:=3", "scrub:=true",
          "rviz:=false", "end_with_drive:=true"]
SIMULATOR = "{beams: 271, rate: 10.0}"
WORST_ERROR = 0.3  # [m], of the robot's pose on tf


class SimulatedCrowd(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.config = os.path.join(self.directory.name, "simulator.yaml")
        with open(self.config, "w", encoding="utf-8") as file:
            file.write(SIMULATOR)

    def tearDown(self):
        self.directory.cleanup()

    def test_the_robot_finds_itself(self):
        buffer = tf2_ros.Buffer(rospy.Duration(300))
        tf2_ros.TransformListener(buffer)
        truth = Listener("/ground_truth", geometry_msgs.msg.PoseStamped)
        matches = Listener("/map_match", MapMatch)
        raw = Listener("/scan", LaserScan)
        scrubbed = Listener("/scan_scrubbed", LaserScan)
        run_launch("simulated_crowd.launch", DEADLINE, *LAUNCH, "simulator_config:=" + self.config)

        self.assertIn(MapMatch.MATCHED, {match.status for match in matches.messages})
        errors = position_errors(buffer, truth.messages)
        print("%d of %d poses compared: mean %.3f m, worst %.3f m" % (
            len(errors), len(truth.messages), sum(errors) / len(errors), max(errors)))
        self.assertGreater(len(errors), 0.5 * len(truth.messages))
        self.assertLess(max(errors), WORST_ERROR)
        self.people_are_scrubbed(raw.messages, scrubbed.messages)

    def people_are_scrubbed(self, raw, scrubbed):
        by_stamp = {scan.header.stamp: scan for scan in raw}
        removed = [sum(map(math.isinf, scan.ranges)) - sum(map(math.isinf, by_stamp[scan.header.stamp].ranges))
                   for scan in scrubbed if scan.header.stamp in by_stamp]
        self.assertGreater(len(removed), 100)
        self.assertGreater(sum(removed), 100)
        self.assertGreaterEqual(min(removed), 0)


if __name__ == "__main__":
    rospy.init_node("simulated_crowd_test")
    rostest.rosrun("map_matcher", "simulated_crowd", SimulatedCrowd)
