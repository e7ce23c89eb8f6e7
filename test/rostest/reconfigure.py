#!/usr/bin/env python3
"""Parameters change while the nodes run, through dynamic_reconfigure; what cannot be is refused, and nothing changes."""
import rospy
import dynamic_reconfigure.client
import geometry_msgs.msg
from sensor_msgs.msg import LaserScan

from building import reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import DEADLINE, Listener, NodeFixture, run, wait_until
from people_in_scans import RANGE, pose_array, removed_beams, scan_message

START = (12.3, 7.1, 0.7)  # T_reference_session


class Reconfigure(NodeFixture):
    def setUp(self):
        super().setUp()
        self.matcher = dynamic_reconfigure.client.Client("map_matcher", timeout=DEADLINE)
        self.scrubber = dynamic_reconfigure.client.Client("lidar_scrubber", timeout=DEADLINE)

    def tearDown(self):
        self.matcher.close()
        self.scrubber.close()
        super().tearDown()

    def assert_told(self, text):
        self.log.wait_for(lambda line: text in line.msg, "a line with \"%s\"" % text)

    def test_1_nodes_begin_with_the_parameters_that_they_were_started_with(self):
        self.assertEqual(self.matcher.get_configuration(DEADLINE)["min_probability"], 1.0)
        self.assertEqual(self.matcher.get_configuration(DEADLINE)["min_margin"], 0.1)
        self.assertEqual(self.scrubber.get_configuration(DEADLINE)["silence_warning"], 2.0)

    def test_2_the_map_at_hand_is_matched_anew(self):
        self.reference.publish(reference_map())
        self.match(session_map(START), status=MapMatch.DOUBTFUL)

        self.matcher.update_configuration({"min_probability": 0.9})

        self.map_match.wait_for(lambda match: match.status == MapMatch.MATCHED, "a match")
        self.assert_told("reconfigured: min_probability is 0.9 now, and was 1")
        self.assertEqual(rospy.get_param("map_matcher/min_probability"), 0.9)

    def test_3_what_cannot_be_is_refused_with_all_that_came_with_it(self):
        answer = self.matcher.update_configuration({"min_probability": float("nan"), "threads": 1})
        self.assertEqual((answer["min_probability"], answer["threads"]), (0.9, 2))
        self.assert_told("not reconfigured, all parameters stay as they are: min_probability is nan, expected 0 to 1")

        answer = self.scrubber.update_configuration({"silence_error": 1.0, "removal_radius": 0.5})
        self.assertEqual((answer["silence_error"], answer["removal_radius"]), (5.0, 0.3))
        self.assert_told("~silence_error is 1.0")

    def test_4_the_next_scan_is_scrubbed_as_told(self):
        scrubbed = Listener("scan_scrubbed", LaserScan)
        scans = rospy.Publisher("scan", LaserScan, queue_size=10)
        detections = rospy.Publisher("dr_spaam_detections", geometry_msgs.msg.PoseArray, queue_size=10)
        wait_until(lambda: scans.get_num_connections() and detections.get_num_connections(), "the scrubber listens")
        scrubbed.wait_until_served()

        def removed():
            """How many beams are removed around one detection, once it has come."""
            stamp = rospy.Time.now()
            detections.publish(pose_array(stamp, [(RANGE, 0.0)]))

            def is_removed():
                scrubbed.clear()
                scans.publish(scan_message(stamp))
                return removed_beams(scrubbed.wait_for(lambda out: out.header.stamp == stamp, "a scan"))
            wait_until(is_removed, "a removed beam")
            return len(is_removed())

        before = removed()
        self.scrubber.update_configuration({"removal_radius": 0.6})
        self.assertGreater(removed(), 1.8 * before)


if __name__ == "__main__":
    run("reconfigure", Reconfigure)
