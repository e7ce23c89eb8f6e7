#!/usr/bin/env python3
"""check_robot tells what a robot has not, by name and with what to do; and nothing when all is there."""
import os
import subprocess
import unittest

import rospy
import rostest
import tf2_msgs.msg
from geometry_msgs.msg import PoseArray
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan

from building import reference_map, session_map
from node_fixture import stamped_transform

DURATION = 3.0  # [s], that check_robot listens
START = (12.3, 7.1, 0.7)  # T_reference_session


def check_robot(**arguments):
    """What it says."""
    given = ["%s:=%s" % item for item in dict(arguments, duration=DURATION).items()]
    done = subprocess.run(["roslaunch", "--wait", "map_matcher", "check_robot.launch", *given], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=60, check=False)
    return done.stdout.decode()


class CheckRobot(unittest.TestCase):
    """A robot that is played by this test."""

    def setUp(self):
        self.timers, self.publishers = [], []

    def tearDown(self):
        for timer in self.timers:
            timer.shutdown()
        for publisher in self.publishers:
            publisher.unregister()

    def keep_sending(self, topic, kind, message_at, rate=20.0, latch=False):
        publisher = rospy.Publisher(topic, kind, queue_size=10, latch=latch)
        self.publishers.append(publisher)
        self.timers.append(rospy.Timer(rospy.Duration(1.0 / rate), lambda _: publisher.publish(message_at(rospy.Time.now()))))

    def scan(self, stamp, frame="laser", beams=181):
        message = LaserScan(angle_min=-1.57, angle_increment=3.14 / 180, angle_max=1.57, range_max=20.0)
        message.header.stamp, message.header.frame_id = stamp, frame
        message.ranges = beams * [5.0]
        return message

    def start_robot(self, scan_age=0.0, **scan):
        self.keep_sending("scan", LaserScan, lambda now: self.scan(now - rospy.Duration(scan_age), **scan))
        self.keep_sending("/tf", tf2_msgs.msg.TFMessage, lambda now: [
            stamped_transform("odom", "base_link", (0.0, 0.0, 0.0), now),
            stamped_transform("base_link", "laser", (0.1, 0.0, 0.0), now)])

    def start_maps(self, session_frame="session_map"):
        session, reference = session_map(START, frame=session_frame), reference_map()
        for topic, message in (("session_map", session), ("map_matcher/reference_map", reference), ("map", reference)):
            message.header.stamp = rospy.Time.now()
            self.keep_sending(topic, OccupancyGrid, lambda _, message=message: message, rate=1.0, latch=True)

    def test_says_ok_when_all_is_there(self):
        self.start_robot()
        self.start_maps()
        detections = PoseArray()
        detections.header.frame_id = "laser"

        def detections_at(now):
            detections.header.stamp = now
            return detections
        self.keep_sending("dr_spaam_detections", PoseArray, detections_at)

        said = check_robot(detections="[dr_spaam_detections]")

        self.assertIn("0 errors, 0 warnings", said)
        for text in ("scans on /scan:", 'odometry: "odom" -> "base_link"', "frames: none has two parents",
                     "detections on /dr_spaam_detections:", "session map on /session_map:",
                     "reference map on /map_matcher/reference_map:", "planner: the map on /map"):
            self.assertRegex(said, r"ok +.*" + text)

    def test_names_everything_that_is_not_there(self):
        said = check_robot(detections="[dr_spaam_detections]")

        for text in ("scans: nobody publishes /scan: start the laser's driver",
                     'odometry: tf does not connect "base_link" to "odom": start the robot\'s driver',
                     "detections: nobody publishes /dr_spaam_detections: start the person detector",
                     "session map: nobody publishes /session_map: start the mapper",
                     "reference map: nobody publishes /map_matcher/reference_map: start map_matcher"):
            self.assertIn(text, said)
        self.assertIn("5 errors", said)

    def test_names_scans_that_cannot_be_used(self):
        self.start_robot(scan_age=3.0, frame="hokuyo", beams=300)
        self.start_maps()

        said = check_robot()

        self.assertIn('tf does not connect their frame "hokuyo" to "base_link"', said)
        self.assertIn("stamped 3.0", said)
        self.assertIn("angle_max is 1.5700, but", said)

    def test_names_two_maps_in_one_frame_and_a_frame_with_two_parents(self):
        self.start_robot()
        self.start_maps(session_frame="map")
        self.keep_sending("/tf", tf2_msgs.msg.TFMessage, lambda now: [
            stamped_transform("map", "odom", (0.0, 0.0, 0.0), now)])
        self.keep_sending("/tf_static", tf2_msgs.msg.TFMessage, lambda now: [
            stamped_transform("world", "odom", (0.0, 0.0, 0.0), now)])

        said = check_robot()

        self.assertIn('maps: both are in the frame "map"', said)
        self.assertIn('frames: "odom" has two parents: "map" by /check_robot_test, "world" by /check_robot_test', said)

    def test_names_the_two_dangerous_mistakes(self):
        self.start_robot()
        self.start_maps()
        planner = subprocess.Popen([os.path.join(os.path.dirname(__file__), "mistaken_planner.py")])
        self.addCleanup(planner.wait)
        self.addCleanup(planner.terminate)
        rospy.wait_for_service("/move_base/get_loggers", 20.0)

        said = check_robot(planner_map="session_map")

        self.assertIn("obstacles: /move_base reads /scan_scrubbed, in which there are no people", said)
        self.assertIn("planner: move_base plans on /session_map, which is the session map", said)


if __name__ == "__main__":
    rospy.init_node("check_robot_test")
    rostest.rosrun("map_matcher", "check_robot", CheckRobot)
