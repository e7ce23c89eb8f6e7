#!/usr/bin/env python3
"""Scans go through the lidar_scrubber: people go, everything else stays, and bad messages change nothing."""
import math
import unittest

import geometry_msgs.msg
import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan, PointCloud2
from visualization_msgs.msg import Marker

from map_matcher.msg import PersonDetections
from node_fixture import Listener, broadcast_static, stamped_transform, wait_for_diagnostic, wait_until
from people_in_scans import (BEAMS, INTERVAL, RANGE, beams_near, pose_array, removed_beams, scan_message,
                             scored_detections)

class LidarScrubber(unittest.TestCase):
    stamp = None  # of the last scan, shared: stamps rise through all tests

    def setUp(self):
        self.scrubbed = Listener("scan_scrubbed", LaserScan)
        self.scan = rospy.Publisher("scan", LaserScan, queue_size=100)
        self.front = rospy.Publisher("front_detections", geometry_msgs.msg.PoseArray, queue_size=100)
        self.rear = rospy.Publisher("rear_detections", PersonDetections, queue_size=100)
        wait_until(lambda: all(p.get_num_connections() > 0 for p in (self.scan, self.front, self.rear)),
                   "connections to the scrubber")
        self.scrubbed.wait_until_served()
        # A second after everything that came before: no detection of another test applies.
        LidarScrubber.stamp = max(rospy.Time.now(), (LidarScrubber.stamp or rospy.Time()) + rospy.Duration(1.0))
        wait_until(self.passes_a_scan_through, "a scan that comes through")

    def passes_a_scan_through(self):
        """Sends a scan that may be lost on the way, since the connection is a new one."""
        scan = scan_message(self.next_stamp())
        self.scan.publish(scan)
        try:
            return self.scrubbed.wait_for(lambda out: out.header.stamp == scan.header.stamp, "scrubbed scan", 1.0)
        except AssertionError:
            return None

    def tearDown(self):
        for publisher in (self.scan, self.front, self.rear):
            publisher.unregister()

    def next_stamp(self):
        LidarScrubber.stamp += rospy.Duration(INTERVAL)
        return LidarScrubber.stamp

    def pass_through(self, scan):
        """Sends a scan and returns what comes out."""
        self.scan.publish(scan)
        return self.scrubbed.wait_for(lambda out: out.header.stamp == scan.header.stamp, "scrubbed scan")

    def scrub_after(self, publisher, message):
        """Sends detections, then a scan of the same stamp again and again until it is changed."""
        publisher.publish(message)
        end = rospy.Time.now() + rospy.Duration(10.0)
        while rospy.Time.now() < end:
            self.scrubbed.clear()
            out = self.pass_through(scan_message(message.header.stamp))
            if removed_beams(out):
                return out
        raise AssertionError("nothing was removed")

    def test_points_near_people_are_removed_and_nothing_else(self):
        out = self.scrub_after(self.front, pose_array(self.next_stamp(), [(RANGE, 0.0), (0.0, RANGE)]))

        self.assertEqual(removed_beams(out), sorted(beams_near(0.0) + beams_near(math.pi / 2)))
        self.assertTrue(all(out.ranges[i] == math.inf for i in removed_beams(out)))
        kept = scan_message(out.header.stamp)
        self.assertEqual([r for i, r in enumerate(out.ranges) if i not in removed_beams(out)],
                         [RANGE] * (BEAMS - len(removed_beams(out))))
        self.assertEqual(out.intensities, tuple(kept.intensities))
        self.assertEqual(out.header.frame_id, "laser")
        self.assertEqual((out.angle_min, out.angle_max, out.angle_increment, out.range_min, out.range_max),
                         tuple(self.scrubbed_limits(kept)))

    @staticmethod
    def scrubbed_limits(scan):
        """The limits of a scan as 32-bit numbers, as they are after a journey."""
        from io import BytesIO
        buffer = BytesIO()
        scan.serialize(buffer)
        copy = LaserScan().deserialize(buffer.getvalue())
        return copy.angle_min, copy.angle_max, copy.angle_increment, copy.range_min, copy.range_max

    def test_scans_without_people_stay_as_they_are(self):
        out = self.pass_through(scan_message(self.next_stamp(), [1.0, math.inf, 0.0, 30.0, 2.5]))

        self.assertEqual(out.ranges, (1.0, math.inf, 0.0, 30.0, 2.5))

    def test_detections_apply_to_the_next_scans_only(self):
        self.scrub_after(self.front, pose_array(self.next_stamp(), [(RANGE, 0.0)]))

        for _ in range(3):  # 0.21 s
            self.assertTrue(removed_beams(self.pass_through(scan_message(self.next_stamp()))))
        self.assertFalse(removed_beams(self.pass_through(scan_message(self.next_stamp()))))

    def test_low_scores_do_not_count(self):
        out = self.scrub_after(self.rear, scored_detections(
            self.next_stamp(), [(RANGE, 0.0, 0.9), (-RANGE, 0.0, 0.39), (0.0, RANGE, 0.4)]))

        self.assertEqual(removed_beams(out), sorted(beams_near(0.0) + beams_near(math.pi / 2)))

    def test_detections_stay_in_place_when_the_robot_moves(self):
        broadcaster = tf2_ros.TransformBroadcaster()
        then = self.next_stamp()
        now = self.next_stamp()
        broadcaster.sendTransform([stamped_transform("odom", "laser", (5.0, 0.0, 0.0), then - rospy.Duration(0.001)),
                                   stamped_transform("odom", "laser", (5.0, 0.0, 0.0), then)])
        broadcaster.sendTransform(stamped_transform("odom", "laser", (5.0, 0.0, math.pi / 2), now))
        self.front.publish(pose_array(then, [(RANGE, 0.0)]))

        def turned():
            self.scrubbed.clear()
            out = self.pass_through(scan_message(now))  # the robot has turned left: the person is on its right
            return removed_beams(out) == beams_near(-math.pi / 2)

        wait_until(turned, "removal where the person is")

    def test_detections_of_another_laser(self):
        keep = broadcast_static("laser", "rear_laser", (-1.0, 0.0, math.pi))
        self.front.publish(pose_array(self.next_stamp(), [(1.0, 0.0)], "rear_laser"))

        def behind():
            self.scrubbed.clear()
            return removed_beams(self.pass_through(scan_message(LidarScrubber.stamp))) == beams_near(math.pi)

        wait_until(behind, "removal of the person behind")
        del keep

    def test_time_that_goes_back_clears_the_cache(self):
        stamp = self.next_stamp()
        self.scrub_after(self.front, pose_array(stamp, [(RANGE, 0.0)]))
        self.pass_through(scan_message(stamp - rospy.Duration(100.0)))

        self.scrubbed.clear()
        self.assertFalse(removed_beams(self.pass_through(scan_message(stamp))))

    def test_bad_detections_change_nothing(self):
        bad = pose_array(self.next_stamp(), [(math.nan, 0.0), (math.inf, 1.0), (1e30, 0.0)])
        self.front.publish(bad)
        self.front.publish(pose_array(LidarScrubber.stamp, [(RANGE, 0.0)], ""))
        self.front.publish(pose_array(LidarScrubber.stamp, [(RANGE, 0.0)], "unheard_of"))
        self.front.publish(pose_array(LidarScrubber.stamp + rospy.Duration(1000.0), [(RANGE, 0.0)]))
        self.front.publish(pose_array(LidarScrubber.stamp - rospy.Duration(1000.0), [(RANGE, 0.0)]))

        def counted(status):
            values = {v.key: v.value for v in status.values}
            return int(values["bad messages"]) >= 2 and int(values["detections left out"]) >= 3

        wait_for_diagnostic("lidar_scrubber: detections front_detections", counted)
        self.assertFalse(removed_beams(self.pass_through(scan_message(self.next_stamp()))))

    def test_ten_thousand_detections_delay_nothing(self):
        out = self.scrub_after(self.front, pose_array(
            self.next_stamp(), [(RANGE + 0.0001 * i, 0.0) for i in range(10000)]))

        self.assertEqual(removed_beams(out), beams_near(0.0))

    def test_a_scan_that_would_lose_nearly_everything_is_passed_on(self):
        everywhere = [(RANGE * math.cos(0.1 * k), RANGE * math.sin(0.1 * k)) for k in range(63)]
        self.front.publish(pose_array(self.next_stamp(), everywhere))

        diagnostics = Listener("/diagnostics", DiagnosticArray)

        def passed():
            self.scrubbed.clear()
            self.pass_through(scan_message(LidarScrubber.stamp))
            return any(value.key == "scans passed as they were" and int(value.value) > 0
                       for message in list(diagnostics.messages) for status in message.status for value in status.values)

        wait_until(passed, "a scan passed on, once the detections are there")
        self.scrubbed.clear()
        self.assertFalse(removed_beams(self.pass_through(scan_message(LidarScrubber.stamp))))

    def test_scans_that_make_no_sense_are_dropped_and_the_next_is_served(self):
        empty = scan_message(self.next_stamp(), [])
        inconsistent = scan_message(self.next_stamp())
        inconsistent.angle_max = 1.0
        no_number = scan_message(self.next_stamp())
        no_number.angle_increment = math.nan
        for bad in (empty, inconsistent, no_number):
            self.scan.publish(bad)

        self.pass_through(scan_message(self.next_stamp()))

        stamps = [out.header.stamp for out in self.scrubbed.messages]
        for bad in (empty, inconsistent, no_number):
            self.assertNotIn(bad.header.stamp, stamps)
        wait_for_diagnostic("lidar_scrubber: scans",
                            lambda s: any(v.key == "dropped" and int(v.value) >= 3 for v in s.values))

    def test_a_detector_that_says_nothing_is_told(self):
        wait_for_diagnostic("lidar_scrubber: detections rear_detections",
                            lambda s: s.level == DiagnosticStatus.WARN and "silent for" in s.message)
        wait_for_diagnostic("lidar_scrubber: detections rear_detections",
                            lambda s: s.level == DiagnosticStatus.ERROR and "silent for" in s.message)

    def test_an_empty_array_says_that_the_detector_is_alive(self):
        self.front.publish(pose_array(self.next_stamp(), []))

        wait_for_diagnostic("lidar_scrubber: detections front_detections", lambda s: s.level == DiagnosticStatus.OK)

    def test_removed_points_and_circles_are_shown(self):
        points = Listener("removed_points", PointCloud2)
        circles = Listener("removal_circles", Marker)
        points.wait_until_served()
        circles.wait_until_served()
        out = self.scrub_after(self.front, pose_array(self.next_stamp(), [(RANGE, 0.0)]))

        cloud = points.wait_for(lambda m: m.header.stamp == out.header.stamp and m.width > 0, "removed points")
        self.assertEqual(cloud.width, len(removed_beams(out)))
        marker = circles.wait_for(lambda m: m.action == Marker.ADD, "circles")
        self.assertAlmostEqual(math.hypot(marker.points[0].x - RANGE, marker.points[0].y), 0.3, places=6)

    def test_detections_on_known_walls_are_false(self):
        self.publish_reference(wall_on_the_right())

        wait_until(lambda: self.removed_beside_the_wall(True) == beams_near(math.pi), "veto of the detection on the wall")

    def test_detections_on_walls_count_again_once_the_robot_is_not_localized(self):
        self.publish_reference(wall_on_the_right())
        wait_until(lambda: self.removed_beside_the_wall(True) == beams_near(math.pi), "veto of the detection on the wall")

        both = sorted(beams_near(math.pi) + beams_near(-math.pi / 2))
        self.assertEqual(self.removed_beside_the_wall(False), both)  # half a second after the last alignment
        wait_for_diagnostic("lidar_scrubber: wall veto", lambda s: s.level == DiagnosticStatus.WARN)

    def test_a_reference_map_that_cannot_be_used_changes_nothing(self):
        self.publish_reference(wall_on_the_right())
        wait_until(lambda: self.removed_beside_the_wall(True) == beams_near(math.pi), "veto of the detection on the wall")
        broken = wall_on_the_right()
        broken.header.frame_id, broken.info.resolution = "elsewhere", 0.0
        self.publish_reference(broken)
        wait_for_diagnostic("lidar_scrubber: wall veto",
                            lambda s: any(v.key == "dropped maps" and int(v.value) > 0 for v in s.values))

        wait_until(lambda: self.removed_beside_the_wall(True) == beams_near(math.pi), "veto by the first map")

    def publish_reference(self, grid):
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.reference = rospy.Publisher("reference_map", OccupancyGrid, queue_size=1, latch=True)
        self.addCleanup(self.reference.unregister)
        self.reference.publish(grid)

    def removed_beside_the_wall(self, localized):
        """The beams removed from a scan with a detection on the wall and one of a person behind the robot."""
        LidarScrubber.stamp += rospy.Duration(0.6)  # no detection of the last round applies in this one
        stamp = LidarScrubber.stamp
        transforms = [stamped_transform("odom", "laser", (0.0, 0.0, 0.0), stamp)]
        if localized:
            transforms.append(stamped_transform("map", "odom", (0.0, 0.0, 0.0), stamp))
        self.broadcaster.sendTransform(transforms)
        self.front.publish(pose_array(stamp, [(0.0, -RANGE), (-RANGE, 0.0)]))
        self.scrubbed.clear()
        outs = [self.pass_through(scan_message(stamp + rospy.Duration(0.001 * k))) for k in range(50)]
        return removed_beams(outs[-1])

    def test_a_scan_with_an_absurd_layout_delays_nothing(self):
        self.front.publish(pose_array(self.next_stamp(), [(RANGE, 0.0)]))
        absurd = scan_message(LidarScrubber.stamp)
        absurd.angle_increment = 1e8
        absurd.angle_max = absurd.angle_min + 1e8 * (BEAMS - 1)
        for _ in range(10):
            self.scan.publish(absurd)

        self.pass_through(scan_message(self.next_stamp()))

        wait_for_diagnostic("lidar_scrubber: scans",
                            lambda s: any(v.key == "last problem" and "angle_increment" in v.value for v in s.values))

    def test_stamps_that_no_clock_can_show_end_nothing(self):
        stamp = rospy.Time()
        stamp.secs = stamp.nsecs = 2**32 - 1
        for _ in range(10):
            self.scan.publish(scan_message(stamp))
            self.front.publish(pose_array(stamp, [(RANGE, 0.0)]))

        self.pass_through(scan_message(self.next_stamp()))

    def test_frames_that_tf_does_not_connect_are_told_even_while_nobody_is_there(self):
        diagnostics = Listener("/diagnostics", DiagnosticArray)

        def told():
            self.front.publish(pose_array(self.next_stamp(), [], "unheard_of"))
            self.scan.publish(scan_message(LidarScrubber.stamp))
            return any(status.name == "lidar_scrubber: detections front_detections" and
                       status.level == DiagnosticStatus.ERROR and "unheard_of" in status.message
                       for message in diagnostics.messages for status in message.status)

        wait_until(told, "an error about the frame")
        wait_for_diagnostic("lidar_scrubber: scrubbing", lambda s: s.level == DiagnosticStatus.ERROR)


def wall_on_the_right():
    """A map with a wall from (-1, -2.05) to (1, -1.95) m."""
    grid = OccupancyGrid()
    grid.header.frame_id = "map"
    grid.info.resolution, grid.info.width, grid.info.height = 0.1, 20, 3
    grid.info.origin.position.x, grid.info.origin.position.y = -1.0, -2.15
    grid.info.origin.orientation.w = 1.0
    grid.data = [0] * 20 + [100] * 20 + [0] * 20
    return grid


if __name__ == "__main__":
    rospy.init_node("lidar_scrubber_test")
    rostest.rosrun("map_matcher", "lidar_scrubber", LidarScrubber)
