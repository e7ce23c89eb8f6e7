#!/usr/bin/env python3
"""Runs what README.md and docs/ tell a user to type, as it stands there, on a small simulated drive: a test each.

The commands run in a shell that has sourced what README.md says, of the build that MAP_MATCHER_BUILD names (a directory
that scripts/build has filled); without MAP_MATCHER_BUILD they run in the environment as it is.
"""

import json
import os
import re
import shlex
import shutil
import signal
import socket
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
import xmlrpc.client
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
DEADLINE = 90  # [s] for one command on the small drive
LOOK_AGAIN = 0.2  # [s]
SEED = 1

# The documents with commands, in the order in which they are run; those of one document may build on each other.
DOCUMENTS = ("README.md", "docs/interfaces.md", "docs/migration.md", "docs/navigation.md", "docs/results.md",
             "docs/robots.md", "docs/tools.md", "docs/tuning.md", "docs/tutorial.md")

# What makes a command small, or lets it do without a screen: more arguments behind it, or another text in it.
MORE_ARGUMENTS = {
    "replay.launch bag:": "rviz:=false",
    "simulated_crowd.launch density:": "rviz:=false",
    "--itinerary explore": "--duration 3",
    "check_robot.launch": "duration:=600",
}
OTHER_TEXTS = {"--duration 120": "--duration 20", "record -O drive.bag": "record -O recorded.bag"}
# They run until they are stopped, as every launch file does.
ENDLESS_PROGRAMS = ("slam_gmapping", "person_detections_bridge", "static_transform_publisher")
ENDLESS_WORDS = (["rosbag", "record"], ["rostopic", "echo"])


class Command:
    """A line of a code block, or a command in the text."""

    def __init__(self, document, line_number, text):
        self.document = document
        self.line_number = line_number
        self.words = text.split()
        self.text = text

    def __str__(self):
        return f"{self.document}, line {self.line_number}: {self.text}"

    def is_endless(self):
        return ((self.words[0] == "roslaunch" and "--ros-args" not in self.words) or
                (self.words[0] == "rosrun" and self.words[2] in ENDLESS_PROGRAMS) or self.words[:2] in ENDLESS_WORDS)

    def packages(self):
        """Those without which there is nothing to run: its own, and those that its launch file takes nodes from."""
        own = next(word for word in self.words[1:] if not word.startswith("-"))
        if self.words[0] != "roslaunch" or own != "map_matcher":
            return {own}
        name = next(word for word in self.words if word.endswith(".launch"))
        nodes = ElementTree.parse(CHECKOUT / "launch" / name).getroot().findall("node")
        return {own} | {node.get("pkg") for node in nodes
                        if not {"if", "unless"} & node.attrib.keys() and "$" not in node.get("pkg")}

    def asking(self, option):
        """The command of a launch file with an option that makes roslaunch only tell something of it."""
        return self.text.replace("roslaunch", f"roslaunch {option}", 1)

    def argument_names(self):
        """Of a launch file: those that are given a value."""
        return {word.split(":=")[0] for word in self.words if ":=" in word}


def commands_of(document):
    """All commands of a document, without the comments behind them. Blocks of a language, as ```text, have none."""
    text = (CHECKOUT / document).read_text(encoding="utf-8")
    commands, block = [], None
    for number, line in enumerate(text.splitlines(), start=1):
        if line.startswith("```"):
            block = line if block is None else None
        elif block == "```":
            commands.append(Command(document, number, line.split("  #")[0].strip()))
    blanked = re.sub(r"(?s)```.*?```", lambda block: "\n" * block[0].count("\n"), text)
    for match in re.finditer(r"`((?:rosrun|roslaunch)\s[^`]+)`", blanked):
        commands.append(Command(document, blanked.count("\n", 0, match.start()) + 1, " ".join(match[1].split())))
    return sorted(commands, key=lambda command: command.line_number)


