#!/usr/bin/env python3
"""What move_base's costmaps make of the node's map and tf, while the robot is localized and when it no longer is.

The package move_base is not to be had everywhere. The costmap of this test does with topics and frames what costmap_2d
does: its static layer takes the map of a topic, whatever its frame; its obstacle layer moves each raw scan into the
global frame at the scan's stamp; and the robot's pose is too old when it is older than transform_tolerance.
"""
import rospy
import tf2_ros
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan

from building import FREE, OCCUPIED, grid, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import Listener, NodeFixture, run, stamped_transform, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session
TRANSFORM_TOLERANCE = 0.5  # [s], of config/navigation/costmap_common.yaml
PERIOD = 0.05  # [s]


def of_another_building():
    """Pillars, 0.6 m apart."""
    return grid("map", (0.0, 0.0), (160, 160),
                lambda x, y: OCCUPIED if round(10 * x) % 6 == 0 and round(10 * y) % 6 == 0 else FREE)


class Costmap:
    def __init__(self, buffer, global_frame):
        self._buffer, self._global_frame = buffer, global_frame
        self.scans_used = 0
        self._scans = rospy.Subscriber("scan", LaserScan, self._on_scan, queue_size=10)

    def _on_scan(self, scan):
        if self._buffer.can_transform(self._global_frame, scan.header.frame_id, scan.header.stamp,
                                      rospy.Duration(TRANSFORM_TOLERANCE)):
            self.scans_used += 1

    def knows_the_robot(self):
        """Whether move_base goes on driving."""
        try:
            stamp = self._buffer.lookup_transform(self._global_frame, "base_link", rospy.Time()).header.stamp
        except tf2_ros.TransformException:
            return False
        return (rospy.Time.now() - stamp).to_sec() < TRANSFORM_TOLERANCE


class NavigationFrames(NodeFixture):
    def setUp(self):
        super().setUp()
        self.buffer = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.buffer)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.scans = rospy.Publisher("scan", LaserScan, queue_size=10)
        self.driving = rospy.Timer(rospy.Duration(PERIOD), self.drive)
        self.addCleanup(self.driving.shutdown)

    def drive(self, _):
        """What the robot's drivers and its mapper send."""
        now = rospy.Time.now()
        self.broadcaster.sendTransform([stamped_transform("session_map", "odom", (0.0, 0.0, 0.0), now),
                                        stamped_transform("odom", "base_link", (1.0, 0.5, 0.0), now),
                                        stamped_transform("base_link", "laser", (0.1, 0.0, 0.0), now)])
        scan = LaserScan()
        scan.header.stamp, scan.header.frame_id = now, "laser"
        self.scans.publish(scan)

    def test_the_planner_drives_in_the_reference_map_as_long_as_the_robot_is_localized_in_it(self):
        planner, driver = Costmap(self.buffer, "map"), Costmap(self.buffer, "odom")
        wait_until(driver.knows_the_robot, "the local costmap knows the robot")
        self.assertFalse(planner.knows_the_robot())

        self.reference.publish(reference_map())
        self.match(session_map(START))

        static = Listener("map", OccupancyGrid).wait_for(lambda _: True, "the map of the static layer")
        self.assertEqual(static.header.frame_id, "map", "costmap_2d does not look at the frame: it has to be right")
        self.assertEqual(static.info.width, reference_map().info.width)
        wait_until(planner.knows_the_robot, "the global costmap knows the robot")
        used = planner.scans_used
        wait_until(lambda: planner.scans_used > used + 10, "the global costmap takes scans")

        self.reference.publish(of_another_building())
        self.match(session_map(START), MapMatch.BELOW_ACCEPTANCE_RATIO)

        wait_until(lambda: not planner.knows_the_robot(), "the global costmap says that tf is too old")
        used = driver.scans_used
        wait_until(lambda: driver.scans_used > used + 10, "the local costmap goes on seeing obstacles")
        self.assertTrue(driver.knows_the_robot())
        self.assertFalse(planner.knows_the_robot())


if __name__ == "__main__":
    run("navigation_frames", NavigationFrames)
