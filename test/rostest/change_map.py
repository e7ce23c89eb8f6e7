#!/usr/bin/env python3
"""change_map, as map_server has it: the map of a YAML file becomes the reference map, or a code says why not."""
import os
import tempfile
import unittest

import rospy

from building import RESOLUTION, reference_map, session_map
from map_files import YAML, write_map
from node_fixture import DEADLINE, NodeFixture, run, wait_until

try:
    from nav_msgs.srv import LoadMap, LoadMapResponse
except ImportError:
    LoadMap = None

START = (12.3, 7.1, 0.7)  # T_reference_session
SHIFT = (5.0, -3.0)  # of the second reference map's building [m]
SHIFTED = (START[0] + SHIFT[0], START[1] + SHIFT[1], START[2])


@unittest.skipIf(LoadMap is None, "nav_msgs has no LoadMap before 1.13.1")
class ChangeMap(NodeFixture):
    def setUp(self):
        super().setUp()
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.yaml = write_map(reference_map(shift=SHIFT), self.directory.name, "shifted")
        rospy.wait_for_service("change_map", DEADLINE)
        self.change_map = rospy.ServiceProxy("change_map", LoadMap)
        # What is published while a latched topic connects comes twice, and the second one would replace another map again.
        wait_until(lambda: self.reference.get_num_connections() == 1, "the node listens")
        self.reference.publish(reference_map())
        self.match(session_map(START), reference_frame="map")

    def assert_refused(self, url, result, named):
        self.log.clear()
        self.assertEqual(self.change_map(url).result, result)
        line = self.log.wait_for(lambda line: line.level == line.ERROR and "change_map" in line.msg, "an error")
        self.assertIn(named, line.msg)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)

    def assert_changed(self, url):
        self.map_match.clear()

        answer = self.change_map(url)

        self.assertEqual(answer.result, LoadMapResponse.RESULT_SUCCESS)
        self.assertEqual(answer.map.header.frame_id, "map")
        self.assertEqual(list(answer.map.data), list(reference_map(shift=SHIFT).data))
        match = self.map_match.wait_for(lambda match: abs(match.x - SHIFTED[0]) < RESOLUTION, "a match in the other map")
        self.assert_pose(match.T_reference_session, SHIFTED)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, SHIFTED)

    def test_takes_the_map_of_a_path(self):
        self.assert_changed(self.yaml)

    def test_takes_the_map_of_a_url(self):
        self.assert_changed("file://" + self.yaml)

    def test_says_why_not_and_keeps_the_old_one(self):
        broken = os.path.join(self.directory.name, "broken.yaml")
        with open(broken, "w", encoding="utf-8") as file:
            file.write(YAML % ("shifted.pgm", -1.0, 0.0, 0.0))
        without_image = os.path.join(self.directory.name, "without_image.yaml")
        with open(without_image, "w", encoding="utf-8") as file:
            file.write(YAML % ("nowhere.pgm", RESOLUTION, 0.0, 0.0))

        self.assert_refused("/nowhere/map.yaml", LoadMapResponse.RESULT_MAP_DOES_NOT_EXIST, "/nowhere/map.yaml")
        self.assert_refused(broken, LoadMapResponse.RESULT_INVALID_MAP_METADATA, "resolution is -1")
        self.assert_refused(without_image, LoadMapResponse.RESULT_INVALID_MAP_DATA, "nowhere.pgm")
        self.assert_refused("http://maps/map.yaml", LoadMapResponse.RESULT_UNDEFINED_FAILURE, "expected a path or file:")


if __name__ == "__main__":
    run("change_map", ChangeMap)
