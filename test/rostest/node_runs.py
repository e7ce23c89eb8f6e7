"""Runs nodes that are to end by themselves."""
import subprocess

import roslib.packages
import rospy

DEADLINE = 20.0  # [s]
BAD_INPUT = 2  # exit code


def run_node(executable, **parameters):
    """Starts a node of this package with private parameters, waits until it ends, and returns its exit code and
    output."""
    node = roslib.packages.find_node("map_matcher", executable)[0]
    arguments = ["_%s:=%s" % item for item in parameters.items()]
    done = subprocess.run([node, "__name:=under_test", *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=DEADLINE, check=False)
    rospy.delete_param("/under_test")
    return done.returncode, done.stdout.decode()
