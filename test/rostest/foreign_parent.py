#!/usr/bin/env python3
"""A session frame that already has a parent is an error that is told, not a fight."""
import rospy
import tf2_msgs.msg
from diagnostic_msgs.msg import DiagnosticStatus

from building import reference_map, session_map
from node_fixture import NodeFixture, is_between, run, stamped_transform, wait_for_diagnostic, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session
PERIOD = 0.05  # [s], of the other node's transforms
SELDOM = 3.0  # [s]


class ForeignParent(NodeFixture):
    def test_silences_the_node_until_it_is_gone(self):
        other = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=10)
        wait_until(lambda: other.get_num_connections() == 2, "the node and this test listen to /tf")
        sending = rospy.Timer(rospy.Duration(PERIOD), lambda _: other.publish(
            [stamped_transform("odom", "session_map", (0.0, 0.0, 0.0), rospy.Time.now())]))
        self.tf.wait_for(lambda tf: is_between(tf.transforms[0], "odom", "session_map"), "the other node's transform")

        self.reference.publish(reference_map())
        match = self.match(session_map(START))

        self.assertEqual(match.status_text, "matched")
        error = self.log.wait_for(lambda line: line.level == line.ERROR and "already has the parent" in line.msg, "error")
        self.assertIn('"session_map" already has the parent "odom", broadcast by /foreign_parent', error.msg)
        self.assertIn("~tf_mode", error.msg)
        self.tf.clear()
        self.tf.wait_for(lambda tf: len(self.tf.messages) >= 20, "transforms")
        self.assertFalse([t for tf in self.tf.messages for t in tf.transforms if is_between(t, "map", "session_map")])
        self.assertEqual(len([line for line in self.log.messages if "already has the parent" in line.msg]), 1)
        wait_for_diagnostic("map_matcher: alignment",
                            lambda s: s.level == DiagnosticStatus.ERROR and "another node gives" in s.message)

        sending.shutdown()

        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)

    def test_that_is_sent_seldom_silences_the_node_all_the_same(self):
        other = rospy.Publisher("/tf", tf2_msgs.msg.TFMessage, queue_size=10)
        wait_until(lambda: other.get_num_connections() == 2, "the node and this test listen to /tf")
        self.reference.publish(reference_map())
        self.match(session_map(START))
        self.wait_for_tf("map", "session_map")
        sending = rospy.Timer(rospy.Duration(SELDOM), lambda _: other.publish(
            [stamped_transform("odom", "session_map", (0.0, 0.0, 0.0), rospy.Time.now())]))
        self.log.wait_for(lambda line: line.level == line.ERROR and "already has the parent" in line.msg, "error")

        self.tf.clear()
        self.tf.wait_for(lambda tf: len(self.tf.messages) >= 3, "three transforms of the other node")

        self.assertFalse([t for tf in self.tf.messages for t in tf.transforms if is_between(t, "map", "session_map")])
        sending.shutdown()


if __name__ == "__main__":
    run("foreign_parent", ForeignParent)
