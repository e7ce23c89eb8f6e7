#!/usr/bin/env python3
"""A lidar_scrubber that waits for the detections of each scan, and drops scans while the detector is silent."""
import math
import unittest

import geometry_msgs.msg
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from sensor_msgs.msg import LaserScan

from node_fixture import Listener, wait_until
from people_in_scans import RANGE, beams_near, pose_array, removed_beams, scan_message


class StrictLidarScrubber(unittest.TestCase):
    def setUp(self):
        self.scrubbed = Listener("strict/scan_scrubbed", LaserScan)
        self.scan = rospy.Publisher("strict/scan", LaserScan, queue_size=100)
        self.front = rospy.Publisher("strict/front_detections", geometry_msgs.msg.PoseArray, queue_size=100)
        wait_until(lambda: self.scan.get_num_connections() > 0 and self.front.get_num_connections() > 0,
                   "connections to the scrubber")
        self.scrubbed.wait_until_served()

    def test_scans_wait_for_their_own_detections(self):
        self.front.publish(pose_array(rospy.Time.now(), []))

        def scrubbed():
            stamp = rospy.Time.now()
            self.scrubbed.clear()
            self.scan.publish(scan_message(stamp))
            rospy.sleep(0.05)
            early = [out for out in self.scrubbed.messages if out.header.stamp == stamp]
            self.assertEqual(early, [])
            self.front.publish(pose_array(stamp, [(RANGE, 0.0)]))
            out = self.scrubbed.wait_for(lambda out: out.header.stamp == stamp, "scan after its detections")
            return removed_beams(out) == beams_near(0.0) and all(math.isnan(out.ranges[i]) for i in removed_beams(out))

        wait_until(scrubbed, "a scan without its person")

    def test_a_scan_without_detections_goes_after_the_timeout(self):
        self.front.publish(pose_array(rospy.Time.now(), []))
        stamp = rospy.Time.now() + rospy.Duration(0.5)

        def goes():
            self.front.publish(pose_array(rospy.Time.now(), []))  # alive, but says nothing of this scan
            self.scan.publish(scan_message(stamp))
            return any(out.header.stamp == stamp for out in self.scrubbed.messages)

        wait_until(goes, "scan that waited in vain")

    def test_scans_are_dropped_while_the_detector_is_silent(self):
        self.front.publish(pose_array(rospy.Time.now(), []))
        rospy.sleep(1.5)
        self.scrubbed.clear()
        self.scan.publish(scan_message(rospy.Time.now()))
        rospy.sleep(0.5)
        self.assertEqual(self.scrubbed.messages, [])

        def served():
            self.front.publish(pose_array(rospy.Time.now(), []))
            self.scan.publish(scan_message(rospy.Time.now()))
            return self.scrubbed.messages

        wait_until(served, "scans once the detector is heard again")

    def test_scans_are_dropped_while_all_detections_come_too_late(self):
        diagnostics = Listener("/diagnostics", DiagnosticArray)

        def withheld():
            return max([int(pair.value) for message in diagnostics.messages for status in message.status
                        for pair in status.values
                        if status.name == "strict/lidar_scrubber: scans" and pair.key == "withheld"], default=0)

        def publish(delay):
            now = rospy.Time.now()
            self.scan.publish(scan_message(now))
            self.front.publish(pose_array(now - rospy.Duration(delay), []))

        wait_until(lambda: publish(0.0) or (diagnostics.messages and self.scrubbed.messages), "scans in time")
        before = withheld()
        wait_until(lambda: publish(2.0) or withheld() > before + 20, "scans withheld")
        self.scrubbed.clear()
        end = rospy.Time.now() + rospy.Duration(0.5)
        while rospy.Time.now() < end:
            publish(2.0)
            rospy.sleep(0.02)
        self.assertEqual(self.scrubbed.messages, [])

        wait_until(lambda: publish(0.0) or self.scrubbed.messages, "scans once detections come in time again")


if __name__ == "__main__":
    rospy.init_node("strict_lidar_scrubber_test")
    rostest.rosrun("map_matcher", "strict_lidar_scrubber", StrictLidarScrubber)
