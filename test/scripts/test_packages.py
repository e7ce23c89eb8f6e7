#!/usr/bin/env python3
"""Compares the three places that name what the package needs: package.xml, CMakeLists.txt and scripts/packages.txt."""

import re
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]

# Packages of the system: name for rosdep, and for apt.
SYSTEM = {
    "doxygen": {"doxygen"},
    "eigen": {"libeigen3-dev"},
    "libboost-program-options-dev": {"libboost-program-options-dev"},
    "libopencv-dev": {"libopencv-dev"},
    "nlohmann-json-dev": {"nlohmann-json3-dev"},
    "python3-matplotlib": {"python3-matplotlib"},
    "yaml-cpp": {"libyaml-cpp-dev"},
    # Debian's MRPT, and ROS' of today and of yesterday
    "mrpt": {"libmrpt-slam-dev"},
    "mrpt_libslam": {"libmrpt-slam-dev", "ros-noetic-mrpt-libslam", "ros-noetic-mrpt2"},
}
# Names of Debian's packages of a ROS package that do not follow from its name.
OTHER_DEBIAN_NAMES = {"dynamic_reconfigure": {"libdynamic-reconfigure-config-init-mutex-dev"},
                      "nodelet": {"libnodeletlib-dev", "libnodeletlib-tools"}}
# Installed beside what package.xml names: rosdep brings them with something else, or they are for developers only.
NOT_IN_PACKAGE_XML = {"build-essential", "catkin-lint", "clang-format-14", "clang-tidy-14", "cmake", "git", "imagemagick",
                      "libbenchmark-dev", "libgmock-dev", "libgtest-dev", "ros-actionlib-msgs", "rosbash", "rviz", "xvfb",
                      "ros-noetic-actionlib-msgs", "ros-noetic-rosbash", "ros-noetic-rviz"}
# In package.xml only: apt brings it with the package that has the headers.
NOT_IN_TABLE = {"libboost-program-options"}
# What CMakeLists.txt looks for beside catkin's components, and the name for rosdep where it is another one; None: no
# dependency, since it comes with the compiler or may be missing.
FOUND_BY_CMAKE = {"Boost": "libboost-program-options-dev", "Eigen3": "eigen", "OpenCV": "libopencv-dev",
                  "Threads": None, "benchmark": None, "mrpt-slam": "mrpt", "nlohmann_json": "nlohmann-json-dev"}
SYSTEMS = ("Debian 12", "Ubuntu 20.04", "Debian 11")


def apt_names(key, system):
    """Under which names the apt of a system may have what rosdep calls `key`."""
    if key in SYSTEM:
        return SYSTEM[key]
    dashed = key.replace("_", "-")
    if system == "Ubuntu 20.04":
        return {f"ros-noetic-{dashed}"}
    return {dashed, f"{dashed}-dev", f"lib{dashed}-dev", f"libros-{dashed}-dev", f"ros-{dashed}", f"python3-{dashed}",
            *OTHER_DEBIAN_NAMES.get(key, ())}


def declared(system):
    """What package.xml names on a system, by rosdep's names."""
    keys = set()
    for element in ElementTree.parse(CHECKOUT / "package.xml").getroot():
        condition = element.get("condition", "")
        if element.tag.endswith("depend") and condition in ("", "$ROS_DISTRO == noetic" if system == "Ubuntu 20.04"
                                                            else "$ROS_DISTRO != noetic"):
            keys.add(element.text)
    return keys


def rows():
    """The table's rows: group, alternatives on each system, what there is not without it."""
    for line in (CHECKOUT / "scripts/packages.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            fields, _, loss = line.partition(" ? ")
            group, *cells = fields.split()
            yield group, [cell.split("|") for cell in cells], loss


def listed(system):
    """All names that the table has for a system."""
    index = SYSTEMS.index(system)
    return {name for _, cells, _ in rows() for name in cells[index]} - {"-"}


def cmake_arguments(command):
    text = re.sub(r"#.*", "", (CHECKOUT / "CMakeLists.txt").read_text())
    return [match.split() for match in re.findall(rf"\b{command}\(([^)]*)\)", text)]


class Packages(unittest.TestCase):
    def test_each_row_of_the_table_has_a_group_and_a_package_on_each_system(self):
        for group, cells, _ in rows():
            self.assertIn(group, ("build", "run", "test", "lint", "docs", "screenshots"), cells)
            self.assertEqual(len(cells), len(SYSTEMS), cells)

    def test_the_table_names_no_package_twice_for_one_purpose(self):
        names = [(group, *(tuple(cell) for cell in cells)) for group, cells, _ in rows()]
        self.assertEqual(sorted(names), sorted(set(names)))

    def test_each_dependency_of_package_xml_is_in_the_table(self):
        for system in SYSTEMS:
            for key in declared(system) - NOT_IN_TABLE:
                self.assertTrue(apt_names(key, system) & listed(system), f"{key} on {system}")

    def test_each_package_of_the_table_is_a_dependency_of_package_xml(self):
        for system in SYSTEMS:
            known = set().union(*(apt_names(key, system) for key in declared(system))) | NOT_IN_PACKAGE_XML
            self.assertEqual(listed(system) - known, set(), system)

    def test_each_catkin_component_is_a_dependency_of_package_xml(self):
        components = next(words for words in cmake_arguments("find_package") if words[0] == "catkin")[3:]
        self.assertIn("roscpp", components)
        self.assertEqual(set(components) - declared("Ubuntu 20.04"), set())

    def test_each_package_that_cmake_looks_for_is_a_dependency_of_package_xml(self):
        for name in {words[0] for words in cmake_arguments("find_package")} - {"catkin"}:
            key = FOUND_BY_CMAKE.get(name, name)
            if key:
                self.assertIn(key, declared("Debian 12"))
