#!/usr/bin/env python3
"""Maps that cannot be used are dropped with their reason and counted; the node goes on with what it has."""
import math

from building import FREE, OCCUPIED, UNKNOWN, grid, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import NodeFixture, run

START = (12.3, 7.1, 0.7)  # T_reference_session


def with_missing_value():
    message = session_map(START)
    message.data = message.data[:-1]
    return message


def with_value(value):
    message = session_map(START)
    message.data[7] = value
    return message


def with_origin_nan():
    message = session_map(START)
    message.info.origin.position.x = float("nan")
    return message


def with_quaternion(w):
    message = session_map(START)
    message.info.origin.orientation.z = 0.0
    message.info.origin.orientation.w = w
    return message


def with_resolution(resolution):
    message = session_map(START)
    message.info.resolution = resolution
    return message


def of(value):
    return grid("session_map", (0.0, 0.0), (192, 192), lambda x, y: value)


def few_cells():
    return grid("session_map", (0.0, 0.0), (192, 192), lambda x, y: OCCUPIED if x < 0.1 and y < 5.0 else FREE)


def empty():
    return grid("session_map", (0.0, 0.0), (0, 0), None)


BAD_MAPS = [  # map, status, what the reason names
    (with_missing_value(), MapMatch.INVALID_MAP, "36863 values, expected width x height = 192 x 192"),
    (with_value(101), MapMatch.INVALID_MAP, "value 101 at index 7"),
    (with_origin_nan(), MapMatch.INVALID_MAP, "origin has position (nan"),
    (with_quaternion(0.5), MapMatch.INVALID_MAP, "of norm 0.5, expected norm 1"),
    (with_quaternion(0.0), MapMatch.INVALID_MAP, "of norm 0, expected norm 1"),
    (with_resolution(0.0), MapMatch.INVALID_MAP, "resolution"),
    (with_resolution(float("nan")), MapMatch.INVALID_MAP, "resolution"),
    (with_resolution(-0.05), MapMatch.INVALID_MAP, "resolution"),
    (session_map(START, frame=""), MapMatch.INVALID_MAP, "frame_id"),
    (empty(), MapMatch.INVALID_MAP, "0"),
    (of(FREE), MapMatch.TOO_FEW_SESSION_CELLS, "0 occupied cells"),
    (few_cells(), MapMatch.TOO_FEW_SESSION_CELLS, "50 occupied cells, expected at least min_session_cells = 100"),
]


class BadMaps(NodeFixture):
    def test_are_dropped_and_counted_while_the_last_good_match_stays(self):
        self.reference.publish(reference_map())
        self.match(session_map(START))

        for count, (bad_map, status, reason) in enumerate(BAD_MAPS, start=1):
            match = self.match(bad_map, status)

            self.assertIn(reason, match.reason)
            self.assertEqual(match.dropped_session_maps, count)
            self.assertTrue(math.isnan(match.x) and math.isnan(match.T_reference_session.translation.x))
        self.log.wait_for(lambda line: line.level == line.WARN and "dropped (1 so far)" in line.msg, "warning")
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)
        self.assert_pose(self.match(session_map(START)).T_reference_session, START)

    def test_a_bad_reference_map_leaves_the_good_one_in_use(self):
        self.reference.publish(reference_map())
        dropped = self.match(session_map(START)).dropped_reference_maps
        bad = reference_map()
        bad.data = bad.data[:-1]
        for message, reason in ((bad, "38399 values"), (of(UNKNOWN), "no occupied cell"), (of(FREE), "no occupied")):
            self.log.clear()
            self.reference.publish(message)
            self.log.wait_for(lambda line: "reference map" in line.msg and reason in line.msg, "warning")

        match = self.match(session_map(START))

        self.assertEqual(match.dropped_reference_maps, dropped + 3)
        self.assert_pose(match.T_reference_session, START)


if __name__ == "__main__":
    run("bad_maps", BadMaps)
