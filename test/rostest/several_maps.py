#!/usr/bin/env python3
"""Several reference maps are searched together: the answer says which one the session lies in, its frame is tf's parent,
and of two that are alike nobody is told before an operator says which."""
import math
import os
import subprocess
import tempfile

import geometry_msgs.msg
import roslib.packages
import rospy
import tf2_ros
from diagnostic_msgs.msg import DiagnosticStatus
from nav_msgs.msg import OccupancyGrid

from building import is_wall_mirrored, pose, reference_map, session_map
from map_files import write_map
from map_matcher.msg import MapMatch
from node_fixture import Listener, NodeFixture, run, stamped_transform, wait_for_diagnostic, wait_until
from node_runs import BAD_INPUT, run_node

START = (12.3, 7.1, 0.7)  # T_reference_session in either building
RVIZ_COVARIANCE = [0.25] + 6 * [0.0] + [0.25] + 27 * [0.0] + [0.06853892326654787]


class SeveralMaps(NodeFixture):
    def setUp(self):
        super().setUp()
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        ground = write_map(reference_map(), directory.name, "ground")
        self.files = {"ground_floor": ground,
                      "first_floor": write_map(reference_map(wall=is_wall_mirrored), directory.name, "first")}
        self.twin = write_map(reference_map(), directory.name, "twin")

    def start(self, files):
        rospy.set_param("/map_matcher/reference_maps", files)
        program = roslib.packages.find_node("map_matcher", "map_matcher_node")[0]
        node = subprocess.Popen([program, "__name:=map_matcher", "_serve_map:=true"], env=dict(os.environ))
        self.addCleanup(node.wait)
        self.addCleanup(node.terminate)
        self.served = Listener("map", OccupancyGrid)
        wait_until(lambda: self.session.get_num_connections() == 1, "the node listens")

    def test_are_told_apart(self):
        self.start(self.files)
        wait_for_diagnostic("map_matcher: reference map",
                            lambda status: status.level == DiagnosticStatus.OK and status.message == "2 in use")
        self.assertEqual(self.served.messages, [], "it is not known yet which of them is the robot's")

        below = self.match(session_map(START))
        self.assertEqual(below.reference_frame, "ground_floor")
        self.assert_pose(below.T_reference_session, START)
        self.assert_pose(self.wait_for_tf("ground_floor", "session_map").transform, START)
        self.served.wait_for(lambda map: map.header.frame_id == "ground_floor", "the map of the ground floor")

        above = self.session_of_first_floor()
        self.assertEqual(above.reference_frame, "first_floor")
        self.assert_pose(above.T_reference_session, START)
        self.assert_pose(self.wait_for_tf("first_floor", "session_map").transform, START)
        self.served.wait_for(lambda map: map.header.frame_id == "first_floor", "the map of the first floor")

    def session_of_first_floor(self):
        """The robot was carried upstairs, and its mapper began anew: the map knows fewer cells than the one before."""
        self.match(session_map(START, wall=is_wall_mirrored, seen=5.0), reference_frame="first_floor")
        return self.match(session_map(START, wall=is_wall_mirrored), reference_frame="first_floor")

    def test_that_are_alike_are_told_apart_by_an_operator(self):
        self.start(dict(self.files, twin=self.twin))
        broadcaster = tf2_ros.TransformBroadcaster()
        initialpose = rospy.Publisher("initialpose", geometry_msgs.msg.PoseWithCovarianceStamped, queue_size=1)
        wait_until(lambda: initialpose.get_num_connections() == 1, "the node listens to initialpose")
        wait_until(lambda: broadcaster.pub_tf.get_num_connections() == 2, "the node and this test listen to /tf")

        alike = self.match(session_map(START), MapMatch.AMBIGUOUS)
        self.assertTrue(math.isnan(alike.x))
        self.assert_no_tf("session_map")

        message = geometry_msgs.msg.PoseWithCovarianceStamped()
        message.header.frame_id, message.header.stamp = "twin", rospy.Time.now()
        message.pose.pose = pose(12.0, 7.0, 0.7)
        message.pose.covariance = RVIZ_COVARIANCE
        broadcaster.sendTransform(stamped_transform("session_map", "base_link", (0.0, 0.0, 0.0), message.header.stamp))
        initialpose.publish(message)

        told = self.map_match.wait_for(lambda match: match.status == MapMatch.MATCHED, "a match")
        self.assertEqual(told.reference_frame, "twin")
        self.assert_pose(self.wait_for_tf("twin", "session_map").transform, START)

    def test_that_cannot_be_used_are_named(self):
        same_file = os.path.join(os.path.dirname(self.twin), ".", "twin.yaml")
        for files, text in (({"a": "/nowhere/map.yaml"}, "/nowhere/map.yaml"),
                            ({"a": self.twin, "b": same_file}, "twice, as a and as b"),
                            ({"a": 3}, "expected texts by name")):
            rospy.set_param("/under_test/reference_maps", files)
            code, output = run_node("map_matcher_node")
            self.assertEqual(code, BAD_INPUT)
            self.assertIn(text, output)

    def test_and_a_single_one_are_too_many(self):
        rospy.set_param("/under_test/reference_maps", self.files)
        code, output = run_node("map_matcher_node", reference_map_file=self.twin)
        self.assertEqual(code, BAD_INPUT)
        self.assertIn("expected one of both", output)


if __name__ == "__main__":
    run("several_maps", SeveralMaps)