# Each once, though several documents may have it.
COMMANDS = list({command.text: command for document in reversed(DOCUMENTS)
                 for command in reversed(commands_of(document))}.values())


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Shell:
    """Runs commands in one directory, with a ROS master of its own that roslaunch or roscore starts."""

    def __init__(self, directory):
        self.directory = directory
        self.master = f"http://127.0.0.1:{free_port()}"
        build = os.environ.get("MAP_MATCHER_BUILD")
        if build:
            self.setup = f". {build}/.install/setup.bash && "
            environment = {"HOME": str(directory), "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "C.UTF-8"}
        else:
            self.setup, environment = "", os.environ
        self.environment = {**environment, "ROS_MASTER_URI": self.master, "ROS_IP": "127.0.0.1",
                            "ROS_HOME": str(directory / "ros")}

    def arguments(self, command):
        return dict(args=["bash", "-c", self.setup + command], cwd=self.directory, env=self.environment,
                    stdin=subprocess.DEVNULL, stderr=subprocess.STDOUT, start_new_session=True)

    def run(self, command):
        return subprocess.run(**self.arguments(command), stdout=subprocess.PIPE, text=True, timeout=DEADLINE,
                              check=False)

    def start(self, command, log):
        return subprocess.Popen(**self.arguments("exec " + command), stdout=log)

    def nodes(self):
        """The nodes that the master knows."""
        try:
            with xmlrpc.client.ServerProxy(self.master) as master:
                _, _, state = master.getSystemState("/test")
        except OSError:
            return set()  # there is no master yet
        return {node for kind in state for _, nodes in kind for node in nodes} - {"/rosout"}


class DocumentedCommands(unittest.TestCase):
    """Has a test for each command, see below."""

    @classmethod
    def setUpClass(cls):
        cls.directory = Path(tempfile.mkdtemp(prefix="map_matcher_"))
        cls.addClassCleanup(shutil.rmtree, cls.directory, ignore_errors=True)
        shell = Shell(cls.directory)
        commands = [
            f"rosrun map_matcher generate_building --seed {SEED} --output building.yaml",
            f"rosrun map_matcher simulate_drive --map building.yaml --seed {SEED} --duration 20 --bag drive.bag",
            "rosrun map_matcher map_bag --bag drive.bag --output session.yaml"]
        for command in commands:
            done = shell.run(command)
            if done.returncode != 0:
                raise RuntimeError(f"{command}: {done.stdout}")

    def check(self, command):
        text = command.text
        if text.startswith("docker run "):
            text = text.split(" map_matcher ", maxsplit=1)[1]  # what runs in the container
        text = text.replace("/path/", f"{self.directory}/")
        for old, new in OTHER_TEXTS.items():
            text = text.replace(old, new)
        for key, arguments in MORE_ARGUMENTS.items():
            if key in text:
                text += " " + arguments
        small = Command(command.document, command.line_number, text)
        if small.words[0].startswith("scripts/"):
            self.assertTrue(os.access(CHECKOUT / small.words[0], os.X_OK), command)
        elif small.words[0] == ".":
            self.check_setup_file(command)
        elif small.words[0] == "docker":
            self.skipTest("needs Docker")
        elif small.words[0] == "sudo":  # where scripts/package writes to; scripts/chroot --package installs it
            self.assertEqual(small.text, "sudo apt install ./build/package/*.deb", command)
        else:
            self.assertIn(small.words[0], ("rosrun", "roslaunch", "rosbag", "rostopic", "rostest"), command)
            shell = Shell(self.directory)
            self.skip_where_missing(shell, small)
            (self.check_endless if small.is_endless() else self.check_ending)(shell, small)

    def skip_where_missing(self, shell, command):
        if command.words[0] in ("rosbag", "rostopic"):
            if shell.run(f"command -v {command.words[0]}").returncode != 0:
                self.skipTest(f"{command.words[0]} is not installed")
            return
        for package in sorted(command.packages()):
            if shell.run(f"rospack find {package}").returncode != 0:
                self.skipTest(f"{package} is not installed")
        package, program = command.words[1:3]
        if command.words[0] == "rosrun" and package != "map_matcher":  # Debian has some packages without their programs
            if not shell.run(f"catkin_find --libexec {package} {program}").stdout.strip():
                self.skipTest(f"{package} is not installed as a whole")

    def test_image(self):
        """The image for a robot runs what is behind its name in `docker run`."""
        build = os.environ.get("MAP_MATCHER_BUILD")
        if not build:
            self.skipTest("runs in the environment as it is")
        entry_point = re.search(r"^ENTRYPOINT (.*)$", (CHECKOUT / "Dockerfile").read_text(), re.MULTILINE)[1]
        words = [word.replace("/map_matcher/build/release", build) for word in json.loads(entry_point)]
        shell = Shell(self.directory)
        shell.setup = ""
        done = shell.run(" ".join(map(shlex.quote, [*words, "rosrun", "map_matcher", "match_maps", "--help"])))
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("--reference", done.stdout)

    def check_setup_file(self, command):
        build = os.environ.get("MAP_MATCHER_BUILD")
        if not build:
            self.skipTest("runs in the environment as it is")
        self.assertTrue(command.words[1].startswith("build/release/"), command)
        path = command.words[1].replace("build/release", build, 1)
        self.assertTrue(Path(path).exists(), f"there is no {path}; scripts/build makes it")
        self.assertEqual(path, f"{build}/.install/setup.bash", "the other commands run with that one")

    def check_ending(self, shell, command):
        done = shell.run(command.text)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}")

    def check_arguments(self, shell, command):
        """roslaunch itself does not mind an argument that a launch file does not have."""
        listed = shell.run(command.asking("--ros-args")).stdout
        self.assertEqual(command.argument_names() - set(re.findall(r"^  (\w+)", listed, re.MULTILINE)), set(), command)

    def check_endless(self, shell, command):
        log_path = self.directory / "output.log"
        expected = set()
        if command.words[0] == "roslaunch":
            self.check_arguments(shell, command)
            expected = set(shell.run(command.asking("--nodes")).stdout.split())
            self.assertTrue(expected, command)
            commands = [command.text]
        else:
            commands = [f"roscore --port {shell.master.rsplit(':', 1)[1]}", command.text]
        with log_path.open("w") as log:
            processes = [shell.start(text, log) for text in commands]
            try:
                self.wait_for_nodes(shell, processes, expected, lambda: f"{command}\n{log_path.read_text()}")
            finally:
                for process in reversed(processes):
                    self.stop(process)
        self.assertNotIn("process has died", log_path.read_text(), command)

    def wait_for_nodes(self, shell, processes, expected, describe):
        """Until all expected nodes, or any when none are named, are up and nothing has ended."""
        for _ in range(int(DEADLINE / LOOK_AGAIN)):
            nodes = shell.nodes()
            if nodes and expected <= nodes:
                return
            try:
                processes[-1].wait(LOOK_AGAIN)
                self.fail(f"ended with status {processes[-1].returncode}: {describe()}")
            except subprocess.TimeoutExpired:
                continue
        self.fail(f"of {sorted(expected)} only {sorted(shell.nodes())} came up: {describe()}")

    @staticmethod
    def stop(process):
        for sign in (signal.SIGINT, signal.SIGKILL):
            if process.poll() is None:
                os.killpg(process.pid, sign)
                try:
                    process.wait(30)
                except subprocess.TimeoutExpired:
                    continue


def add_test(command):
    document = DOCUMENTS.index(command.document)
    name = re.sub(r"\W+", "_", " ".join([Path(command.document).stem, *command.words[:3]])).strip("_")
    setattr(DocumentedCommands, f"test_{document}_{command.line_number:04d}_{name}", lambda self: self.check(command))


for each in COMMANDS:
    add_test(each)
