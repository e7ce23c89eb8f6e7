#!/usr/bin/env python3
"""The robot's last place is kept in a file and offered at the next start in the same map."""
import os
import signal
import subprocess
import tempfile

import rospy
import tf2_ros

from building import reference_map, session_map, transformed
from node_fixture import DEADLINE, NodeFixture, run, stamped_transform, wait_until
from node_runs import node_command

START = (12.3, 7.1, 0.7)  # T_reference_session
ROBOT = (2.0, 1.0, 0.3)  # in the session map


class SavedFix(NodeFixture):
    def setUp(self):
        super().setUp()
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.path = os.path.join(self.directory.name, "fix.yaml")
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.sending = rospy.Timer(rospy.Duration(0.02), lambda _: self.broadcaster.sendTransform(
            stamped_transform("session_map", "base_link", ROBOT, rospy.Time.now())))
        self.addCleanup(self.sending.shutdown)

    def start(self):
        """The node, which saves its fix. What it says at its start is in its output: nobody listens to /rosout so soon."""
        self.output = open(os.path.join(self.directory.name, "output.txt"), "w+", encoding="utf-8")
        self.addCleanup(self.output.close)
        node = subprocess.Popen(node_command("map_matcher_node", "map_matcher", fix_file=self.path),
                                stdout=self.output, stderr=subprocess.STDOUT,
                                env=dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED="1"))
        self.addCleanup(node.kill)
        wait_until(lambda: self.session.get_num_connections() == 1 and self.reference.get_num_connections() == 1,
                   "the node listens")
        wait_until(lambda: self.broadcaster.pub_tf.get_num_connections() == 2, "the node and this test listen to /tf")
        return node

    def stop(self, node):
        node.send_signal(signal.SIGINT)
        self.assertEqual(node.wait(DEADLINE), 0)

    def save(self):
        """A first run of the node that finds the robot; returns what it found."""
        node = self.start()
        self.reference.publish(reference_map())
        match = self.match(session_map(START))
        wait_until(lambda: os.path.exists(self.path), "a saved fix")
        self.stop(node)
        return match

    def line(self, text):
        def lines():
            self.output.seek(0)
            return [line for line in self.output if text in line]
        wait_until(lines, "a line with '%s'" % text)
        return lines()[0]

    def test_is_offered_at_the_next_start(self):
        match = self.save()
        with open(self.path) as file:
            self.assertIn('reference_map: "map"', file.read())

        node = self.start()
        self.reference.publish(reference_map())
        self.match(session_map(START))

        line = self.line("the robot was last at")
        expected = transformed((match.x, match.y, match.yaw), ROBOT[0], ROBOT[1])
        actual = line.split("last at (")[1].split(")")[0].replace(" m", "").replace(" rad", "").split(", ")
        self.assertAlmostEqual(float(actual[0]), expected[0], delta=1e-3)
        self.assertAlmostEqual(float(actual[1]), expected[1], delta=1e-3)
        self.assertIn(self.path, line)
        self.stop(node)

    def test_of_another_map_is_told_and_ignored(self):
        self.save()
        self.reference.publish(reference_map(shift=(0.1, 0.0)))  # latched: the node is given no other one

        node = self.start()
        self.match(session_map(START))

        self.assertIn(self.path, self.line("the saved fix of"))
        self.line("is about another reference map")
        self.stop(node)

    def test_that_is_cut_in_half_is_told_and_ignored(self):
        self.save()
        size = os.path.getsize(self.path)
        os.truncate(self.path, size // 2)

        node = self.start()

        self.assertIn(self.path, self.line("the saved fix is ignored"))
        self.reference.publish(reference_map())
        self.match(session_map(START))
        wait_until(lambda: os.path.getsize(self.path) >= size - 20, "a new fix in its place")
        self.stop(node)

    def test_that_cannot_be_written_is_told_and_the_node_goes_on(self):
        self.path = os.path.join(self.directory.name, "nowhere", "fix.yaml")

        node = self.start()
        self.reference.publish(reference_map())
        self.match(session_map(START))

        self.assertIn(self.path, self.line("the fix is not saved"))
        self.wait_for_tf("map", "session_map")
        self.stop(node)


if __name__ == "__main__":
    run("saved_fix", SavedFix)
