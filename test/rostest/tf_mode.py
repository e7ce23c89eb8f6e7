#!/usr/bin/env python3
"""Each tf_mode: which map frame is the parent of the other on tf, with strictly rising stamps in the near future."""
import math

import rospy

from building import reference_map, session_map, transformed
from node_fixture import NodeFixture, is_between, run

START = (12.3, 7.1, 0.7)  # T_reference_session
INVERSE = (*transformed((0.0, 0.0, -START[2]), -START[0], -START[1]), -START[2])
TF_RATE = 20.0  # [Hz], the default
TRANSFORM_TOLERANCE = 0.5  # [s], as in tf_mode.launch
NUM_TRANSFORMS = 20


class TfMode(NodeFixture):
    def test_broadcasts_what_it_says(self):
        mode = rospy.get_param("map_matcher/tf_mode")
        self.reference.publish(reference_map())
        self.match(session_map(START))

        if mode == "none":
            self.assert_no_tf("map")
            self.assert_no_tf("session_map")
        elif mode == "reference_to_session":
            self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)
            self.assert_stamps("map", "session_map")
            self.assert_no_tf("map")
        else:
            tolerance = (0.1 + 0.01 * math.hypot(START[0], START[1]), 0.01)  # the angle's error at the lever arm
            self.assert_pose(self.wait_for_tf("session_map", "map").transform, INVERSE, tolerance)
            self.assert_stamps("session_map", "map")
            self.assert_no_tf("session_map")

    def assert_stamps(self, parent, child):
        """20 Hz, each stamp later than the one before, and ahead of now by the tolerance."""
        self.tf.clear()
        self.tf.wait_for(lambda tf: len(self.tf.messages) >= NUM_TRANSFORMS, "%d transforms" % NUM_TRANSFORMS)
        now = rospy.Time.now()
        stamps = [t.header.stamp for tf in self.tf.messages for t in tf.transforms if is_between(t, parent, child)]
        self.assertTrue(all(earlier < later for earlier, later in zip(stamps, stamps[1:])), stamps)
        period = (stamps[-1] - stamps[0]).to_sec() / (len(stamps) - 1)
        self.assertAlmostEqual(period, 1.0 / TF_RATE, delta=0.5 / TF_RATE)
        self.assertAlmostEqual((stamps[-1] - now).to_sec(), TRANSFORM_TOLERANCE, delta=0.3)


if __name__ == "__main__":
    run("tf_mode", TfMode)
