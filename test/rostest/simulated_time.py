#!/usr/bin/env python3
"""Under simulated time the stamps on tf rise strictly, nothing is sent before the clock, and a bag may loop."""
import rosgraph_msgs.msg
import rospy

from building import reference_map, session_map
from node_fixture import NodeFixture, run, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session
STEP = rospy.Duration(0.01)


class SimulatedTime(NodeFixture):
    def setUp(self):
        super().setUp()
        self.clock = rospy.Publisher("/clock", rosgraph_msgs.msg.Clock, queue_size=100)
        wait_until(lambda: self.clock.get_num_connections() >= 2, "the node and this test listen to /clock")

    def run_clock(self, first, until, what):
        """Lets time run from `first` [s] on until the condition holds; returns the last time."""
        now = rospy.Time(first)
        steps = []

        def tick():
            steps.append(now + STEP * len(steps))
            self.clock.publish(steps[-1])
            return until()
        wait_until(tick, what)
        return steps[-1]

    def stamps(self):
        return [t.header.stamp for tf in self.tf.messages for t in tf.transforms if t.child_frame_id == "session_map"]

    def matches(self):
        return [match for match in self.map_match.messages if match.status == match.MATCHED]

    def test_nothing_at_time_zero_rising_stamps_and_a_jump_back(self):
        self.reference.publish(reference_map())
        self.session.publish(session_map(START))
        wait_until(self.matches, "a match at time zero")
        self.assert_no_tf("session_map")

        end = self.run_clock(100.0, lambda: len(self.stamps()) >= 20, "20 transforms")
        stamps = self.stamps()
        self.assertTrue(all(earlier < later for earlier, later in zip(stamps, stamps[1:])), stamps)
        self.assertLess(stamps[-1], end + rospy.Duration(0.2))

        self.assert_no_tf("session_map")  # while time stands still

        self.tf.clear()
        self.map_match.clear()
        self.run_clock(50.0, lambda: any("time went back" in line.msg for line in self.log.messages), "warning")
        self.tf.clear()
        self.run_clock(51.0, lambda: rospy.Time.now() > rospy.Time(52.0), "a second without an alignment")
        self.assertFalse(self.stamps())

        self.session.publish(session_map(START))
        wait_until(self.matches, "a match after time went back")
        self.run_clock(53.0, lambda: len(self.stamps()) >= 5, "transforms after time went back")
        self.assertLess(self.stamps()[-1], rospy.Time(100.0))


if __name__ == "__main__":
    run("simulated_time", SimulatedTime)
