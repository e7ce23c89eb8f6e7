"""Runs nodes and launch files that are to end by themselves."""
import subprocess

import roslib.packages
import rospy

from node_fixture import wait_until

DEADLINE = 20.0  # [s]
BAD_INPUT = 2  # exit code


def node_command(executable, name, **parameters):
    """What starts a node of this package under a name, with private parameters."""
    return [roslib.packages.find_node("map_matcher", executable)[0], "__name:=" + name,
            *("_%s:=%s" % item for item in parameters.items())]


def run_tool(name, *arguments):
    """Runs a program of this package to its end, which has to be a good one."""
    subprocess.run([roslib.packages.find_node("map_matcher", name)[0], *arguments], check=True)


def run_node(executable, remappings=None, **parameters):
    """Starts a node of this package with remapped names and private parameters, waits until it ends, and returns its
    exit code and output."""
    arguments = ["%s:=%s" % item for item in (remappings or {}).items()]
    done = subprocess.run([*node_command(executable, "under_test", **parameters), *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=DEADLINE, check=False)
    if rospy.has_param("/under_test"):
        rospy.delete_param("/under_test")
    return done.returncode, done.stdout.decode()


def run_launch(launch_file, deadline, *arguments):
    """Starts a launch file of this package and waits until it ends; fails after the deadline [s]."""
    launch = subprocess.Popen(["roslaunch", "map_matcher", launch_file, *arguments])
    try:
        wait_until(lambda: launch.poll() is not None, "%s ended" % launch_file, deadline)
    finally:
        launch.terminate()
        launch.wait()
