#!/usr/bin/env python3
"""The pose_evaluator node compares tf with the true poses, and plot_run draws what it wrote down."""
import csv
import json
import os
import signal
import subprocess
import tempfile
import unittest

import roslib.packages
import rospkg
import rospy
import rosgraph_msgs.msg
import tf2_msgs.msg
from geometry_msgs.msg import PoseStamped

from map_matcher.msg import MapMatch
from node_fixture import DEADLINE, run, stamped_transform, wait_until

NODE = roslib.packages.find_node("map_matcher", "pose_evaluator")[0]
PLOT_RUN = os.path.join(rospkg.RosPack().get_path("map_matcher"), "scripts", "plot_run")
BAD_INPUT = 2
PNG_HEADER = b"\x89PNG"
ALIGNMENT = (10.0, 5.0, 0.0)  # T_map_session
OFFSET = 0.3  # [m] by which the robot is farther along y than tf has it


class PoseEvaluator(unittest.TestCase):
    def setUp(self):
        self.clock = rospy.Publisher("/clock", rosgraph_msgs.msg.Clock, queue_size=100)
        self.tf = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=100)
        self.truth = rospy.Publisher("ground_truth", PoseStamped, queue_size=100)
        self.match = rospy.Publisher("map_match", MapMatch, queue_size=1, latch=True)
        self.directory = tempfile.TemporaryDirectory()
        self.csv_file = os.path.join(self.directory.name, "run.csv")
        self.summary_file = os.path.join(self.directory.name, "run.json")
        self.node = subprocess.Popen(
            [NODE, "__name:=under_test", "_csv_file:=" + self.csv_file, "_summary_file:=" + self.summary_file,
             "_truth_frame:=truth_map"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        wait_until(lambda: self.clock.get_num_connections() > 1, "the node and this test listen to /clock")
        wait_until(lambda: all(publisher.get_num_connections() > 0 for publisher in (self.tf, self.truth, self.match)),
                   "the node subscribes")

    def tearDown(self):
        if self.node.poll() is None:
            self.node.send_signal(signal.SIGINT)
            self.node.wait()
        self.node.stdout.close()
        self.directory.cleanup()
        wait_until(lambda: all(publisher.get_num_connections() == 0 for publisher in (self.tf, self.truth, self.match)),
                   "the node is gone")

    def test_writes_down_draws_and_sums_up_a_run(self):
        self.send_truth(100.0, 0.0)  # before there is any transform
        self.run_until_rows(1, 101.0)
        self.assertEqual(self.rows()[0]["estimate_x"], "")

        self.match.publish(MapMatch(status=MapMatch.MATCHED, ratio=0.8))
        for i in range(5):
            self.send_transforms(102.0 + i, float(i))
            self.send_truth(102.0 + i, float(i))
            self.run_until_rows(2 + i, 102.0 + i)
        self.send_truth(107.0, 0.0, frame="elsewhere")  # is not taken

        row = self.rows()[-1]
        self.assertAlmostEqual(float(row["time"]), 106.0)
        self.assertAlmostEqual(float(row["estimate_x"]), 14.0)
        self.assertAlmostEqual(float(row["translation_error"]), OFFSET)
        self.assertAlmostEqual(float(row["session_x"]), ALIGNMENT[0])
        self.assertAlmostEqual(float(row["ratio"]), 0.8)
        self.assert_summary()
        self.assert_plot()

    def test_ends_in_order_when_it_is_terminated(self):
        self.send_truth(100.0, 0.0)
        self.run_until_rows(1, 101.0)

        output = self.end_node(signal.SIGTERM)

        self.assertIn("pose known in 0 of 1 moments", output)
        with open(self.csv_file, newline="", encoding="utf-8") as file:
            self.assertEqual(len(list(csv.DictReader(file))), 1)
        with open(self.summary_file, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["samples"], 1)

    def test_begins_anew_when_time_goes_back(self):
        self.send_transforms(100.0, 0.0)
        self.send_truth(100.0, 0.0)
        self.run_until_rows(1, 100.0)

        times = iter(range(10**6))

        def begins_anew():
            self.set_time(50.0 + 0.01 * next(times))
            try:
                return not self.rows()
            except FileNotFoundError:  # the run before has its name, this one has no file yet
                return False
        wait_until(begins_anew, "an empty run")

    def assert_summary(self):
        output = self.end_node()
        self.assertIn("pose known in 5 of 6 moments, first after 2 s", output)
        with open(self.summary_file, encoding="utf-8") as file:
            summary = json.load(file)
        self.assertEqual((summary["samples"], summary["estimates"]), (6, 5))
        self.assertAlmostEqual(summary["translation"]["mean"], OFFSET)
        self.assertAlmostEqual(summary["rotation"]["worst"], 0.0)

    def assert_plot(self):
        picture = os.path.join(self.directory.name, "run.png")
        subprocess.run([PLOT_RUN, self.csv_file, "--title", "test"], check=True)
        with open(picture, "rb") as file:
            self.assertEqual(file.read(len(PNG_HEADER)), PNG_HEADER)

    def test_plot_run_tells_what_is_wrong_with_a_file(self):
        def complaint(name, text):
            path = os.path.join(self.directory.name, name)
            if text is not None:
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            done = subprocess.run([PLOT_RUN, path], stderr=subprocess.PIPE, check=False)
            self.assertEqual(done.returncode, BAD_INPUT)
            return done.stderr.decode()

        self.end_node()
        with open(self.csv_file, encoding="utf-8") as file:
            header = file.read()
        self.assertIn("cannot be read", complaint("missing.csv", None))
        self.assertIn("0 rows", complaint("empty.csv", header))
        self.assertIn("no column translation_error", complaint("other.csv", "time,x\n1,2\n"))
        self.assertIn("line 2: time is 'soon'", complaint("text.csv", header + "soon" + 12 * "," + "\n"))

    def set_time(self, time):
        self.clock.publish(rosgraph_msgs.msg.Clock(rospy.Time.from_sec(time)))

    def send_truth(self, time, x, frame="truth_map"):
        """The robot is OFFSET farther along y than tf has it."""
        message = PoseStamped()
        message.header.stamp, message.header.frame_id = rospy.Time.from_sec(time), frame
        message.pose.position.x, message.pose.position.y = ALIGNMENT[0] + x, ALIGNMENT[1] + OFFSET
        message.pose.orientation.w = 1.0
        self.truth.publish(message)

    def send_transforms(self, time, x):
        stamp = rospy.Time.from_sec(time)
        self.tf.publish(tf2_msgs.msg.TFMessage([stamped_transform("map", "session_map", ALIGNMENT, stamp),
                                                stamped_transform("session_map", "base_link", (x, 0.0, 0.0), stamp)]))

    def rows(self):
        """Those of the run that is not over yet."""
        with open(self.csv_file + ".partial", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def run_until_rows(self, count, time):
        """Lets time run on from `time`, for the first row beyond the timeout of its transform, until there are so many rows."""
        times = iter(range(10**6))

        def there_are():
            self.set_time(time + min(0.01 * next(times), 0.9 if count > 1 else 1.2))
            return len(self.rows()) >= count
        wait_until(there_are, "%d rows" % count)

    def end_node(self, how=signal.SIGINT):
        """Ends the node, as roslaunch does when nothing else is said, and returns what it printed."""
        self.node.send_signal(how)
        output = self.node.communicate(timeout=DEADLINE)[0].decode()
        self.assertEqual(self.node.returncode, 0, output)
        return output


if __name__ == "__main__":
    run("pose_evaluator_test", PoseEvaluator)
