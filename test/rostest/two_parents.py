#!/usr/bin/env python3
"""A frame of the robot's with two parents on tf is an error on /diagnostics that names both."""
import rospy
import tf2_msgs.msg
from diagnostic_msgs.msg import DiagnosticStatus

from building import reference_map, session_map
from node_fixture import NodeFixture, run, stamped_transform, wait_for_diagnostic, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session
PERIOD = 0.05  # [s]


def status_is(level, *texts):
    return lambda status: status.level == level and all(text in status.message for text in texts)


class TwoParents(NodeFixture):
    def setUp(self):
        super().setUp()
        self.publisher = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=10)
        self.other = rospy.Publisher("other_tf", tf2_msgs.msg.TFMessage, queue_size=10)  # amcl passes it on to /tf
        wait_until(lambda: self.publisher.get_num_connections() == 2 and self.other.get_num_connections() == 1,
                   "all listen")
        self.timers = []

    def tearDown(self):
        for timer in self.timers:
            timer.shutdown()
        super().tearDown()

    def keep_sending(self, publisher, parent, child):
        self.timers.append(rospy.Timer(rospy.Duration(PERIOD), lambda _: publisher.publish(
            [stamped_transform(parent, child, (0.0, 0.0, 0.0), rospy.Time.now())])))

    def test_1_odom_of_amcl_and_of_the_mapper(self):
        self.keep_sending(self.publisher, "odom", "base_link")
        self.keep_sending(self.publisher, "session_map", "odom")
        wait_for_diagnostic("map_matcher: frames", status_is(DiagnosticStatus.OK, "none of the robot's frames"))

        self.keep_sending(self.other, "map", "odom")

        wait_for_diagnostic("map_matcher: frames", status_is(
            DiagnosticStatus.ERROR, 'the frame "odom" has two parents', '"map" by /amcl', '"session_map" by /two_parents'))
        self.log.wait_for(lambda line: line.level == line.ERROR and '"map" by /amcl' in line.msg, "an error")
        for timer in self.timers:
            timer.shutdown()
        wait_for_diagnostic("map_matcher: frames", status_is(DiagnosticStatus.OK, "none of the robot's frames"))

    def test_2_the_session_frame_of_another_node_and_of_this_one(self):
        self.reference.publish(reference_map())
        self.match(session_map(START))
        self.wait_for_tf("map", "session_map")

        self.keep_sending(self.other, "world", "session_map")

        wait_for_diagnostic("map_matcher: frames", status_is(
            DiagnosticStatus.ERROR, 'the frame "session_map" has two parents', '"map" by /map_matcher', '"world" by /amcl'))


if __name__ == "__main__":
    run("two_parents", TwoParents)
