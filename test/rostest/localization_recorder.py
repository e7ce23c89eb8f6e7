#!/usr/bin/env python3
"""localization_recorder compares tf with the ground truth and writes a record when it ends."""
import json
import os
import signal
import subprocess
import tempfile
import unittest

import roslib.packages
import rospy
from building import reference_map, session_map
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import OccupancyGrid
from node_fixture import DEADLINE, broadcast_static, run, wait_until

from map_matcher.msg import MapMatch

NODE = roslib.packages.find_node("map_matcher", "localization_recorder")[0]
BAD_INPUT = 2
TRUTH = (1.0, 2.0, 0.0)
BESIDE = 0.03  # [m], how far tf is from the truth
POSES = 50  # true poses that are sent
POSE_RATE = 50  # [Hz]


class LocalizationRecorder(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.truth = rospy.Publisher("ground_truth", PoseStamped, queue_size=POSES)
        self.latched = [rospy.Publisher(name, kind, queue_size=1, latch=True) for name, kind in (
            ("map_match", MapMatch), ("session_map", OccupancyGrid), ("reference_map", OccupancyGrid))]

    def tearDown(self):
        for publisher in [self.truth, *self.latched]:
            publisher.unregister()
        self.directory.cleanup()

    def path(self, name):
        return os.path.join(self.directory.name, name)

    def start(self, directory):
        return subprocess.Popen([NODE, "__name:=under_test", "_directory:=" + directory, "_patience:=0.2"])

    def record(self):
        """Lets the node record while true poses are sent, and returns its summary."""
        recorder = self.start(self.directory.name)
        wait_until(lambda: all(publisher.get_num_connections() for publisher in [self.truth, *self.latched]),
                   "the recorder listens")
        rate = rospy.Rate(POSE_RATE)
        pose = PoseStamped()
        pose.pose.position.x, pose.pose.position.y, pose.pose.orientation.w = *TRUTH[:2], 1.0
        for _ in range(POSES):
            pose.header.stamp = rospy.Time.now()
            self.truth.publish(pose)
            rate.sleep()
        recorder.send_signal(signal.SIGINT)
        self.assertEqual(recorder.wait(DEADLINE), 0)
        with open(self.path("summary.json")) as file:
            return json.load(file)

    def test_1_without_tf_the_robot_is_not_localized(self):
        summary = self.record()

        self.assertGreater(summary["samples"], 0)
        self.assertEqual(summary["localized_samples"], 0)
        self.assertIsNone(summary["localized_after"])
        self.assertTrue(os.path.exists(self.path("errors.csv")))
        self.assertFalse(os.path.exists(self.path("overlay.png")))

    def test_2_errors_maps_and_overlay_are_written_at_the_end(self):
        self.broadcaster = broadcast_static("map", "base_link", (TRUTH[0] + BESIDE, TRUTH[1], TRUTH[2]))
        for publisher, message in zip(self.latched, (MapMatch(status=MapMatch.MATCHED, x=12.3, y=7.1, yaw=0.7, ratio=0.9),
                                                     session_map((12.3, 7.1, 0.7)), reference_map())):
            publisher.publish(message)
        summary = self.record()

        self.assertEqual(summary["transform"], {"x": 12.3, "y": 7.1, "yaw": 0.7})
        self.assertEqual(summary["ratio"], 0.9)
        self.assertGreater(summary["localized_samples"], 0)
        self.assertAlmostEqual(summary["translation_error"]["mean"], BESIDE)
        self.assertAlmostEqual(summary["final_error"]["translation"], BESIDE)
        for name in ("errors.csv", "session_map.yaml", "session_map.pgm", "overlay.png"):
            self.assertTrue(os.path.exists(self.path(name)), name)

    def test_3_a_directory_that_does_not_exist_is_refused(self):
        self.assertEqual(self.start(self.path("absent")).wait(DEADLINE), BAD_INPUT)


if __name__ == "__main__":
    run("localization_recorder_test", LocalizationRecorder)
