#!/usr/bin/env python3
"""What rviz shows beside maps and matched cells: how the session stands, and where else the session map may lie."""
from visualization_msgs.msg import Marker

from building import FREE, OCCUPIED, RESOLUTION, SIZE, grid, is_wall, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import Listener, NodeFixture, run

START = (12.3, 7.1, 0.7)  # T_reference_session
WIDTH, HEIGHT = (cells * RESOLUTION for cells in SIZE)  # of the building [m]


def twin_buildings():
    """The building, and the same again beside it."""
    return grid("map", (0.0, 0.0), (2 * SIZE[0], SIZE[1]),
                lambda x, y: OCCUPIED if is_wall(x % WIDTH, y) else FREE)


def mean(points):
    return sum(point.x for point in points) / len(points), sum(point.y for point in points) / len(points)


class MatchDisplay(NodeFixture):
    def setUp(self):
        super().setUp()
        self.text = Listener("match_text", Marker)
        self.other_places = Listener("other_places", Marker)

    def wait_for_text(self, state):
        return self.text.wait_for(lambda marker: marker.text.startswith(state), "text that says " + state)

    def wait_for_other_places(self, action):
        return self.other_places.wait_for(lambda marker: marker.action == action, "other places")

    def test_says_above_the_reference_map_that_the_robot_is_localized(self):
        self.reference.publish(reference_map())
        match = self.match(session_map(START))

        text = self.wait_for_text("localized")

        self.assertEqual(text.type, Marker.TEXT_VIEW_FACING)
        self.assertEqual(text.header.frame_id, "map")
        self.assertAlmostEqual(text.pose.position.x, WIDTH / 2, places=3)
        self.assertGreater(text.pose.position.y - text.scale.z / 2, HEIGHT)
        self.assertIn("%.3f" % min(match.probability, 0.999), text.text)
        self.wait_for_other_places(Marker.DELETE)

    def test_shows_both_places_when_two_fit_equally_well(self):
        self.reference.publish(twin_buildings())
        match = self.match(session_map(START), MapMatch.AMBIGUOUS)

        self.assertEqual(self.wait_for_text("searching").text, "searching: ambiguous")
        places = self.wait_for_other_places(Marker.ADD)

        self.assertEqual(places.header.frame_id, "map")
        self.assertEqual(len(places.points), 2 * match.total_cells)
        left, right = sorted(mean(half) for half in (places.points[:match.total_cells],
                                                      places.points[match.total_cells:]))
        self.assertAlmostEqual(right[0] - left[0], WIDTH, delta=RESOLUTION)
        self.assertAlmostEqual(right[1], left[1], delta=RESOLUTION)

    def test_takes_text_and_other_places_away_with_the_map_that_they_are_about(self):
        self.reference.publish(twin_buildings())
        self.match(session_map(START), MapMatch.AMBIGUOUS)
        self.wait_for_other_places(Marker.ADD)
        self.text.clear()
        self.other_places.clear()

        self.reference.publish(reference_map())

        self.text.wait_for(lambda marker: marker.action == Marker.DELETE, "end of the text about the map before")
        self.wait_for_other_places(Marker.DELETE)
        self.wait_for_text("localized")


if __name__ == "__main__":
    run("match_display", MatchDisplay)
