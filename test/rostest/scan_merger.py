#!/usr/bin/env python3
"""The scan_merger, as a nodelet, with two lasers of a robot that drives and turns in a room."""
import itertools
import math
import unittest

import diagnostic_msgs.msg
import rosgraph_msgs.msg
import rospy
import tf2_msgs.msg
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan

from node_fixture import Listener, run, stamped_transform, wait_until
from scanned_room import range_in_room

BEGIN = 100.0  # [s], simulated time
PERIOD = 0.1  # [s] between two scans
REVOLUTION = 0.06  # [s]
BEAMS = 1081
APERTURE = 1.5 * math.pi
SPEED, TURN_RATE = 0.5, 0.8  # [m/s], [rad/s]
LASERS = {"front": (0.25, 0.05, 0.1), "rear": (-0.25, -0.05, math.pi)}  # in the base frame: x, y, yaw [m, rad]
TOLERANCE = 0.05  # [m]: what half a beam's width makes of a slanting wall


def pose_at(time):
    """Of the robot, on a circle."""
    turned = TURN_RATE * (time - BEGIN)
    radius = SPEED / TURN_RATE
    return radius * math.sin(turned), radius * (1 - math.cos(turned)), turned


def compose(a, b):
    c, s = math.cos(a[2]), math.sin(a[2])
    return a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]


class ScanMerger(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.times = (BEGIN + PERIOD * k for k in itertools.count())
        cls.clock = rospy.Publisher("/clock", Clock, queue_size=10)
        cls.tf = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=100)
        cls.scans = {name: rospy.Publisher(name + "_scan", LaserScan, queue_size=10) for name in LASERS}
        cls.merged = Listener("merged_scan", LaserScan)
        cls.log = Listener("/rosout", rosgraph_msgs.msg.Log)
        cls.diagnostics = Listener("/diagnostics", diagnostic_msgs.msg.DiagnosticArray)
        wait_until(lambda: all(p.get_num_connections() > 0 for p in (cls.clock, cls.tf, *cls.scans.values())),
                   "connections to the merger")
        cls.merged.wait_until_served()

    def step(self, lasers=("front", "rear"), change=None):
        """Sends transforms, and scans of some lasers, the rear one's a little later; returns the time."""
        time = next(self.times)
        self.clock.publish(Clock(rospy.Time.from_sec(time)))
        for moment in (time + PERIOD * share for share in (0.0, 0.25, 0.5, 0.75, 1.0)):
            stamp = rospy.Time.from_sec(moment)
            transforms = [stamped_transform("odom", "base_link", pose_at(moment), stamp)]
            transforms += [stamped_transform("base_link", name, mount, stamp) for name, mount in LASERS.items()]
            self.tf.publish(tf2_msgs.msg.TFMessage(transforms))
        for name in lasers:
            scan = self.scan_of(name, time + (0.02 if name == "rear" else 0.0))
            if change:
                change(name, scan)
            self.scans[name].publish(scan)
        rospy.rostime.wallsleep(0.05)
        return time

    def scan_of(self, name, time):
        scan = LaserScan(angle_min=-APERTURE / 2, angle_max=APERTURE / 2, angle_increment=APERTURE / (BEAMS - 1),
                         time_increment=REVOLUTION / (BEAMS - 1), scan_time=PERIOD, range_min=0.05, range_max=20.0)
        scan.header.stamp, scan.header.frame_id = rospy.Time.from_sec(time), name
        for i in range(BEAMS):
            x, y, yaw = compose(pose_at(time + i * scan.time_increment), LASERS[name])
            scan.ranges.append(range_in_room(x, y, yaw + scan.angle_min + i * scan.angle_increment))
        return scan

    def merged_at(self, condition, what, **step):
        """Steps until a merged scan fulfils the condition."""
        found = []

        def look():
            self.step(**step)
            found.extend(scan for scan in list(self.merged.messages) if condition(scan))
            return found
        self.merged.clear()
        wait_until(look, what)
        return found[-1]

    def assert_is_the_room(self, scan):
        """Every beam that has a range has that of the room, as seen from the robot at the stamp."""
        x, y, yaw = pose_at(scan.header.stamp.to_sec())
        for i, measured in enumerate(scan.ranges):
            if math.isfinite(measured):
                bearing = yaw + scan.angle_min + i * scan.angle_increment
                near = [range_in_room(x, y, bearing + side * scan.angle_increment) for side in (-0.5, 0.0, 0.5)]
                self.assertGreater(measured, min(near) - TOLERANCE, (i, bearing))
                self.assertLess(measured, max(near) + TOLERANCE, (i, bearing))

    def told(self, text):
        return any(text in line.msg for line in list(self.log.messages))

    def status(self, name):
        """The last status whose name ends so."""
        found = [status for array in list(self.diagnostics.messages) for status in array.status
                 if status.name.endswith(name)]
        return found[-1] if found else diagnostic_msgs.msg.DiagnosticStatus(level=255)

    def test_a_both_lasers_make_one_scan_of_the_whole_room(self):
        scan = self.merged_at(lambda scan: sum(map(math.isfinite, scan.ranges)) > 0.97 * len(scan.ranges),
                              "a scan all round")

        self.assertEqual("base_link", scan.header.frame_id)
        self.assertEqual(1080, len(scan.ranges))
        self.assertAlmostEqual(scan.angle_min + 1079 * scan.angle_increment, scan.angle_max, places=4)
        self.assertEqual(0.0, scan.time_increment)
        self.assert_is_the_room(scan)

    def test_b_a_laser_that_is_silent_is_told_and_the_other_goes_on(self):
        wait_until(lambda: self.step(lasers=("front",)) and self.told("no scan of rear_scan could be merged"),
                   "word of the silent laser")
        half = self.merged_at(lambda scan: sum(map(math.isfinite, scan.ranges)) < 0.9 * len(scan.ranges),
                              "a scan of one laser", lasers=("front",))
        self.assert_is_the_room(half)
        wait_until(lambda: self.step(lasers=("front",)) and
                   self.status("scans of rear_scan").level == diagnostic_msgs.msg.DiagnosticStatus.ERROR, "an error")

        wait_until(lambda: self.step() and self.told("scans of rear_scan are merged again"), "word that it is back")

    def test_c_the_other_laser_leads_while_the_first_one_is_silent(self):
        scan = self.merged_at(lambda scan: abs(scan.header.stamp.to_sec() * 10 % 1 - 0.2) < 0.01,
                              "a scan with a stamp of the rear laser", lasers=("rear",))
        self.assert_is_the_room(scan)

    def test_d_a_scan_that_makes_no_sense_is_left_out_and_told(self):
        def spoil(name, scan):
            if name == "rear":
                scan.angle_increment = 0.0

        wait_until(lambda: self.step(change=spoil) and self.told("a scan of rear_scan is left out"), "word of the bad scan")
        self.assert_is_the_room(self.merged_at(lambda _: True, "a scan", change=spoil))

    def test_e_a_laser_that_tf_does_not_know_is_left_out_and_told(self):
        def lose(name, scan):
            if name == "rear":
                scan.header.frame_id = "nowhere"

        wait_until(lambda: self.step(change=lose) and self.told("nowhere"), "word of the frame")
        self.assert_is_the_room(self.merged_at(lambda _: True, "a scan", change=lose))


if __name__ == "__main__":
    run("merged_scans", ScanMerger)
