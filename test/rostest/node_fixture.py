"""What the node tests share: publishers and listeners of the node's topics, and waiting for conditions."""
import math
import threading
import time
import unittest
import xmlrpc.client

import geometry_msgs.msg
import rosgraph
import rosgraph_msgs.msg
import rospy
import tf2_msgs.msg
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from nav_msgs.msg import OccupancyGrid

from map_matcher.msg import MapMatch

DEADLINE = 20.0  # [s], for anything that is to happen
QUIET = 0.5  # [s], for anything that is not to happen
CELL = 0.1  # [m], resolution of the test maps
ROTATION_STEP = 0.01  # [rad], no smaller than that of the test maps' fine stage


class Listener:
    """Keeps all messages of a topic."""

    def __init__(self, topic, kind):
        self._changed = threading.Condition()
        self.messages = []
        self._subscriber = rospy.Subscriber(topic, kind, self._on_message, queue_size=1000)

    def _on_message(self, message):
        with self._changed:
            self.messages.append(message)
            self._changed.notify_all()

    def wait_for(self, condition, what, deadline=DEADLINE):
        """The first message that fulfils the condition; fails after the deadline [s]."""
        end = time.monotonic() + deadline
        looked_at = 0
        with self._changed:
            while True:
                for message in self.messages[looked_at:]:
                    looked_at += 1
                    if condition(message):
                        return message
                left = end - time.monotonic()
                if left <= 0 or not self._changed.wait(left):
                    raise AssertionError("no %s within %g s; last message: %s" % (
                        what, deadline, self.messages[-1] if self.messages else "none"))

    def clear(self):
        with self._changed:
            self.messages = []

    def wait_until_served(self):
        """Waits until a publisher of the topic would send to this listener. The listener's own count of connections
        rises before that: what is published between the two is lost."""
        wait_until(self._is_served, "%s is served" % self._subscriber.resolved_name)

    def _is_served(self):
        master = rosgraph.Master(rospy.get_name())
        publishers = dict(master.getSystemState()[0]).get(self._subscriber.resolved_name, [])
        return any(self._is_served_by(master.lookupNode(publisher)) for publisher in publishers)

    def _is_served_by(self, publisher_uri):
        own_name, topic = rospy.get_name(), self._subscriber.resolved_name
        connections = xmlrpc.client.ServerProxy(publisher_uri).getBusInfo(own_name)[2]
        return any((peer, direction, name) == (own_name, "o", topic)
                   for _, peer, direction, _, name, *_ in connections)


class NodeFixture(unittest.TestCase):
    """A test beside a running map_matcher node; topics have their default names."""

    def setUp(self):
        self.map_match = Listener("map_match", MapMatch)
        self.tf = Listener("/tf", tf2_msgs.msg.TFMessage)
        self.log = Listener("/rosout", rosgraph_msgs.msg.Log)
        self.session = rospy.Publisher("session_map", OccupancyGrid, queue_size=10, latch=True)
        self.reference = rospy.Publisher("reference_map", OccupancyGrid, queue_size=10, latch=True)

    def tearDown(self):
        self.session.unregister()
        self.reference.unregister()

    def match(self, session, status=MapMatch.MATCHED, reference_frame=None):
        """Publishes a session map, told from others by its stamp, and returns what the node reports about it; with
        `reference_frame`, about it and the reference map of that frame."""
        session.header.stamp = rospy.Time.now()
        self.session.publish(session)
        return self.map_match.wait_for(
            lambda match: match.session_stamp == session.header.stamp and match.status == status and
            reference_frame in (None, match.reference_frame),
            "map_match with status %d" % status)

    def wait_for_tf(self, parent, child, deadline=DEADLINE):
        """The next transform from parent to child on /tf."""
        self.tf.clear()
        message = self.tf.wait_for(lambda tf: any(is_between(t, parent, child) for t in tf.transforms),
                                   "transform %s -> %s" % (parent, child), deadline)
        return next(t for t in message.transforms if is_between(t, parent, child))

    def assert_no_tf(self, child):
        """Nobody sends a transform to the frame for a while."""
        self.tf.clear()
        time.sleep(QUIET)
        self.assertFalse([t for tf in self.tf.messages for t in tf.transforms if t.child_frame_id == child])

    def assert_pose(self, transform, expected, tolerance=(CELL, ROTATION_STEP)):
        """A geometry_msgs/Transform is (x, y, yaw), within a cell and a rotation step."""
        self.assertLess(math.hypot(transform.translation.x - expected[0], transform.translation.y - expected[1]),
                        tolerance[0] * math.sqrt(2))
        yaw = 2 * math.atan2(transform.rotation.z, transform.rotation.w)
        self.assertLess(abs(math.remainder(yaw - expected[2], 2 * math.pi)), tolerance[1])


def wait_until(condition, what, deadline=DEADLINE):
    """Looks again and again whether the condition holds; fails after the deadline [s]."""
    end = time.monotonic() + deadline
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("not within %g s: %s" % (deadline, what))
        time.sleep(0.01)


def wait_for_diagnostic(name, condition):
    """The values of the first status of this name on /diagnostics that fulfils the condition."""
    diagnostics = Listener("/diagnostics", DiagnosticArray)
    array = diagnostics.wait_for(lambda message: any(s.name == name and condition(s) for s in message.status),
                                 "diagnostic of " + name)
    status = next(s for s in array.status if s.name == name)
    return {pair.key: pair.value for pair in status.values}


def stamped_transform(parent, child, pose, stamp):
    """T_parent_child = (x, y, yaw) as a message."""
    message = geometry_msgs.msg.TransformStamped()
    message.header.frame_id, message.header.stamp = parent, stamp
    message.child_frame_id = child
    message.transform.translation.x, message.transform.translation.y = pose[0], pose[1]
    message.transform.rotation.z, message.transform.rotation.w = math.sin(pose[2] / 2), math.cos(pose[2] / 2)
    return message


def broadcast_static(parent, child, pose):
    """Sends T_parent_child = (x, y, yaw) on /tf_static as long as the returned broadcaster lives."""
    broadcaster = tf2_ros.StaticTransformBroadcaster()
    broadcaster.sendTransform(stamped_transform(parent, child, pose, rospy.Time.now()))
    return broadcaster


def is_between(transform, parent, child):
    return transform.header.frame_id == parent and transform.child_frame_id == child


def run(name, test_class):
    import rostest
    rospy.init_node(name)
    rostest.rosrun("map_matcher", name, test_class)
