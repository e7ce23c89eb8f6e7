#!/usr/bin/env python3
"""The session_mapper node draws what the robot sees and serves it as slam_gmapping does."""
import unittest

import rosgraph_msgs.msg
import rospy
import tf2_msgs.msg
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap

from node_fixture import Listener, is_between, run, wait_until
from scanned_room import RobotInRoom, distance_to_wall

BEGIN = 100.0  # [s], simulated time of the first scan
TF_DELAY = 0.05  # [s]


def pose_at(time):
    return (-1.0 + 0.3 * (time - BEGIN), 0.0, 0.1 * (time - BEGIN))


def walls(grid):
    """Centres of the occupied cells [m]."""
    info = grid.info
    for index, value in enumerate(grid.data):
        if value == 100:
            yield (info.origin.position.x + (index % info.width + 0.5) * info.resolution,
                   info.origin.position.y + (index // info.width + 0.5) * info.resolution)


class SessionMapperSession(unittest.TestCase):
    def setUp(self):
        self.map = Listener("map", OccupancyGrid)
        self.tf = Listener("/tf", tf2_msgs.msg.TFMessage)
        self.log = Listener("/rosout", rosgraph_msgs.msg.Log)
        self.robot = RobotInRoom()
        wait_until(self.robot.is_heard, "the node subscribes")

    def test_session(self):
        self.get_map = rospy.ServiceProxy("dynamic_map", GetMap)
        self.get_map.wait_for_service(timeout=20.0)
        self.there_is_nothing_before_the_first_scan()
        self.the_first_scan_gives_the_first_map()
        self.the_odometry_frame_hangs_below_the_session_frame()
        self.a_late_subscriber_gets_the_map()
        self.the_map_grows_with_the_motion()
        self.a_standing_robot_gets_new_maps()
        self.a_scan_with_other_beams_is_drawn()
        self.a_new_session_begins_when_time_goes_back()

    def there_is_nothing_before_the_first_scan(self):
        with self.assertRaises(rospy.ServiceException):
            self.get_map()
        self.assertEqual(self.map.messages, [])
        self.assertFalse(self.session_transforms())

    def the_first_scan_gives_the_first_map(self):
        first = self.drive_until_map(BEGIN, after=0.0)
        self.assertEqual(first.header.frame_id, "session_map")
        self.assertAlmostEqual(first.header.stamp.to_sec(), BEGIN)
        self.assertLessEqual(set(first.data), {-1, 0, 100})
        self.assert_walls_of_the_room(first)

    def the_odometry_frame_hangs_below_the_session_frame(self):
        stamps = []
        for time in (BEGIN + 0.1, BEGIN + 0.2, BEGIN + 0.3):
            self.robot.set_time(time)
            wait_until(lambda: any(abs(t.header.stamp.to_sec() - time - TF_DELAY) < 1e-6
                                   for t in self.session_transforms()), "tf at %g" % time)
        for transform in self.session_transforms():
            stamps.append(transform.header.stamp)
            self.assertLess(abs(transform.transform.translation.x), 0.02)
        self.assertEqual(stamps, sorted(set(stamps)))

    def a_late_subscriber_gets_the_map(self):
        grid = rospy.wait_for_message("map", OccupancyGrid, timeout=10.0)
        self.assertEqual(grid.data, self.map.messages[-1].data)
        self.assertEqual(rospy.wait_for_message("map_metadata", MapMetaData, timeout=10.0), grid.info)

    def the_map_grows_with_the_motion(self):
        for i in range(1, 10):
            time = BEGIN + i
            self.step_until_used(time, pose_at(time))
        later = self.map.wait_for(lambda grid: grid.header.stamp.to_sec() > BEGIN + 2.0, "a later map")
        self.assert_walls_of_the_room(later)
        # map_update_interval is 2 s: there are fewer maps than scans.
        stamps = [grid.header.stamp.to_sec() for grid in self.map.messages]
        self.assertTrue(all(b - a > 2.0 for a, b in zip(stamps, stamps[1:])), stamps)
        self.assert_walls_of_the_room(self.get_map().map)

    def a_standing_robot_gets_new_maps(self):
        before = len(self.map.messages)
        for i in range(1, 8):
            time = BEGIN + 9.0 + i
            self.step_until_used(time, pose_at(BEGIN + 9.0))
        later = self.map.wait_for(lambda grid: grid.header.stamp.to_sec() > BEGIN + 14.0, "a map of the standing robot")
        self.assert_walls_of_the_room(later)
        self.assertLess(len(self.map.messages), before + 4)  # map_update_interval is 2 s

    def a_scan_with_other_beams_is_drawn(self):
        time = BEGIN + 20.0
        self.drive_until_map(time, after=BEGIN + 19.5, pose=(0.5, 0.3, 1.5), beams=181)

    def a_new_session_begins_when_time_goes_back(self):
        self.log.clear()
        elsewhere = (2.5, 1.0, -2.0)
        times = iter(range(10**6))

        def is_told():
            self.robot.set_time(BEGIN - 60.0 + 0.01 * next(times))
            return any("a new session begins" in line.msg for line in list(self.log.messages))
        wait_until(is_told, "word of the new session")
        self.map.clear()
        grid = self.drive_until_map(BEGIN - 49.0, after=0.0, pose=elsewhere)
        self.assertAlmostEqual(grid.header.stamp.to_sec(), BEGIN - 49.0)
        self.assert_walls_of_the_room(grid)

    def drive_until_map(self, time, after, pose=None, beams=360):
        """Sends a scan, again until a map newer than `after`, but no newer than the scan, comes: connections take their
        time, and so do maps of the session before."""
        def is_new(grid):
            return after < grid.header.stamp.to_sec() < time + 1e-6

        def has_map():
            self.robot.step(time, pose or pose_at(time), beams)
            return any(is_new(grid) for grid in list(self.map.messages))
        wait_until(has_map, "a map newer than %g" % after)
        return self.map.wait_for(is_new, "the map")

    def step_until_used(self, time, pose):
        """Sends a scan until the node has taken it, which shows in the stamp of dynamic_map. More than once, because
        tf2's message filter may lose one whose transform comes at the very moment."""
        def is_used():
            self.robot.step(time, pose)
            return self.get_map().map.header.stamp.to_sec() > time - 1e-6
        wait_until(is_used, "the scan of %g is used" % time)

    def session_transforms(self):
        return [t for tf in list(self.tf.messages) for t in tf.transforms if is_between(t, "session_map", "odom")]

    def assert_walls_of_the_room(self, grid):
        centres = list(walls(grid))
        self.assertGreater(len(centres), 250)
        for x, y in centres:
            self.assertLess(distance_to_wall(x, y), 0.07, (x, y))


if __name__ == "__main__":
    run("session_mapper_session", SessionMapperSession)
