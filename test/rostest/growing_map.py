#!/usr/bin/env python3
"""A session map that grows as slam_gmapping's does: its origin moves by 32 cells, its cells stay where they were."""
from map_matcher.msg import MapMatch

from building import reference_map, session_map
from node_fixture import NodeFixture, run

START = (12.3, 7.1, -2.4)  # T_reference_session
ELSEWHERE = (9.1, 8.0, 0.6)
GROWTH = [  # origin's column and row, size [cells], how far the robot has seen [m]
    ((-64, -64), (128, 128), 5.0),
    ((-96, -64), (160, 160), 6.5),
    ((-96, -96), (192, 192), 8.0),
    ((-128, -128), (288, 288), 12.0),
]


class GrowingMap(NodeFixture):
    def test_keeps_its_place(self):
        self.reference.publish(reference_map())
        total_cells = 0
        for origin, size, seen in GROWTH:
            match = self.match(session_map(START, origin=(0.1 * origin[0], 0.1 * origin[1]), size=size, seen=seen))

            self.assert_pose(match.T_reference_session, START)
            self.assertGreater(match.total_cells, total_cells)
            total_cells = match.total_cells
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)

    def test_another_place_has_to_be_found_twice(self):
        self.reference.publish(reference_map())
        self.match(session_map(START))

        self.match(session_map(ELSEWHERE), status=MapMatch.UNCONFIRMED)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)

        self.assert_pose(self.match(session_map(ELSEWHERE, seen=7.9)).T_reference_session, ELSEWHERE)

    def test_only_the_newest_of_many_maps_needs_to_be_matched(self):
        self.reference.publish(reference_map())
        maps = [session_map(START, seen=seen) for seen in (5.0, 6.0, 7.0, 8.0)]
        for early in maps[:-1] * 5:
            self.session.publish(early)

        match = self.match(maps[-1])

        self.assert_pose(match.T_reference_session, START)


if __name__ == "__main__":
    run("growing_map", GrowingMap)
