#!/usr/bin/env python3
"""Launch files say what they start and with which parameters, on any system: nothing of it is started here."""

import os
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from unittest import mock

import roslaunch.config
import roslaunch.xmlloader

CHECKOUT = Path(__file__).resolve().parents[2]


def load(name, *arguments):
    """What a launch file comes to: (nodes by name, parameters by name)."""
    config = roslaunch.config.ROSLaunchConfig()
    loader = roslaunch.xmlloader.XmlLoader()
    with mock.patch.dict(os.environ, {"ROS_PACKAGE_PATH": f"{CHECKOUT}:{os.environ.get('ROS_PACKAGE_PATH', '')}"}):
        loader.load(str(CHECKOUT / "launch" / name), config, argv=list(arguments), verbose=False)
    nodes = {node.name: node for node in config.nodes}
    return nodes, {name: parameter.value for name, parameter in config.params.items()}


def remapped(node, name):
    return dict(node.remap_args).get(name)


class RobotLaunchFiles(unittest.TestCase):
    def test_the_pioneer_with_slam_gmapping(self):
        nodes, parameters = load("pioneer.launch", "map:=/maps/building.yaml")

        self.assertEqual({"lidar_scrubber", "map_matcher_nodelets", "slam_gmapping", "map_matcher"}, set(nodes))
        self.assertEqual("scan_scrubbed", remapped(nodes["slam_gmapping"], "scan"))
        self.assertEqual("session_map", remapped(nodes["slam_gmapping"], "map"))
        self.assertEqual("session_map", remapped(nodes["map_matcher"], "session_map"))
        self.assertEqual("load map_matcher/LidarScrubberNodelet map_matcher_nodelets", nodes["lidar_scrubber"].args)
        self.assertEqual("/maps/building.yaml", parameters["/map_matcher/reference_map_file"])
        self.assertEqual(0.5, parameters["/map_matcher/session_map_cell_offset"])
        self.assertIs(True, parameters["/map_matcher/serve_map"])
        self.assertEqual(2.5, parameters["/slam_gmapping/temporalUpdate"])

    def test_the_pepper_with_both_lasers(self):
        nodes, parameters = load("pepper.launch", "map:=/maps/building.yaml", "detector:=true", "weight_file:=/weights.pth")

        self.assertEqual({"front_lidar_scrubber", "rear_lidar_scrubber", "map_matcher_nodelets", "scan_merger", "dr_spaam_front",
                          "dr_spaam_rear", "slam_gmapping", "map_matcher"}, set(nodes))
        for side in ("front", "rear"):
            raw = f"sick_laser_{side}/scan"
            self.assertEqual(raw, remapped(nodes[f"{side}_lidar_scrubber"], "scan"))
            self.assertEqual(raw + "_scrubbed", remapped(nodes[f"{side}_lidar_scrubber"], "scan_scrubbed"))
            self.assertEqual(raw, parameters[f"/dr_spaam_{side}/subscriber/scan/topic"])
            self.assertEqual(0.4, parameters[f"/dr_spaam_{side}/conf_thresh"])
            self.assertIn(parameters[f"/dr_spaam_{side}/publisher/detections/topic"],
                          parameters["/front_lidar_scrubber/detection_topics"])
        self.assertEqual(["sick_laser_front/scan_scrubbed", "sick_laser_rear/scan_scrubbed"],
                         parameters["/scan_merger/scan_topics"])
        self.assertEqual("merged_scan_scrubbed", remapped(nodes["scan_merger"], "merged_scan"))
        self.assertEqual("merged_scan_scrubbed", remapped(nodes["slam_gmapping"], "scan"))
        self.assertGreaterEqual(parameters["/slam_gmapping/maxUrange"], parameters["/slam_gmapping/maxRange"])
        self.assertEqual("reference_map", parameters["/map_matcher/reference_frame"])
        self.assertEqual("gmap", parameters["/slam_gmapping/map_frame"])

    def test_the_names_of_the_report_s_own_package(self):
        nodes, parameters = load("report_names.launch", "slam_map_topic:=/gmap", "reference_map_name:=asl",
                                 "maps_folder:=/maps", "reference_map_frame:=world", "acceptance_ratio:=0.4",
                                 "output:=log", "launch_prefix:=nice", "reference_map_downsampling_passes:=2")

        self.assertEqual({"map_matcher"}, set(nodes))
        self.assertEqual("/gmap", remapped(nodes["map_matcher"], "session_map"))
        self.assertEqual("/world", remapped(nodes["map_matcher"], "~reference_map"))
        self.assertEqual(("log", "nice"), (nodes["map_matcher"].output, nodes["map_matcher"].launch_prefix))
        self.assertEqual("/maps/asl.yaml", parameters["/map_matcher/reference_map_file"])
        self.assertEqual("world", parameters["/map_matcher/reference_frame"])
        self.assertEqual(0.4, parameters["/map_matcher/acceptance_ratio"])
        self.assertEqual("session_to_reference", parameters["/map_matcher/tf_mode"])

    def test_raw_scans_reach_the_mapper_only_without_the_scrubber(self):
        for name, raw in (("pioneer.launch", "scan"), ("pepper.launch", "merged_scan")):
            nodes, parameters = load(name, "scrub:=false")

            self.assertEqual(raw, remapped(nodes["slam_gmapping"], "scan"))
            self.assertEqual([], [node for node in nodes if "scrubber" in node or "nodelets" in node])
            self.assertEqual([], [key for key, value in parameters.items() if "_scrubbed" in str(value)])

    def test_diagnostics_are_grouped_on_request(self):
        nodes, parameters = load("pioneer.launch", "aggregator:=true")

        self.assertIn("localization_diagnostics", nodes)
        analyzers = {key.split("/")[3] for key in parameters if key.startswith("/localization_diagnostics/analyzers/")}
        self.assertEqual({"matcher", "scans"}, analyzers)

    def test_a_mapper_that_is_not_there_is_named(self):
        with self.assertRaisesRegex(Exception, "slam_toolbox"):
            load("pioneer.launch", "mapper:=slam_toolbox")


