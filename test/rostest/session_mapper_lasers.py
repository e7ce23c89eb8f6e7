#!/usr/bin/env python3
"""A session_mapper with two lasers draws with the one that is there, and tells that the other is silent."""
import itertools
import unittest

import rosgraph_msgs.msg
import rospy
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan

from node_fixture import Listener, run, wait_until
from scanned_room import RobotInRoom, distance_to_wall

BEGIN = 100.0  # [s], simulated time of the first scan


class SessionMapperLasers(unittest.TestCase):
    def test_one_laser_of_two_is_silent(self):
        maps = Listener("map", OccupancyGrid)
        log = Listener("/rosout", rosgraph_msgs.msg.Log)
        robot = RobotInRoom()
        rear = rospy.Publisher("rear_scan", LaserScan, queue_size=10)
        wait_until(robot.is_heard, "the node subscribes")
        times = (BEGIN + 0.1 * k for k in itertools.count())

        def is_told(text):
            robot.step(next(times), (0.0, 0.0, 0.0))
            return any(text in line.msg for line in list(log.messages))

        wait_until(lambda: is_told("no scan of /rear_scan could be used"), "word of the silent laser")
        grid = maps.messages[-1]
        self.assertGreater(self.walls(grid), 250)

        def is_back():
            time = next(times)
            robot.step(time, (0.0, 0.0, 0.0))
            rear.publish(robot.scan_message(rospy.Time.from_sec(time), (0.0, 0.0, 0.0), 360))
            return any("scans of /rear_scan are drawn again" in line.msg for line in list(log.messages))

        wait_until(is_back, "word that it is back")

    def walls(self, grid):
        """Number of occupied cells, all of which have to be walls of the room."""
        info = grid.info
        count = 0
        for index, value in enumerate(grid.data):
            if value == 100:
                count += 1
                x = info.origin.position.x + (index % info.width + 0.5) * info.resolution
                y = info.origin.position.y + (index // info.width + 0.5) * info.resolution
                self.assertLess(distance_to_wall(x, y), 0.07, (x, y))
        return count


if __name__ == "__main__":
    run("session_mapper_lasers", SessionMapperLasers)
