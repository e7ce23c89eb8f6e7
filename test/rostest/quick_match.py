#!/usr/bin/env python3
"""A session map is matched to the reference map and its transform is broadcast."""
from building import reference_map, session_map
from node_fixture import NodeFixture, run

START = (12.3, 7.1, 0.7)  # T_reference_session


class QuickMatch(NodeFixture):
    def test_nothing_before_the_first_match_and_the_right_transform_after_it(self):
        self.reference.publish(reference_map())
        self.assert_no_tf("session_map")

        match = self.match(session_map(START))

        self.assertEqual(match.status_text, "matched")
        self.assertEqual((match.reference_frame, match.session_frame), ("map", "session_map"))
        self.assertEqual(match.header.frame_id, "map")
        self.assertTrue(match.refined)
        self.assertGreater(match.ratio, 0.8)
        self.assertEqual([stage.name for stage in match.stages], ["coarse", "fine", "exact"])
        self.assertTrue(match.certified)
        self.assertGreaterEqual(match.margin, 0.1)
        self.assertEqual(match.upper_bound, match.hit_ratio)
        self.assert_pose(match.T_reference_session, START)
        self.assertAlmostEqual(match.x, match.T_reference_session.translation.x)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)


if __name__ == "__main__":
    run("quick_match", QuickMatch)
