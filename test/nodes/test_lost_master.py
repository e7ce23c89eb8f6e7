#!/usr/bin/env python3
"""The master ends, and comes back: nodes that know each other go on, and the robot's pose with them."""
import os
import socket
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "rostest"))


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


PORT = free_port()
os.environ["ROS_MASTER_URI"] = f"http://127.0.0.1:{PORT}"  # before anything of ROS is imported

import roslib.packages
import rosgraph
import rospy
import tf2_msgs.msg
from nav_msgs.msg import OccupancyGrid

from building import reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import Listener, is_between, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session


def start_master():
    master = subprocess.Popen(["rosmaster", "--core", "-p", str(PORT)], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL)
    wait_until(rosgraph.is_master_online, "a master")
    return master


def end(process):
    process.terminate()  # SIGINT is ignored by what a shell started in the background, and by its children
    process.wait()


class LostMaster(unittest.TestCase):
    def setUp(self):
        self.master = start_master()
        node = roslib.packages.find_node("map_matcher", "map_matcher_node")[0]
        self.node = subprocess.Popen([node, "__name:=map_matcher"])
        rospy.init_node("lost_master", disable_signals=True)
        self.matches = Listener("map_match", MapMatch)
        self.tf = Listener("/tf", tf2_msgs.msg.TFMessage)
        self.session = rospy.Publisher("session_map", OccupancyGrid, queue_size=10, latch=True)
        self.reference = rospy.Publisher("reference_map", OccupancyGrid, queue_size=10, latch=True)
        self.reference.publish(reference_map())

    def tearDown(self):
        end(self.node)
        try:
            rospy.signal_shutdown("the test is over")
        except AttributeError:  # the rospy of Debian 11 asks Thread.isAlive(), which its Python has no more
            pass
        end(self.master)

    def match(self):
        session = session_map(START)
        session.header.stamp = rospy.Time.now()
        self.session.publish(session)
        self.matches.wait_for(lambda match: match.session_stamp == session.header.stamp and
                              match.status == MapMatch.MATCHED, "a match")

    def wait_for_tf(self):
        self.tf.clear()
        self.tf.wait_for(lambda tf: any(is_between(t, "map", "session_map") for t in tf.transforms), "the alignment")

    def test_nodes_that_know_each_other_go_on(self):
        self.match()
        self.wait_for_tf()

        end(self.master)
        self.assertFalse(rosgraph.is_master_online())
        self.match()
        self.wait_for_tf()

        self.master = start_master()
        self.match()
        self.wait_for_tf()
        time.sleep(1.0)
        self.assertIsNone(self.node.poll(), "the node is still there")


if __name__ == "__main__":
    unittest.main()
