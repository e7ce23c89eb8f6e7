#!/usr/bin/env python3
"""Lets a simulated Pepper drive among people with all nodes of pepper.launch, kills each of them on the way, and says how
long scans and maps took, what each node needed, and whether anything grew.

Writes into the directory: soak.csv, a row for each node and moment; summary.json; soak.png. The exit status is 1 when
something is not as it should be: see CHECKS.
"""
import argparse
import csv
import json
import math
import os
import signal
import struct
import subprocess
import sys
import threading
import time
import xmlrpc.client
from pathlib import Path

import rosgraph
import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped

from map_matcher.msg import MapMatch

HERE = Path(__file__).resolve().parent
LASERS = ("sick_laser_front/scan", "sick_laser_rear/scan")
KILLED = ("map_matcher_nodelets", "session_mapper", "map_matcher")  # in this order, on the first third of the way
WATCHED = (*KILLED, "crowd_simulator")
SAMPLE_PERIOD = 5.0  # [s]
MAPPER = "{delta: 0.02, maxRange: 20.0, map_update_interval: 1.0}"

# What has to be so.
CHECKS = {
    "recovery": 30.0,  # [s] after a kill, at most
    "scan_delay_99": 0.005,  # [s] by the scrubber, of 99 % of the scans, at most
    "dropped_scans": 0,  # while nothing was killed
    "growth": 0.01,  # of the memory of a node on the last half of the way, at most; the mapper's map may grow
    "wrong": 0.5,  # [m] farthest that an announced pose may be off
}


def stamp_of(header_bytes):
    """The stamp of a message that begins with a header."""
    return struct.unpack_from("<II", header_bytes, 4)


class Observer:
    """Listens to scans, maps and poses; all times are those of a steady clock."""

    def __init__(self):
        self.lock = threading.Lock()
        self.raw = {laser: {} for laser in LASERS}  # arrival by stamp
        self.scan_delays = []  # (arrival, [s])
        self.scrubbed_at = {laser: 0.0 for laser in LASERS}
        self.kept = {laser: set() for laser in LASERS}  # stamps that came out
        self.maps = {}  # arrival by stamp
        self.map_delays = []
        self.searches = []
        self.last_map = 0.0
        self.last_match = 0.0
        self.truth = {}
        self.errors = []
        self.subscribers = [
            rospy.Subscriber("session_map", rospy.AnyMsg, self.on_map, queue_size=10),
            rospy.Subscriber("map_match", MapMatch, self.on_match, queue_size=10),
            rospy.Subscriber("ground_truth", PoseStamped, self.on_truth, queue_size=100),
            rospy.Subscriber("robot_pose", PoseWithCovarianceStamped, self.on_pose, queue_size=100)]
        for laser in LASERS:
            for topic, callback in ((laser, self.on_raw), (laser + "_scrubbed", self.on_scrubbed)):
                self.subscribers.append(
                    rospy.Subscriber(topic, rospy.AnyMsg, callback, laser, queue_size=100, tcp_nodelay=True))

    def stop(self):
        """Nothing comes after this."""
        for subscriber in self.subscribers:
            subscriber.unregister()

    def on_raw(self, message, laser):
        now = time.monotonic()
        with self.lock:
            self.raw[laser].setdefault(stamp_of(message._buff), now)

    def on_scrubbed(self, message, laser):
        now = time.monotonic()
        stamp = stamp_of(message._buff)
        with self.lock:
            # The raw scan may take longer to come here than both ways through the scrubber.
            arrival = self.raw[laser].get(stamp, now)
            self.scan_delays.append((now, now - arrival))
            self.kept[laser].add(stamp)
            self.scrubbed_at[laser] = now

    def on_map(self, message):
        with self.lock:
            self.last_map = time.monotonic()
            self.maps[stamp_of(message._buff)] = self.last_map

    def on_match(self, match):
        now = time.monotonic()
        stamp = (match.session_stamp.secs, match.session_stamp.nsecs)
        with self.lock:
            if stamp in self.maps:
                self.map_delays.append((now, now - self.maps[stamp]))
                self.searches.append(match.search_time)
            if match.status == MapMatch.MATCHED:
                self.last_match = now

    def on_truth(self, pose):
        with self.lock:
            self.truth[round(pose.header.stamp.to_sec(), 2)] = (pose.pose.position.x, pose.pose.position.y)

    def on_pose(self, pose):
        with self.lock:
            truth = self.truth.get(round(pose.header.stamp.to_sec(), 2))
            if truth:
                position = pose.pose.pose.position
                self.errors.append(math.hypot(position.x - truth[0], position.y - truth[1]))

    def dropped(self, quiet):
        """Raw scans that never came out, but for those that came while `quiet(arrival)` does not hold."""
        with self.lock:
            last = {laser: max(self.kept[laser], default=(0, 0)) for laser in LASERS}
            return sum(1 for laser in LASERS for stamp, arrival in self.raw[laser].items()
                       if stamp < last[laser] and stamp not in self.kept[laser] and quiet(arrival))