class ReplayLaunchFiles(unittest.TestCase):
    BOTH = ("bag:=/day.bag", "map:=/maps/building.yaml", "scan:=front", "rear_scan:=rear", "scrub:=true")

    def test_both_lasers_are_scrubbed_and_drawn(self):
        for name, more in (("replay.launch", ()), ("open_lab_replay.launch", ("starts:=/starts.csv",))):
            nodes, parameters = load(name, *self.BOTH, *more, "detections:=[front_people, rear_people]")

            self.assertEqual(["front_scrubbed", "rear_scrubbed"], parameters["/session_mapper/scan_topics"])
            for side in ("front", "rear"):
                scrubber = f"{side}_lidar_scrubber"
                self.assertEqual((side, f"{side}_scrubbed"),
                                 (remapped(nodes[scrubber], "scan"), remapped(nodes[scrubber], "scan_scrubbed")))
                self.assertEqual(["front_people", "rear_people"], parameters[f"/{scrubber}/detection_topics"])
            self.assertEqual("session_map", remapped(nodes["session_mapper"], "map"))
            self.assertEqual("session_map", remapped(nodes["map_matcher"], "session_map"))

    def test_slam_gmapping_reads_both_lasers_as_one(self):
        nodes, parameters = load("replay.launch", *self.BOTH, "mapper:=gmapping")

        self.assertEqual(["front_scrubbed", "rear_scrubbed"], parameters["/scan_merger/scan_topics"])
        self.assertEqual("merged_scan_scrubbed", remapped(nodes["scan_merger"], "merged_scan"))
        self.assertEqual("merged_scan_scrubbed", remapped(nodes["slam_gmapping"], "scan"))
        self.assertEqual(0.5, parameters["/map_matcher/session_map_cell_offset"])

    def test_one_laser_is_read_as_it_is(self):
        nodes, parameters = load("replay.launch", "bag:=/day.bag", "map:=/maps/building.yaml", "detector:=true",
                                 "weight_file:=/weights.pth")

        self.assertEqual({"player", "dr_spaam_front", "session_mapper", "map_matcher", "rviz"}, set(nodes))
        self.assertEqual(["scan"], parameters["/session_mapper/scan_topics"])


class NavigationLaunchFile(unittest.TestCase):
    def test_move_base_plans_in_the_reference_map_and_sees_people(self):
        _, parameters = load("navigation.launch", "reference_frame:=reference_map", "scan:=sick_laser_front/scan",
                             "second_scan:=sick_laser_rear/scan", "amcl:=true")

        self.assertEqual("reference_map", parameters["/move_base/global_costmap/global_frame"])
        self.assertEqual("map", parameters["/move_base/global_costmap/static/map_topic"])
        self.assertEqual("odom", parameters["/move_base/local_costmap/global_frame"])
        for costmap in ("global_costmap", "local_costmap"):
            sources = parameters[f"/move_base/{costmap}/obstacles/observation_sources"].split()
            topics = [parameters[f"/move_base/{costmap}/obstacles/{source}/topic"] for source in sources]
            self.assertEqual(["sick_laser_front/scan", "sick_laser_rear/scan"], topics)
            self.assertEqual(0.5, parameters[f"/move_base/{costmap}/transform_tolerance"])
        self.assertIs(False, parameters["/amcl/tf_broadcast"])

    def test_one_laser_is_one_source(self):
        _, parameters = load("navigation.launch")

        self.assertEqual("raw_scan", parameters["/move_base/local_costmap/obstacles/observation_sources"])


class AllLaunchFiles(unittest.TestCase):
    def test_every_argument_is_documented(self):
        for path in sorted((CHECKOUT / "launch").glob("*.launch")):
            for argument in ElementTree.parse(path).getroot().findall("arg"):
                with self.subTest(f"{path.name}: {argument.get('name')}"):
                    self.assertTrue(argument.get("doc"))


if __name__ == "__main__":
    unittest.main()
