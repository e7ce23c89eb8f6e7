#!/usr/bin/env python3
"""The crowd_simulator's topics agree with each other and with the map, and the same seed gives the same drive."""
import math
import subprocess
import time
import unittest

import geometry_msgs.msg
import roslib.packages
import rospy
import rostest
import tf2_msgs.msg
from nav_msgs.msg import OccupancyGrid, Odometry
from rosgraph_msgs.msg import Clock, Log
from sensor_msgs.msg import LaserScan

from map_matcher.msg import PersonDetections
from node_fixture import Listener, wait_until

DEADLINE = 60.0  # [s], for a drive to end
BEGIN = 1000.0  # [s], simulated time
OCCUPIED = 65  # [percent]

PEPPER = {"rear_lidar": "true", "lidar_x": 0.245, "radius": 0.3, "beams": 91, "rate": 10.0, "density": 0.5,
          "detector_latency": 0.5, "duration": 4.0, "real_time_factor": 2.0, "start_delay": 1.5}
PEPPER_TOPICS = {"/tf": tf2_msgs.msg.TFMessage, "/odom": Odometry, "/ground_truth": geometry_msgs.msg.PoseStamped,
                 "/people_truth": geometry_msgs.msg.PoseArray, "/true_map": OccupancyGrid}
PEPPER_FRAMES = {"/odom": "odom", "/ground_truth": "map", "/people_truth": "map", "/true_map": "map"}
for side in ("front", "rear"):
    for topic, kind in (("/sick_laser_%s/scan", LaserScan), ("/dr_spaam_detections/%s", geometry_msgs.msg.PoseArray),
                        ("/person_detections/%s", PersonDetections)):
        PEPPER_TOPICS[topic % side] = kind
        PEPPER_FRAMES[topic % side] = "sick_laser_" + side
NUM_STEPS = 41


def near(value, other, tolerance=1e-6):
    return abs(value - other) <= tolerance


def stamps_of(messages):
    return [message.header.stamp.to_sec() for message in messages]