class Process:
    """What a node's process needs, from /proc."""

    def __init__(self, pid):
        self.pid = pid
        self.ticks = self.read_ticks()
        self.time = time.monotonic()

    def read_ticks(self):
        fields = Path(f"/proc/{self.pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
        return int(fields[11]) + int(fields[12])

    def sample(self):
        """Memory [MB], threads, share of a processor since the last sample."""
        status = dict(line.split(":", 1) for line in
                      Path(f"/proc/{self.pid}/status").read_text(encoding="utf-8").splitlines())
        ticks, now = self.read_ticks(), time.monotonic()
        share = (ticks - self.ticks) / os.sysconf("SC_CLK_TCK") / max(now - self.time, 1e-3)
        self.ticks, self.time = ticks, now
        return int(status["VmRSS"].split()[0]) / 1024.0, int(status["Threads"]), share


class Nodes:
    """The processes of the nodes, which change when they are killed."""

    def __init__(self):
        self.master = rosgraph.Master("/soak")
        self.processes = {}

    def pid(self, name):
        try:
            return xmlrpc.client.ServerProxy(self.master.lookupNode("/" + name)).getPid("/soak")[2]
        except (OSError, rosgraph.MasterException, xmlrpc.client.Fault):
            return None  # killed, and not there again

    def sample(self, name):
        pid = self.pid(name)
        try:
            if pid is None:
                return None
            if name not in self.processes or self.processes[name].pid != pid:
                self.processes[name] = Process(pid)
                return None
            return (pid, *self.processes[name].sample())
        except (OSError, KeyError):
            return None  # it ended meanwhile

    def kill(self, name):
        pid = self.pid(name)
        if pid is None:
            raise RuntimeError(f"there is no node {name} to kill")
        os.kill(pid, signal.SIGKILL)


class Soak:
    def __init__(self, duration, directory):
        self.duration = duration
        self.directory = directory
        self.observer = Observer()
        self.nodes = Nodes()
        self.rows = []
        self.recoveries = {}
        self.kill_windows = []  # from, until
        self.begin = 0.0

    def run(self, launch):
        self.wait("the first match", lambda: self.observer.last_match > 0.0, 120.0)
        self.begin = time.monotonic()
        kills = {name: self.begin + self.duration * share for name, share in zip(KILLED, (0.1, 0.2, 0.3))}
        print(f"the robot is found; {self.duration / 60:g} min begin", flush=True)
        while time.monotonic() < self.begin + self.duration:
            if launch.poll() is not None:
                raise RuntimeError("the launch ended before its time")
            for name in [name for name, due in kills.items() if time.monotonic() > due]:
                del kills[name]
                self.kill(name)
            self.sample()
            time.sleep(SAMPLE_PERIOD)
        self.observer.stop()
        time.sleep(1.0)

    def wait(self, what, condition, deadline):
        end = time.monotonic() + deadline
        while not condition():
            if time.monotonic() > end:
                raise RuntimeError(f"no {what} within {deadline:g} s")
            time.sleep(0.05)

    def kill(self, name):
        killed = time.monotonic()
        self.nodes.kill(name)
        observer = self.observer
        if name == "map_matcher_nodelets":
            self.wait("scrubbed scans", lambda: min(observer.scrubbed_at.values()) > killed + 0.5, 120.0)
        elif name == "session_mapper":
            self.wait("session map", lambda: observer.last_map > killed, 120.0)
        self.wait("match", lambda: observer.last_match > max(killed, observer.last_map if name == "session_mapper" else 0),
                  120.0)
        self.recoveries[name] = time.monotonic() - killed
        self.kill_windows.append((killed - 1.0, time.monotonic() + 10.0))
        print(f"[{killed - self.begin:5.0f} s] killed {name}: all is well again after {self.recoveries[name]:.1f} s",
              flush=True)

    def sample(self):
        for name in WATCHED:
            sample = self.nodes.sample(name)
            if sample:
                self.rows.append((time.monotonic() - self.begin, name, *sample))

    def is_quiet(self, moment):
        return moment > self.begin and not any(begin <= moment <= end for begin, end in self.kill_windows)

    def growth(self, name):
        """Of the mean memory and of the threads, from the third quarter of the way to the last."""
        def mean(begin, end, column):
            values = [row[column] for row in self.rows
                      if row[1] == name and begin * self.duration <= row[0] < end * self.duration]
            return sum(values) / len(values) if values else math.nan
        memory = [mean(begin, begin + 0.25, 3) for begin in (0.5, 0.75)]
        threads = [mean(begin, begin + 0.25, 4) for begin in (0.5, 0.75)]
        return memory[1] / memory[0] - 1.0, threads[1] - threads[0], memory[1]

    def summary(self):
        quiet = lambda delays: [delay for moment, delay in delays if self.is_quiet(moment)]
        nodes = {}
        for name in WATCHED:
            growth, more_threads, memory = self.growth(name)
            shares = [row[5] for row in self.rows if row[1] == name]
            nodes[name] = {"memory_mb": memory, "memory_growth": growth, "thread_growth": more_threads,
                           "processor_share": sum(shares) / max(len(shares), 1)}
        return {"minutes": self.duration / 60.0, "recoveries_s": self.recoveries, "nodes": nodes,
                "scan_delay_s": quantiles(quiet(self.observer.scan_delays)),
                "dropped_scans": self.observer.dropped(self.is_quiet),
                "map_delay_s": quantiles(quiet(self.observer.map_delays)),
                "search_s": quantiles(self.observer.searches),
                "pose_error_m": quantiles(self.observer.errors)}

    def write(self, summary):
        with open(self.directory / "soak.csv", "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["time", "node", "pid", "memory_mb", "threads", "processor_share"])
            writer.writerows(self.rows)
        (self.directory / "summary.json").write_text(json.dumps(summary, indent=2) + "\n", encoding="utf-8")

    def draw(self):
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
        figure, (memory, share, delay) = pyplot.subplots(3, 1, figsize=(9, 9), sharex=True)
        for name in WATCHED:
            rows = [row for row in self.rows if row[1] == name]
            memory.plot([row[0] / 60 for row in rows], [row[3] for row in rows], label=name)
            share.plot([row[0] / 60 for row in rows], [100 * row[5] for row in rows], label=name)
        for label, delays in (("scan through the scrubber", self.observer.scan_delays),
                              ("answer to a session map", self.observer.map_delays)):
            delay.plot([(moment - self.begin) / 60 for moment, _ in delays],
                       [1000 * max(seconds, 1e-5) for _, seconds in delays], ".", markersize=1.5, label=label)
        memory.set_ylabel("memory [MB]")
        share.set_ylabel("processor [% of a core]")
        delay.set_ylabel("delay [ms]")
        delay.set_yscale("log")
        delay.set_xlabel("time [min]")
        for axes in (memory, share, delay):
            axes.legend(loc="upper right", fontsize="small")
            axes.set_xlim(left=0.0)
            axes.grid(alpha=0.3)
        figure.tight_layout()
        figure.savefig(self.directory / "soak.png", dpi=90)


def quantiles(values):
    """Number, median, 99 % and worst."""
    ordered = sorted(values)
    if not ordered:
        return {"number": 0}
    return {"number": len(ordered), "median": ordered[len(ordered) // 2],
            "99 %": ordered[min(len(ordered) - 1, math.ceil(0.99 * len(ordered)) - 1)], "worst": ordered[-1]}


def problems_of(summary):
    problems = [f"{name} was back after {seconds:.1f} s, expected at most {CHECKS['recovery']:g} s"
                for name, seconds in summary["recoveries_s"].items() if seconds > CHECKS["recovery"]]
    problems += [f"{name} was not killed" for name in KILLED if name not in summary["recoveries_s"]]
    for name, node in summary["nodes"].items():
        if name not in ("session_mapper", "crowd_simulator") and not node["memory_growth"] <= CHECKS["growth"]:
            problems.append(f"the memory of {name} grew by {100 * node['memory_growth']:.1f} %, expected at most "
                            f"{100 * CHECKS['growth']:g} %")
        if not abs(node["thread_growth"]) < 0.5:
            problems.append(f"the threads of {name} are {node['thread_growth']:+.1f}")
    delay = summary["scan_delay_s"].get("99 %", math.inf)
    if delay > CHECKS["scan_delay_99"]:
        problems.append(f"1 % of the scans are late by {1000 * delay:.1f} ms and more, expected less than "
                        f"{1000 * CHECKS['scan_delay_99']:g} ms")
    if summary["dropped_scans"] > CHECKS["dropped_scans"]:
        problems.append(f"{summary['dropped_scans']} scans were dropped")
    error = summary["pose_error_m"].get("worst", math.inf)
    if error > CHECKS["wrong"]:
        problems.append(f"the robot was {error:.2f} m from where it was announced to be")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=Path, help="for what is written; is made")
    parser.add_argument("--minutes", type=float, default=10.0, help="how long [10]")
    parser.add_argument("--people", type=int, default=30, help="how many people [30]")
    parser.add_argument("--seed", type=int, default=1, help="of the building [1]")
    arguments = parser.parse_args()
    directory = arguments.directory.resolve()
    directory.mkdir(parents=True, exist_ok=True)
    subprocess.run(["rosrun", "map_matcher", "generate_building", "--seed", str(arguments.seed), "--resolution", "0.02",
                    "--output", directory / "building.yaml"], check=True, stdout=subprocess.DEVNULL)
    (directory / "session_mapper.yaml").write_text(MAPPER + "\n", encoding="utf-8")
    with open(directory / "launch.log", "wb") as log:
        launch = subprocess.Popen(
            ["roslaunch", str(HERE / "soak.launch"), f"map:={directory / 'building.yaml'}",
             f"people:={arguments.people}", f"duration:={arguments.minutes * 60 + 400}",
             f"mapper_config:={directory / 'session_mapper.yaml'}"], stdout=log, stderr=subprocess.STDOUT)
    try:
        while not rosgraph.is_master_online():
            time.sleep(0.1)
        rospy.init_node("soak", disable_signals=True)
        soak = Soak(arguments.minutes * 60.0, directory)
        soak.run(launch)
        summary = soak.summary()
        soak.write(summary)
        soak.draw()
    finally:
        launch.send_signal(signal.SIGINT)
        launch.wait()
    print(json.dumps(summary, indent=2))
    problems = problems_of(summary)
    for problem in problems:
        print("NOT AS IT SHOULD BE: " + problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
