#!/usr/bin/env python3
"""What is done to a node by force: signals in the middle of a search, kill -9, floods of maps, a subscriber that never
reads, reference maps replaced again and again. It ends when it is told to, and goes on when it is not."""
import os
import random
import signal
import socket
import struct
import subprocess
import time
import xmlrpc.client

import rosgraph
import roslib.packages
import rospy
from nav_msgs.msg import OccupancyGrid

from building import FREE, OCCUPIED, UNKNOWN, grid, reference_map, session_map
from map_matcher.msg import MapMatch
from node_fixture import DEADLINE, NodeFixture, run, wait_until

START = (12.3, 7.1, 0.7)  # T_reference_session
END_WITHIN = 1.0  # [s] after a signal
FLOOD = 100  # maps
FLOOD_RATE = 50.0  # [Hz]
MOST_GROWTH = 60e6  # [bytes] of the node in a flood


def of_another_building():
    """Specks everywhere, which fit nowhere well and are long searched for."""
    specks = random.Random(1)
    return grid("session_map", (-9.6, -9.6), (192, 192),
                lambda x, y: specks.choice((OCCUPIED, FREE, FREE, FREE, UNKNOWN)))


class Faults(NodeFixture):
    def start(self, **parameters):
        program = roslib.packages.find_node("map_matcher", "map_matcher_node")[0]
        self.node = subprocess.Popen([program, "__name:=map_matcher"] +
                                     ["_%s:=%s" % item for item in parameters.items()])
        self.addCleanup(self.node.wait)
        self.addCleanup(self.node.kill)
        wait_until(lambda: self.session.get_num_connections() == 1 and self.reference.get_num_connections() == 1,
                   "the node listens")

    def memory(self):
        """Of the node, resident [bytes]."""
        with open("/proc/%d/statm" % self.node.pid) as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def processor_time(self):
        """Of the node [s]."""
        with open("/proc/%d/stat" % self.node.pid) as file:
            fields = file.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def search_for_long(self):
        """The node is in the middle of a search that has no end within the test."""
        self.start(exact_deadline=600.0, hit_tolerance=0.0, min_hit_ratio=0.01)
        self.reference.publish(reference_map())
        session = of_another_building()
        session.header.stamp = rospy.Time.now()
        self.session.publish(session)
        before = self.processor_time()
        wait_until(lambda: self.processor_time() > before + 1.0, "the node searches")
        self.assertFalse([match for match in self.map_match.messages if match.session_stamp == session.header.stamp and
                          match.status != MapMatch.NO_REFERENCE])

    def test_a_signal_in_the_middle_of_a_search_ends_the_node(self):
        for kind in (signal.SIGINT, signal.SIGTERM):
            self.search_for_long()
            begin = time.monotonic()
            self.node.send_signal(kind)
            self.assertEqual(self.node.wait(DEADLINE), 0, kind)
            self.assertLess(time.monotonic() - begin, END_WITHIN, kind)
            self.map_match.clear()

    def test_a_node_that_was_killed_finds_the_robot_again_with_one_map(self):
        self.start()
        self.reference.publish(reference_map())
        self.match(session_map(START))
        self.node.kill()
        self.node.wait()

        began = rospy.Time.now()
        self.start()  # the maps are latched
        again = self.map_match.wait_for(lambda match: match.status == MapMatch.MATCHED and match.header.stamp > began,
                                        "a match")
        self.assert_pose(again.T_reference_session, START)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)

    def test_a_flood_of_maps_leaves_the_newest_one_matched_and_the_memory_bounded(self):
        self.start()
        self.reference.publish(reference_map())
        self.match(session_map(START))
        before = self.memory()
        flood = [session_map(START, seen=6.0 + 0.1 * k) for k in range(10)]
        rate = rospy.Rate(FLOOD_RATE)
        for k in range(FLOOD):
            flood[k % len(flood)].header.stamp = rospy.Time.now()
            self.session.publish(flood[k % len(flood)])
            rate.sleep()

        last = self.match(session_map(START))

        self.assert_pose(last.T_reference_session, START)
        self.assertLess(self.memory() - before, MOST_GROWTH)

    def test_a_subscriber_that_never_reads_holds_nobody_up(self):
        self.start()
        self.reference.publish(reference_map())
        self.match(session_map(START))
        with self.deaf_subscriber("/map_match", MapMatch), \
                self.deaf_subscriber("/map_matcher/reference_map", OccupancyGrid):
            before = self.memory()
            for k in range(20):
                self.match(session_map(START, seen=7.0 + 0.05 * k))
            self.assertLess(self.memory() - before, MOST_GROWTH)

    def deaf_subscriber(self, topic, kind):
        """A connection to the node's topic that is opened and never read from."""
        master = rosgraph.Master(rospy.get_name())
        uri = master.lookupNode("/map_matcher")
        _, _, (_, host, port) = xmlrpc.client.ServerProxy(uri).requestTopic(rospy.get_name(), topic, [["TCPROS"]])
        connection = socket.create_connection((host, port))
        fields = [b"callerid=/deaf", b"topic=" + topic.encode(), b"type=" + kind._type.encode(),
                  b"md5sum=" + kind._md5sum.encode()]
        header = b"".join(struct.pack("<I", len(field)) + field for field in fields)
        connection.sendall(struct.pack("<I", len(header)) + header)
        return connection

    def test_reference_maps_replaced_in_the_middle_of_searches_change_nothing_in_the_end(self):
        self.start()
        maps = [reference_map(), reference_map(shift=(1.0, 0.0))]
        session = session_map(START)
        for k in range(40):
            self.reference.publish(maps[k % 2])
            if k % 4 == 0:
                session.header.stamp = rospy.Time.now()
                self.session.publish(session)
            time.sleep(0.01)
        self.map_match.clear()
        self.reference.publish(maps[0])

        match = self.match(session_map(START, seen=7.9))

        self.assert_pose(match.T_reference_session, START)
        self.assert_pose(self.wait_for_tf("map", "session_map").transform, START)


if __name__ == "__main__":
    run("faults", Faults)
