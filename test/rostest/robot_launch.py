#!/usr/bin/env python3
"""pioneer.launch and pepper.launch on a simulated robot in place of the drivers: the robot finds itself, raw scans keep
their topics, and what the scrubbed ones lead to is the mapper and nothing else."""
import os
import subprocess
import tempfile
import unittest

import rosgraph
import rospy
import rostest
from nav_msgs.msg import OccupancyGrid
from tf2_msgs.msg import TFMessage

from map_matcher.msg import MapMatch
from node_fixture import Listener, is_between, wait_until

DEADLINE = 120.0  # [s]
SIMULATOR = "{beams: 271, rate: 10.0}"
ROBOTS = {
    "pioneer": {
        "raw": ["/scan"],
        "read_by_mapper": ["/scan_scrubbed"],
        "detections": "[person_detections]",
        "arguments": [],
        "frames": ("map", "session_map", "odom", "base_link"),
    },
    "pepper": {
        "raw": ["/sick_laser_front/scan", "/sick_laser_rear/scan"],
        "read_by_mapper": ["/sick_laser_front/scan_scrubbed", "/sick_laser_rear/scan_scrubbed"],
        "detections": "[person_detections/front, person_detections/rear]",
        "arguments": [],
        "frames": ("map", "gmap", "odom", "base_footprint"),  # the reference map is the simulator's
    },
}
# As for slam_gmapping, which reads one scan.
MERGED = {"read_by_mapper": ["/merged_scan_scrubbed"], "arguments": ["merge:=true"]}


class Graph:
    def __init__(self):
        publishers, subscribers, _ = rosgraph.Master(rospy.get_name()).getSystemState()
        own = {rospy.get_name()}
        self.publishers = {topic: set(nodes) - own for topic, nodes in publishers}
        self.subscribers = {topic: set(nodes) - own for topic, nodes in subscribers}


class RobotLaunch(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.name = rospy.get_param("~robot")
        self.robot = {**ROBOTS[self.name], **(MERGED if rospy.get_param("~merge", False) else {})}

    def launch(self, launch_file, *arguments):
        process = subprocess.Popen(["roslaunch", "--wait", "map_matcher", launch_file, *arguments])
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)

    def simulate(self):
        config = os.path.join(self.directory.name, "simulator.yaml")
        with open(config, "w", encoding="utf-8") as file:
            file.write(SIMULATOR)
        self.launch("crowd_simulator.launch", "robot:=" + self.name, "seed:=3", "density:=0.15", "real_time_factor:=2",
                    "base_frame:=" + self.robot["frames"][3], "config:=" + config)

    def test_finds_the_robot_and_keeps_raw_and_scrubbed_scans_apart(self):
        matches, tf = Listener("map_match", MapMatch), Listener("/tf", TFMessage)
        self.simulate()
        self.launch(self.name + ".launch", "reference_map:=true_map", "mapper:=session_mapper",
                    "detections:=" + self.robot["detections"], *self.robot["arguments"])

        matches.wait_for(lambda match: match.status == MapMatch.MATCHED, "a match", DEADLINE)
        parents = self.robot["frames"]
        for parent, child in zip(parents, parents[1:]):
            tf.wait_for(lambda message: any(is_between(t, parent, child) for t in message.transforms),
                        "%s -> %s" % (parent, child))
        self.assert_scans_are_kept_apart()
        self.assert_maps_are_kept_apart()

    def assert_scans_are_kept_apart(self):
        graph = Graph()
        mapper = {"/session_mapper"}
        readers = mapper | {"/map_matcher_nodelets"}  # the scan_merger is one of them
        for topic in self.robot["raw"]:
            self.assertEqual(graph.publishers[topic], {"/crowd_simulator"}, "raw scans are the driver's alone")
            self.assertEqual(graph.subscribers[topic], {"/map_matcher_nodelets"}, topic)
            scrubbed = topic + "_scrubbed"
            self.assertEqual(graph.publishers[scrubbed], {"/map_matcher_nodelets"}, "scrubbers run in one manager")
            self.assertLessEqual(graph.subscribers.get(scrubbed, set()), readers, "nothing but the mapper reads " + scrubbed)
        for topic in self.robot["read_by_mapper"]:
            self.assertEqual(graph.subscribers[topic], mapper)

    def assert_maps_are_kept_apart(self):
        graph = Graph()
        self.assertEqual(graph.publishers["/map"], {"/map_matcher"})
        self.assertEqual(graph.publishers["/session_map"], {"/session_mapper"})
        planner_map = Listener("/map", OccupancyGrid).wait_for(lambda _: True, "the map for planners")
        self.assertEqual(planner_map.header.frame_id, self.robot["frames"][0])
        wait_until(lambda: "/true_map" in Graph().subscribers, "the reference map is taken from its topic")


if __name__ == "__main__":
    rospy.init_node("robot_launch")
    rostest.rosrun("map_matcher", "robot_launch", RobotLaunch)
