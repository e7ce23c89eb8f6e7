#!/usr/bin/env python3
"""A simulated drive, replayed as replay.launch does it: the robot's pose through tf agrees with the ground truth."""
import os
import tempfile
import unittest

import geometry_msgs.msg
import rospy
import rostest
import tf2_ros

from map_matcher.msg import MapMatch
from node_fixture import Listener
from node_runs import run_launch, run_tool
from pose_errors import position_errors

DRIVE = ["--seed", "3", "--duration", "45", "--rate", "10", "--beams", "271"]
REPLAY_RATE = 4.0  # times faster than driven
REPLAY_DEADLINE = 60.0  # [s]
MIN_COMPARED = 0.7  # share of the ground truth that there is to be a pose for
MEAN_ERROR = 0.12  # [m]
WORST_ERROR = 0.4  # [m]


class ReplaySimulated(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.map = os.path.join(self.directory.name, "building.yaml")
        self.bag = os.path.join(self.directory.name, "drive.bag")
        run_tool("generate_building", "--output", self.map, "--seed", "1", "--resolution", "0.05")
        run_tool("simulate_drive", "--map", self.map, "--bag", self.bag, *DRIVE)

    def tearDown(self):
        self.directory.cleanup()

    def test_localizes_the_robot(self):
        buffer = tf2_ros.Buffer(rospy.Duration(300))
        tf2_ros.TransformListener(buffer)
        truth = Listener("/ground_truth", geometry_msgs.msg.PoseStamped)
        matches = Listener("/map_match", MapMatch)
        run_launch("replay.launch", REPLAY_DEADLINE, "map:=" + self.map, "bag:=" + self.bag, "rate:=%g" % REPLAY_RATE,
                   "rviz:=false", "end_with_bag:=true")

        statuses = [match.status_text for match in matches.messages]
        first = statuses.index("matched")
        self.assertLessEqual(set(statuses[:first]), {"doubtful"}, "a short map may be too little to be sure")
        self.assertEqual(set(statuses[first:]), {"matched"})
        errors = position_errors(buffer, truth.messages)
        self.assertGreater(len(errors), MIN_COMPARED * len(truth.messages))
        print("localized %.1f s after the start; %d of %d poses compared: mean %.3f m, worst %.3f m" % (
            (matches.messages[0].header.stamp - truth.messages[0].header.stamp).to_sec(), len(errors),
            len(truth.messages), sum(errors) / len(errors), max(errors)))
        self.assertLess(sum(errors) / len(errors), MEAN_ERROR)
        self.assertLess(max(errors), WORST_ERROR)


if __name__ == "__main__":
    rospy.init_node("replay_simulated")
    rostest.rosrun("map_matcher", "replay_simulated", ReplaySimulated)