class TrueMap:
    """Where walls are."""

    def __init__(self, message):
        self._info = message.info
        self._occupied = {(i % message.info.width, i // message.info.width)
                          for i, value in enumerate(message.data) if value >= OCCUPIED}

    def has_wall_near(self, x, y, distance):
        """Whether a wall is within the distance [m] of a point, by whole cells."""
        resolution = self._info.resolution
        column = math.floor((x - self._info.origin.position.x) / resolution)
        row = math.floor((y - self._info.origin.position.y) / resolution)
        reach = math.ceil(distance / resolution)
        return any((column + i, row + j) in self._occupied
                   for i in range(-reach, reach + 1) for j in range(-reach, reach + 1))


def pose_of(message):
    """(x, y, yaw) of a geometry_msgs/Pose or Transform."""
    position = getattr(message, "position", None) or message.translation
    rotation = getattr(message, "orientation", None) or message.rotation
    return position.x, position.y, 2.0 * math.atan2(rotation.z, rotation.w)


def moved(pose, x, y):
    """Where a point of the frame at this pose is."""
    return (pose[0] + math.cos(pose[2]) * x - math.sin(pose[2]) * y,
            pose[1] + math.sin(pose[2]) * x + math.cos(pose[2]) * y)


class CrowdSimulator(unittest.TestCase):
    def drive(self, **parameters):
        """Runs the node until its drive is over; returns the messages of every topic, the clock and the log."""
        listeners = {topic: Listener(topic, kind) for topic, kind in PEPPER_TOPICS.items()}
        listeners["/clock"] = Listener("/clock", Clock)
        listeners["/rosout"] = Listener("/rosout", Log)
        node = roslib.packages.find_node("map_matcher", "crowd_simulator")[0]
        arguments = ["_%s:=%s" % item for item in parameters.items()]
        begin = time.monotonic()
        done = subprocess.run([node, "__name:=under_test", *arguments], timeout=DEADLINE, check=False)
        self.assertEqual(done.returncode, 0)
        self.took = time.monotonic() - begin
        wait_until(lambda: len(listeners["/person_detections/rear"].messages) == NUM_STEPS, "the last detections")
        return {topic: list(listener.messages) for topic, listener in listeners.items()}

    def test_a_pepper(self):
        first = self.drive(seed=5, **PEPPER)
        self.there_is_every_topic_with_its_frame_and_stamps(first)
        self.the_clock_advances_smoothly_and_no_faster_than_asked_for(first)
        self.detections_come_late(first)
        self.low_scores_are_told_only_with_scores(first)
        self.scans_show_the_walls_and_people_of_the_truth(first)
        again = self.drive(seed=5, **PEPPER)
        other = self.drive(seed=6, **PEPPER)
        for topic in PEPPER_TOPICS:
            self.assertEqual(first[topic], again[topic], topic)
        for topic in ("/sick_laser_front/scan", "/sick_laser_rear/scan", "/people_truth", "/person_detections/rear"):
            self.assertNotEqual(first[topic], other[topic], topic)

    def there_is_every_topic_with_its_frame_and_stamps(self, messages):
        expected = [BEGIN + 0.1 * i for i in range(NUM_STEPS)]
        for topic, frame in PEPPER_FRAMES.items():
            self.assertEqual({message.header.frame_id for message in messages[topic]}, {frame}, topic)
            stamps = stamps_of(messages[topic])
            self.assertEqual(len(stamps), 1 if topic == "/true_map" else NUM_STEPS, topic)
            self.assertTrue(all(near(*pair) for pair in zip(stamps, expected)), topic)
        for message in messages["/tf"]:
            self.assertEqual([(t.header.frame_id, t.child_frame_id) for t in message.transforms],
                             [("odom", "base_link"), ("base_link", "sick_laser_front"),
                              ("base_link", "sick_laser_rear")])

    def the_clock_advances_smoothly_and_no_faster_than_asked_for(self, messages):
        times = [message.clock.to_sec() for message in messages["/clock"]]
        self.assertEqual(times, sorted(times))
        self.assertTrue(near(times[0], BEGIN) and times[-1] >= BEGIN + 4.5, (times[0], times[-1]))
        self.assertLess(max(b - a for a, b in zip(times, times[1:])), 0.0101)
        self.assertGreater(self.took, PEPPER["start_delay"] + PEPPER["duration"] / PEPPER["real_time_factor"])
        self.assertFalse([line.msg for line in messages["/rosout"] if "use_sim_time" in line.msg])

    def detections_come_late(self, messages):
        """Half a second after their scan: by the clock at the end, where nothing follows that could be late."""
        last = messages["/person_detections/front"][-1].header.stamp.to_sec() + PEPPER["detector_latency"]
        self.assertTrue(near(messages["/clock"][-1].clock.to_sec(), last, 1e-4), last)

    def low_scores_are_told_only_with_scores(self, messages):
        num_low = 0
        for side in ("front", "rear"):
            for poses, scored in zip(messages["/dr_spaam_detections/" + side], messages["/person_detections/" + side]):
                self.assertEqual(len(poses.poses), sum(d.score >= 0.4 for d in scored.detections))
                num_low += sum(d.score < 0.4 for d in scored.detections)
        self.assertGreater(num_low, 0)

    def scans_show_the_walls_and_people_of_the_truth(self, messages):
        true_map = TrueMap(messages["/true_map"][0])
        num_points = num_explained = num_on_people = 0
        for side, mount in (("front", (0.245, 0.0, 0.0)), ("rear", (-0.245, 0.0, math.pi))):
            for scan, truth, people in list(zip(messages["/sick_laser_%s/scan" % side], messages["/ground_truth"],
                                                messages["/people_truth"]))[::8]:
                base = pose_of(truth.pose)
                laser = (*moved(base, mount[0], mount[1]), base[2] + mount[2])
                for i, distance in enumerate(scan.ranges):
                    if math.isinf(distance):
                        continue
                    angle = scan.angle_min + i * scan.angle_increment
                    x, y = moved(laser, distance * math.cos(angle), distance * math.sin(angle))
                    is_wall = true_map.has_wall_near(x, y, 0.15)
                    is_person = any(math.hypot(x - p.position.x, y - p.position.y) < 0.6 for p in people.poses)
                    num_points += 1
                    num_explained += is_wall or is_person
                    num_on_people += is_person and not is_wall
        self.assertGreater(num_points, 500)
        self.assertGreater(num_on_people, 50)
        self.assertGreater(num_explained, 0.995 * num_points)


if __name__ == "__main__":
    rospy.init_node("crowd_simulator_test")
    rostest.rosrun("map_matcher", "crowd_simulator", CrowdSimulator)
