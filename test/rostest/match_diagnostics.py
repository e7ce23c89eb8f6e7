#!/usr/bin/env python3
"""The node tells on /diagnostics what it waits for, and whether the alignment on tf is that of the last map."""
from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import PoseWithCovarianceStamped

from building import FREE, OCCUPIED, grid, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import Listener, NodeFixture, broadcast_static, run, wait_for_diagnostic

START = (12.3, 7.1, 0.7)  # T_reference_session


def of_another_building():
    """Pillars, 0.6 m apart."""
    return grid("session_map", (-4.0, -4.0), (160, 160),
                lambda x, y: OCCUPIED if round(10 * x) % 6 == 0 and round(10 * y) % 6 == 0 else FREE)


class MatchDiagnostics(NodeFixture):
    def wait_for(self, name, level, text):
        return wait_for_diagnostic("map_matcher: " + name, lambda s: s.level == level and text in s.message)

    def test_from_the_start_to_a_match_and_on(self):
        self.wait_for("reference map", DiagnosticStatus.WARN, "no reference map yet on /reference_map")
        self.wait_for("session maps", DiagnosticStatus.WARN, "no session map yet on /session_map")
        self.wait_for("alignment", DiagnosticStatus.WARN, "none yet")

        self.match(session_map(START), MapMatch.NO_REFERENCE)
        self.wait_for("alignment", DiagnosticStatus.WARN, "none yet: there is no reference map yet")

        self.reference.publish(reference_map())
        reference = self.wait_for("reference map", DiagnosticStatus.OK, "in use")
        self.assertEqual(reference["size [cells]"], "%d x %d" % (reference_map().info.width, reference_map().info.height))
        self.match(session_map(START))
        self.wait_for("alignment", DiagnosticStatus.WARN, "whether the mapper has lost the robot is not checked: "
                      'tf knows no frame "base_link"')
        pose = Listener("match_pose", PoseWithCovarianceStamped)
        self.static_broadcaster = broadcast_static("session_map", "base_link", (0.0, 0.0, 0.0))
        self.match(session_map(START))
        pose.wait_for(lambda _: True, "match_pose: the node knows where the robot is")
        match = self.match(session_map(START))
        alignment = self.wait_for("alignment", DiagnosticStatus.OK, "that of the last map")
        self.assertEqual(alignment["x, y [m], yaw [rad]"], "%.3f, %.3f, %.4f" % (match.x, match.y, match.yaw))
        self.assertGreater(match.maps_since_proof, 0, "the place is followed meanwhile")
        self.assertEqual(alignment["maps since the last proof"], str(match.maps_since_proof))
        self.assertEqual(alignment["probability"], "%.4f" % match.probability)
        self.assertEqual(alignment["state"], "localized")

        self.match(of_another_building(), MapMatch.BELOW_ACCEPTANCE_RATIO)
        alignment = self.wait_for("alignment", DiagnosticStatus.WARN, "no map has matched since: ")
        self.assertEqual(alignment["last status"], "below_acceptance_ratio")
        self.assertEqual(alignment["searches since"], "1")

        bad = session_map(START)
        bad.data = bad.data[:-1]
        self.match(bad, MapMatch.INVALID_MAP)
        session = self.wait_for("session maps", DiagnosticStatus.WARN, "the last one was dropped: ")
        self.assertEqual((session["session maps"], session["dropped"]), ("6", "1"))

        self.match(session_map(START))
        self.wait_for("alignment", DiagnosticStatus.OK, "that of the last map")
        self.wait_for("session maps", DiagnosticStatus.OK, "arrive")


if __name__ == "__main__":
    run("match_diagnostics", MatchDiagnostics)
