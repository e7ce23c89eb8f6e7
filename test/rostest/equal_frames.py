#!/usr/bin/env python3
"""Both maps in one frame: there is no transform to broadcast, and the node says what to do about it."""
from building import reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import NodeFixture, run

START = (12.3, 7.1, 0.7)  # T_reference_session


class EqualFrames(NodeFixture):
    def test_are_an_error_with_advice(self):
        self.reference.publish(reference_map("map"))

        match = self.match(session_map(START, frame="/map"), MapMatch.EQUAL_FRAMES)

        self.assertEqual(match.status_text, "equal_frames")
        self.assertIn('both in the frame "map"', match.reason)
        self.assertIn("_map_frame:=session_map", match.reason)
        self.assertEqual(match.dropped_session_maps, 1)
        self.log.wait_for(lambda line: line.level == line.ERROR and line.msg == match.reason, "error")
        self.assert_no_tf("map")
        self.assertEqual(self.match(session_map(START)).status_text, "matched")


if __name__ == "__main__":
    run("equal_frames", EqualFrames)
