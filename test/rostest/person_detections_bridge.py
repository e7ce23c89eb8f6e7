#!/usr/bin/env python3
"""The bridge reads the messages of other detectors, whose packages are not installed."""
import unittest

import genpy.dynamic
import rospy
import rostest

from map_matcher.msg import PersonDetections
from node_fixture import Listener, wait_until

SEPARATOR = "\n" + "=" * 80 + "\n"
HEADER = SEPARATOR + "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"
POINT = SEPARATOR + "MSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n"

MEASUREMENTS = ("people_msgs/PositionMeasurementArray",
                "Header header\nPositionMeasurement[] people\nfloat32[] cooccurrence\n" + SEPARATOR +
                "MSG: people_msgs/PositionMeasurement\nHeader header\nstring name\nstring object_id\n"
                "geometry_msgs/Point pos\nfloat64 reliability\nfloat64[9] covariance\nbyte initialization\n" +
                HEADER + POINT)

PERSONS = ("frame_msgs/DetectedPersons",
           "Header header\nDetectedPerson[] detections\n" + SEPARATOR +
           "MSG: frame_msgs/DetectedPerson\nuint64 detection_id\nfloat64 confidence\n"
           "geometry_msgs/PoseWithCovariance pose\nstring modality\n" + SEPARATOR +
           "MSG: geometry_msgs/PoseWithCovariance\nPose pose\nfloat64[36] covariance\n" + SEPARATOR +
           "MSG: geometry_msgs/Pose\nPoint position\nQuaternion orientation\n" + SEPARATOR +
           "MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n" + HEADER + POINT)


class PersonDetectionsBridge(unittest.TestCase):
    def bridged(self, definition, fill):
        """What the bridge makes of a message of this definition, filled by `fill(message, types)`."""
        types = genpy.dynamic.generate_dynamic(*definition)
        out = Listener("person_detections", PersonDetections)
        publisher = rospy.Publisher("people", types[definition[0]], queue_size=10, latch=True)
        message = types[definition[0]]()
        message.header.frame_id, message.header.stamp = "laser", rospy.Time(12, 345)
        fill(message, types)
        wait_until(lambda: publisher.get_num_connections() > 0, "a connection to the bridge")
        out.wait_until_served()
        publisher.publish(message)
        answer = out.wait_for(lambda m: m.header.stamp == rospy.Time(12, 345), "detections")
        publisher.unregister()
        return answer

    def test_position_measurements(self):
        def fill(message, types):
            person = types["people_msgs/PositionMeasurement"]()
            person.pos.x, person.pos.y, person.reliability = 1.0, -2.0, 0.75
            message.people.append(person)

        answer = self.bridged(MEASUREMENTS, fill)

        self.assertEqual(answer.header.frame_id, "laser")
        self.assertEqual([(d.position.x, d.position.y, d.score) for d in answer.detections], [(1.0, -2.0, 0.75)])

    def test_detected_persons(self):
        def fill(message, types):
            person = types["frame_msgs/DetectedPerson"]()
            person.pose.pose.position.x, person.confidence = 3.0, 0.5
            message.detections.append(person)

        answer = self.bridged(PERSONS, fill)

        self.assertEqual([(d.position.x, d.score) for d in answer.detections], [(3.0, 0.5)])


if __name__ == "__main__":
    rospy.init_node("person_detections_bridge_test")
    rostest.rosrun("map_matcher", "person_detections_bridge", PersonDetectionsBridge)
