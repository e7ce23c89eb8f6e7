#!/usr/bin/env python3
"""A search for which there is no memory: the node says so about that very map, and goes on with the next one."""
import resource
import xmlrpc.client

import rosgraph
import rospy
from diagnostic_msgs.msg import DiagnosticStatus
from std_srvs.srv import Trigger

from building import FREE, RESOLUTION, grid, is_wall, session_map
from map_matcher.msg import MapMatch
from node_fixture import DEADLINE, NodeFixture, run, wait_for_diagnostic

START = (12.3, 7.1, 0.7)  # T_reference_session
SIZE = (2400, 1600)  # [cells], of a reference map for which the search needs some 60 MB
HEADROOM = 30 << 20  # [bytes], for all but the search


def large_reference_map():
    """The building in the lower left corner of a large map."""
    message = grid("map", (0.0, 0.0), (1, 1), lambda x, y: FREE)
    message.info.width, message.info.height = SIZE
    values = [FREE] * (SIZE[0] * SIZE[1])
    for row in range(160):
        for column in range(240):
            if is_wall((column + 0.5) * RESOLUTION, (row + 0.5) * RESOLUTION):
                values[row * SIZE[0] + column] = 100
    message.data = values
    return message


def pid_of(node):
    uri = rosgraph.Master(rospy.get_name()).lookupNode(node)
    return xmlrpc.client.ServerProxy(uri).getPid(rospy.get_name())[2]


def address_space_of(pid):
    """[bytes]"""
    with open("/proc/%d/statm" % pid) as file:
        return int(file.read().split()[0]) * resource.getpagesize()


class FailedSearch(NodeFixture):
    def test_is_told_of_its_map_and_the_node_goes_on(self):
        self.reference.publish(large_reference_map())
        self.log.wait_for(lambda line: line.msg.startswith("reference map: 2400 x 1600"), "reference map")
        rospy.wait_for_service("map_matcher/match_now", DEADLINE)
        match_now = rospy.ServiceProxy("map_matcher/match_now", Trigger)
        pid = pid_of("/map_matcher")
        unlimited = resource.prlimit(pid, resource.RLIMIT_AS)
        resource.prlimit(pid, resource.RLIMIT_AS, (address_space_of(pid) + HEADROOM, unlimited[1]))

        failed = self.match(session_map(START), MapMatch.FAILED)

        self.assertEqual(failed.status_text, "failed")
        self.assertIn("alloc", failed.reason)
        self.assertEqual((failed.session_frame, failed.reference_frame), ("session_map", "map"))
        self.assert_no_tf("session_map")
        wait_for_diagnostic("map_matcher: alignment",
                            lambda s: s.level == DiagnosticStatus.ERROR and failed.reason in s.message)
        answer = match_now()
        self.assertFalse(answer.success)
        self.assertIn("alloc", answer.message)

        resource.prlimit(pid, resource.RLIMIT_AS, unlimited)
        self.assert_pose(self.match(session_map(START)).T_reference_session, START)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)


if __name__ == "__main__":
    run("failed_search", FailedSearch)
