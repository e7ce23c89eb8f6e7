#!/usr/bin/env python3
"""Uses what was installed as a user of the package does, in a place where neither the sources nor the build are seen."""

import os
import shlex
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
BUILD = os.environ.get("MAP_MATCHER_BUILD")
DEADLINE = 120  # [s] for one command
TOOLS = ("evaluate_drive", "generate_building", "map_bag", "map_quality", "match_maps", "scrub_bag", "simulate_drive",
         "person_detections_bridge", "plot_cold_starts", "plot_run", "plot_scrubbed", "plot_session_maps")

CONSUMER_LISTS = """cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 17)
find_package(map_matcher REQUIRED)
find_package(Eigen3 REQUIRED)
include_directories(${map_matcher_INCLUDE_DIRS} ${EIGEN3_INCLUDE_DIRS})
add_executable(consumer consumer.cpp)
target_link_libraries(consumer ${map_matcher_LIBRARIES})
"""
CONSUMER = """#include "map_matcher/grid/map_file.hpp"
#include <iostream>

int main() {
  try {
    map_matcher::grid::loadMap("there_is_none.yaml");
  } catch (const std::exception& error) {
    std::cout << error.what() << '\\n';
  }
}
"""


@unittest.skipUnless(BUILD, "needs MAP_MATCHER_BUILD, a directory that scripts/build has filled")
class Installation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = Path(tempfile.mkdtemp(prefix="map_matcher_"))
        cls.addClassCleanup(shutil.rmtree, cls.directory, ignore_errors=True)
        cls.prefix = cls.directory / "install"
        shutil.copytree(Path(BUILD) / ".install", cls.prefix, symlinks=True)
        hidden = "unshare --map-root-user --mount"
        cls.may_hide = subprocess.run([*hidden.split(), "true"], stderr=subprocess.DEVNULL, check=False).returncode == 0

    def run_installed(self, command):
        """Runs the command, which sees no file of the checkout where the system lets it be hidden."""
        words = ["bash", "-c", f". {self.prefix}/setup.bash && {command}"]
        if self.may_hide:
            words = ["unshare", "--map-root-user", "--mount", "bash", "-c",
                     f"mount -t tmpfs none {shlex.quote(str(CHECKOUT))} && exec {shlex.join(words)}"]
        environment = {"HOME": str(self.directory), "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "C.UTF-8",
                       "ROS_IP": "127.0.0.1", "ROS_HOME": str(self.directory)}
        done = subprocess.run(words, cwd=self.directory, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=DEADLINE,
                              check=False)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}")
        return done.stdout

    def test_every_launch_file_finds_what_it_includes(self):
        for path in sorted((self.prefix / "share/map_matcher/launch").glob("*.launch")):
            needed = [arg.get("name") for arg in ElementTree.parse(path).getroot().findall("arg")
                      if arg.get("default") is None and arg.get("value") is None]
            arguments = " ".join(f"{name}:=1" for name in needed)
            with self.subTest(path.name):
                self.run_installed(f"roslaunch --files {path} {arguments}")
                self.run_installed(f"roslaunch --nodes {path} {arguments}")
                self.run_installed(f"roslaunch --dump-params {path} {arguments}")

    def test_every_tool_tells_its_options(self):
        for name in TOOLS:
            if (self.prefix / "lib/map_matcher" / name).exists():
                with self.subTest(name):
                    self.assertIn("usage", self.run_installed(f"rosrun map_matcher {name} --help").lower())

    def test_every_program_finds_its_libraries(self):
        libraries = [*(self.prefix / "lib/map_matcher").iterdir(), *(self.prefix / "lib").glob("*.so")]
        for path in libraries:
            if path.is_file() and path.read_bytes()[:4] == b"\x7fELF":
                with self.subTest(path.name):
                    self.assertNotIn("not found", self.run_installed(f"ldd {path}"))

    def test_the_nodelet_is_known_and_loadable(self):
        self.assertIn("map_matcher", self.run_installed("rospack plugins --attrib=plugin nodelet"))
        for name in ("lidar_scrubber", "scan_merger"):
            self.run_installed(f"python3 -c 'import ctypes; ctypes.CDLL(\"lib{name}_nodelet.so\")'")

    def test_every_header_that_leads_no_source_compiles_alone(self):
        headers = sorted((self.prefix / "include/map_matcher").rglob("*.hpp"))
        self.assertTrue(headers)
        for header in headers:
            name = header.relative_to(self.prefix / "include/map_matcher")
            if not (CHECKOUT / "src" / name).with_suffix(".cpp").exists():
                with self.subTest(str(name)):
                    self.run_installed(f"c++ -std=c++17 -fsyntax-only -x c++ -I {self.prefix}/include "
                                       f"-isystem /usr/include/eigen3 {header}")

    def test_another_package_compiles_and_links(self):
        (self.directory / "CMakeLists.txt").write_text(CONSUMER_LISTS)
        (self.directory / "consumer.cpp").write_text(CONSUMER)
        self.run_installed("cmake -S . -B consumer_build && cmake --build consumer_build")
        self.assertIn("there_is_none.yaml", self.run_installed("consumer_build/consumer"))
