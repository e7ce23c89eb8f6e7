#!/usr/bin/env python3
"""A mapper that has lost the robot: its map still matches, but not where the robot is, and tf must not say otherwise."""
import math

from diagnostic_msgs.msg import DiagnosticStatus
from geometry_msgs.msg import PoseWithCovarianceStamped

from building import FREE, OCCUPIED, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import Listener, NodeFixture, broadcast_static, run, wait_for_diagnostic

START = (12.3, 7.1, 0.7)  # T_reference_session
ROBOT = (3.0, -2.0)  # in the session map


def with_false_walls():
    """The session map with pillars around the robot that are not there."""
    message = session_map(START)
    info = message.info
    for row in range(info.height):
        for column in range(info.width):
            x = info.origin.position.x + (column + 0.5) * info.resolution
            y = info.origin.position.y + (row + 0.5) * info.resolution
            if math.hypot(x - ROBOT[0], y - ROBOT[1]) < 3.0:
                message.data[row * info.width + column] = OCCUPIED if column % 15 < 2 and row % 15 < 2 else FREE
    return message


class RobotAstray(NodeFixture):
    def test_takes_the_alignment_off_tf_until_the_map_fits_around_the_robot(self):
        self.static_broadcaster = broadcast_static("session_map", "base_link", (*ROBOT, 0.0))
        self.reference.publish(reference_map())
        pose = Listener("match_pose", PoseWithCovarianceStamped)
        self.match(session_map(START))
        pose.wait_for(lambda _: True, "match_pose: the node knows where the robot is")
        match = self.match(session_map(START))
        self.assertGreater(match.nearby_cells, 30)
        self.assertGreater(match.nearby_ratio, 0.9)
        self.wait_for_tf("map", "session_map")

        lost = self.match(with_false_walls(), MapMatch.ROBOT_ASTRAY)

        self.assertLess(lost.nearby_ratio, 0.5)
        self.assertGreater(lost.hit_ratio, 0.6)
        self.assert_pose(lost.T_reference_session, (0.0, 0.0, 0.0))
        self.log.wait_for(lambda line: line.level == line.ERROR and "the alignment is not broadcast" in line.msg, "error")
        self.assert_no_tf("session_map")
        wait_for_diagnostic("map_matcher: alignment",
                            lambda s: s.level == DiagnosticStatus.ERROR and "not where the robot is" in s.message)

        self.match(session_map(START))
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)


if __name__ == "__main__":
    run("robot_astray", RobotAstray)
