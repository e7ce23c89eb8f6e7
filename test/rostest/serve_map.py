#!/usr/bin/env python3
"""The reference map for planners, as map_server serves one, on request; never on the topic that maps are taken from."""
import rospy
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap

from building import reference_map, session_map
from node_fixture import DEADLINE, Listener, NodeFixture, run
from node_runs import BAD_INPUT, run_node

START = (12.3, 7.1, 0.7)  # T_reference_session


class ServeMap(NodeFixture):
    def setUp(self):
        super().setUp()
        rospy.wait_for_service("static_map", DEADLINE)
        self.static_map = rospy.ServiceProxy("static_map", GetMap)

    def test_1_answers_no_service_before_there_is_a_map(self):
        with self.assertRaises(rospy.ServiceException):
            self.static_map()

    def test_2_serves_the_map_in_use_and_the_one_after_it(self):
        for frame, shift in (("map", (0.0, 0.0)), ("other_map", (5.0, -3.0))):
            expected = reference_map(frame, shift)
            self.reference.publish(expected)
            self.match(session_map(START), reference_frame=frame)

            served = Listener("map", OccupancyGrid).wait_for(lambda m: m.header.frame_id == frame, "map")  # latched
            metadata = Listener("map_metadata", MapMetaData).wait_for(lambda _: True, "map_metadata")
            answer = self.static_map().map

            for actual in (served, answer):
                self.assertEqual(actual.header.frame_id, frame)
                self.assertEqual(actual.data, tuple(expected.data))
                self.assertEqual(actual.info.origin, expected.info.origin)
            self.assertEqual(metadata, served.info)

    def test_3_is_refused_on_the_topic_that_maps_are_taken_from(self):
        for taken in ("session_map", "reference_map"):
            code, output = run_node("map_matcher_node", {taken: "map"}, serve_map="true")
            self.assertEqual(code, BAD_INPUT)
            self.assertIn("~serve_map is true, but maps are taken from /map", output)

    def test_4_the_map_in_use_is_no_new_one(self):
        code, output = run_node("map_matcher_node", {"~reference_map": "reference_map"})
        self.assertEqual(code, BAD_INPUT)
        self.assertIn("~reference_map is remapped to /reference_map, but maps are taken from /reference_map", output)


if __name__ == "__main__":
    run("serve_map", ServeMap)
