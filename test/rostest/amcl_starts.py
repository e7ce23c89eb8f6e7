#!/usr/bin/env python3
"""What amcl_starts writes down of answers that are known."""
import csv
import math
import os
import subprocess
import tempfile
import unittest

import roslib.packages
import rospy
import rostest
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from std_srvs.srv import Empty, EmptyResponse

from node_fixture import wait_until
from node_runs import BAD_INPUT, run_node

SPEED = 0.5  # [m/s] along x


def set_planar(pose, x, yaw):
    pose.position.x = x
    pose.orientation.z = math.sin(0.5 * yaw)
    pose.orientation.w = math.cos(0.5 * yaw)


class AmclStarts(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.csv_file = os.path.join(self.directory.name, "amcl.csv")
        self.starts = 0
        self.service = rospy.Service("global_localization", Empty, self.on_start)
        self.addCleanup(self.service.shutdown)
        self.truth = rospy.Publisher("ground_truth", PoseStamped, queue_size=100)
        self.estimates = rospy.Publisher("amcl_pose", PoseWithCovarianceStamped, queue_size=100)

    def on_start(self, _):
        self.starts += 1
        return EmptyResponse()

    def run_node(self, interval):
        node = subprocess.Popen([roslib.packages.find_node("map_matcher", "amcl_starts")[0], "__name:=under_test",
                                 "_csv_file:=" + self.csv_file, "_interval:=%g" % interval])
        self.addCleanup(node.wait)
        self.addCleanup(node.terminate)
        wait_until(lambda: self.truth.get_num_connections() and self.estimates.get_num_connections(), "subscribed")

    def rows(self):
        with open(self.csv_file, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def send_truth(self, stamp, x):
        message = PoseStamped()
        message.header.stamp = stamp
        set_planar(message.pose, x, 3.1)
        self.truth.publish(message)

    def send_estimate(self, stamp, x):
        message = PoseWithCovarianceStamped()
        message.header.stamp = stamp
        set_planar(message.pose.pose, x, -3.1)
        message.pose.covariance[0] = 0.09
        message.pose.covariance[7] = 0.16
        message.pose.covariance[35] = 0.04
        self.estimates.publish(message)

    def test_rows_of_three_starts(self):
        self.run_node(interval=2.0)
        begin = rospy.Time.now() + rospy.Duration(10.0)  # later than any start
        for k in range(5):  # starts at 0, 2 and 4 s
            stamp = begin + rospy.Duration(k)
            self.send_truth(stamp, SPEED * k)
            wait_until(lambda k=k: self.starts == 1 + k // 2, "started")
            rospy.sleep(0.2)  # the answer comes after the truth
            self.send_estimate(stamp + rospy.Duration(0.5), 0.0)  # of no true pose
            self.send_estimate(stamp, SPEED * k + 0.25)
            wait_until(lambda k=k: len(self.rows()) == k + 1, "row %d" % k)

        self.assertEqual([row["session"] for row in self.rows()], ["0", "0", "1", "1", "2"])
        row = {name: float(text) for name, text in self.rows()[3].items()}
        self.assertAlmostEqual(row["session_age"], 1.0, places=6)
        self.assertAlmostEqual(row["travelled"], SPEED, places=6)
        self.assertAlmostEqual(row["estimate_x"], 1.75, places=6)
        self.assertAlmostEqual(row["position_deviation"], 0.5, places=6)
        self.assertAlmostEqual(row["yaw_deviation"], 0.2, places=6)
        self.assertAlmostEqual(row["truth_x"], 1.5, places=6)
        self.assertAlmostEqual(row["translation_error"], 0.25, places=6)
        self.assertAlmostEqual(row["rotation_error"], 2.0 * math.pi - 6.2, places=6)

    def test_answers_from_before_the_start(self):
        self.run_node(interval=30.0)
        early = rospy.Time.now() - rospy.Duration(1.0)
        self.send_truth(early, 0.0)
        wait_until(lambda: self.starts == 1, "started")
        late = rospy.Time.now() + rospy.Duration(10.0)
        self.send_truth(late, 1.0)
        rospy.sleep(0.2)
        self.send_estimate(early, 0.0)
        self.send_estimate(late, 1.0)

        wait_until(self.rows, "a row")
        self.assertEqual([float(row["truth_x"]) for row in self.rows()], [1.0])

    def test_bad_parameters(self):
        for parameters, text in (({"interval": -1.0}, "~interval is -1.0, expected a time above 0 s"),
                                 ({"csv_file": "/nowhere/amcl.csv"}, "~csv_file is '/nowhere/amcl.csv'")):
            status, output = run_node("amcl_starts", **parameters)
            self.assertEqual(status, BAD_INPUT, output)
            self.assertIn(text, output)


if __name__ == "__main__":
    rospy.init_node("amcl_starts_test")
    rostest.rosrun("map_matcher", "amcl_starts", AmclStarts)
