#!/usr/bin/env python3
"""The overlay_recorder node writes the last session map and its picture when it ends, however it is told to."""
import os
import signal
import subprocess
import tempfile
import unittest
import xmlrpc.client

import roslib.packages
import rosgraph
import rospy
from nav_msgs.msg import OccupancyGrid

from building import reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import DEADLINE, run, wait_until

NODE = roslib.packages.find_node("map_matcher", "overlay_recorder")[0]
FILES = ["overlay.png", "session_map.pgm", "session_map.yaml"]


class OverlayRecorder(unittest.TestCase):
    def setUp(self):
        self.publishers = {
            "/session_map": rospy.Publisher("session_map", OccupancyGrid, queue_size=1, latch=True),
            "/reference_map": rospy.Publisher("reference_map", OccupancyGrid, queue_size=1, latch=True),
            "/map_match": rospy.Publisher("map_match", MapMatch, queue_size=1, latch=True)}
        self.publishers["/session_map"].publish(session_map((12.3, 7.1, 0.7)))
        self.publishers["/reference_map"].publish(reference_map())
        self.publishers["/map_match"].publish(MapMatch(status=MapMatch.MATCHED, x=12.3, y=7.1, yaw=0.7))

    def tearDown(self):
        for publisher in self.publishers.values():
            publisher.unregister()

    def test_writes_its_files_when_it_is_terminated(self):
        self.assert_writes_its_files(signal.SIGTERM)

    def test_writes_its_files_when_it_is_interrupted(self):
        self.assert_writes_its_files(signal.SIGINT)

    def assert_writes_its_files(self, how):
        with tempfile.TemporaryDirectory() as directory:
            node = subprocess.Popen([NODE, "__name:=under_test", "_directory:=" + directory], stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT)
            try:
                wait_until(self.has_received_all, "the node has the maps and the match")
                node.send_signal(how)
                output = node.communicate(timeout=DEADLINE)[0].decode()
            finally:
                node.kill()
            self.assertEqual(node.returncode, 0, output)
            self.assertEqual(sorted(os.listdir(directory)), FILES, output)

    def has_received_all(self):
        """Whether the node counts a message on each topic."""
        master = rosgraph.Master(rospy.get_name())
        try:
            node = xmlrpc.client.ServerProxy(master.lookupNode("/under_test"))
            subscriptions = node.getBusStats(rospy.get_name())[1]  # roscpp answers without a status
        except (rosgraph.MasterError, OSError):  # it is not there yet
            return False
        received = {topic: sum(connection[2] for connection in connections) for topic, connections in subscriptions}
        return all(received.get(topic, 0) > 0 for topic in self.publishers)


if __name__ == "__main__":
    run("overlay_recorder_test", OverlayRecorder)
