"""Report section 3.3.2, figures 15 to 19 and table 1: trials among pedestrians in the recorded office."""
import math
import shutil

import matplotlib.pyplot as plt
import office
from pages import (COLUMNS, absolute, arguments_of, picture, plot_match, plot_times, save, section, stage_time, table,
                   write_table)
from runs import Statistics
from trials import Trial

NAME = "crowd"
RIGHT = 1.0  # [m]
VARIANTS = ("original", "scrubbed")
GMAPPING = {"slam_gmapping, original": False, "slam_gmapping, scrubbed": True}  # whether it is scrubbed
GMAPPING_PARAMETERS = {"delta": 0.02, "map_update_interval": 5.0, "maxRange": 20.0, "maxUrange": 19.9,
                       "linearUpdate": 0.2, "angularUpdate": 0.25, "xmin": -10, "ymin": -10, "xmax": 10, "ymax": 10}
PEOPLE = (5, 8, 10, 12, 15, 18, 20, 25, 30, 40)  # of each trial
REPORT = {  # table 1: mean, standard deviation, least, largest
    "coarse stage [s]": (2.898, 2.398, 0.100, 12.100),
    "fine stage [s]": (0.622, 1.025, 0.100, 7.950),
    "alignment error x [m]": (0.037, 0.033, 0.0, 0.160),
    "alignment error y [m]": (0.037, 0.046, 0.0, 0.240),
    "alignment error rotation [rad]": (2.92e-3, 2.55e-3, 0.0, 0.013),
    "time to the first match [s]": (1.910, 0.265, 1.500, 2.350),
    "robot's position error x [m]": None,
    "robot's position error y [m]": None,
    "robot's heading error [rad]": None,
}


def plan(runs, arguments):
    world = office.world(arguments)
    config = runs.write_config("crowd_mapper", delta=0.02, map_update_interval=5.0)
    trials = {variant: [] for variant in VARIANTS}
    drives = []
    for k, people in enumerate(PEOPLE[:2] if arguments.quick else PEOPLE):
        drive = ["--robot", "pepper", "--duration", 45 if arguments.quick else 300, "--seed", k + 1, "--people", people]
        drives.append(("crowd_%02d" % k, drive))
        for variant in VARIANTS:
            name = "crowd_%02d%s" % (k, "" if variant == "original" else "_" + variant)
            trials[variant].append(runs.drive(name, [
                *world, *drive, "--mapper-config", config, "--first-overlay", runs.path(name + "_first.png"),
                "--last-overlay", runs.path(name + "_last.png"), *(["--scrub"] if variant == "scrubbed" else [])]))
    if arguments.mapper:
        trials.update(plan_replays(runs, arguments, drives))
    return runs, trials, bool(world)


def plan_replays(runs, arguments, drives):
    """The same drives through the nodes with slam_gmapping, which takes the scans of one lidar; the session maps that
    it drew are then matched as those of session_mapper are."""
    config = runs.write_config("crowd_gmapping", **GMAPPING_PARAMETERS)
    map_file = office.map_file(runs, arguments)
    trials = {variant: [] for variant in GMAPPING}
    for name, drive in drives:
        bag = runs.path(name + ".bag")
        runs.add(name + "_bag", "simulate_drive", [*office.world(arguments), *drive, "--bag", bag], [bag])
        for variant, is_scrubbed in GMAPPING.items():
            replay = name + "_gmapping" + ("_scrubbed" if is_scrubbed else "")
            scrubbing = ["scrub:=true", "detections:=[dr_spaam_detections/front]"] if is_scrubbed else []
            maps = runs.replay(replay + "_replay", "replay.launch", bag, arguments.rate, [
                "map:=%s" % map_file, "mapper:=gmapping", "mapper_config:=%s" % config, "truth:=ground_truth",
                "scan:=sick_laser_front/scan", *scrubbing], ["session_maps.bag"], phase=2).outputs[0]
            trials[variant].append(runs.drive(replay, [
                "--bag", maps, "--session-maps", "session_map", "--truth", "ground_truth", "--reference", map_file,
                "--first-overlay", runs.path(replay + "_first.png"), "--last-overlay",
                runs.path(replay + "_last.png")], phase=3))
    return trials


def trials_of(planned):
    _, trials, has_office = planned
    building = "asl_office" if has_office else "generated_1"
    return [Trial(NAME, building, variant, run) for variant, variant_runs in trials.items() for run in variant_runs]


def values_of(trials):
    """What table 1 is about, from all queries of all trials."""
    queries = [row for run in trials for row in run.rows()]
    firsts = []
    for run in trials:
        first = next((row for row in run.rows() if row["matched"] == 1), None)
        if first:
            firsts.append(first["session_age"] + first["search_time"])
    return {
        "coarse stage [s]": [stage_time(row, "coarse") for row in queries],
        "fine stage [s]": [stage_time(row, "fine") for row in queries],
        "alignment error x [m]": absolute([row["alignment_x_error"] for row in queries]),
        "alignment error y [m]": absolute([row["alignment_y_error"] for row in queries]),
        "alignment error rotation [rad]": absolute([row["alignment_yaw_error"] for row in queries]),
        "time to the first match [s]": firsts,
        "robot's position error x [m]": differences(queries, "estimate_x", "truth_x"),
        "robot's position error y [m]": differences(queries, "estimate_y", "truth_y"),
        "robot's heading error [rad]": [row["rotation_error"] for row in queries],
    }


def differences(rows, name, other):
    return [abs(row[name] - row[other]) for row in rows if row[name] is not None and row[other] is not None]


def table_1(trials):
    """A line for each figure: the report's, then ours of each variant."""
    ours = {variant: values_of(runs) for variant, runs in trials.items()}
    lines = []
    for name, theirs in REPORT.items():
        statistics = [Statistics(values[name]) for values in ours.values()]
        for k, (figure, field) in enumerate((("mean", "mean"), ("std. dev.", "deviation"), ("min", "least"),
                                             ("max", "largest"))):
            lines.append([name, figure, theirs[k] if theirs else None, *[getattr(s, field) for s in statistics]])
    return lines


def outcome_of(variant, trials):
    """A sentence about the matches of a variant."""
    queries = [row for run in trials for row in run.rows()]
    matched = [row for row in queries if row["matched"] == 1]
    wrong = [row for row in matched if row["translation_error"] is not None and row["translation_error"] > RIGHT]
    misplaced = [row for row in matched if row["alignment_x_error"] is not None and
                 math.hypot(row["alignment_x_error"], row["alignment_y_error"]) > RIGHT]
    lost = [row for row in queries if row["status"] == "robot_lost"]
    drift = Statistics(absolute([row["heading_drift"] for row in queries])).mean
    return "With %s scans, %d of %d session maps were matched%s; the alignment of %d of them is more than %g m off, " \
           "the robot's pose with %d of them; the heading of the mapper was %.1f mrad off in the mean." % (
               variant, len(matched), len(queries),
               ", and %d more fitted, but not around the robot (robot_lost)" % len(lost) if lost else "",
               len(misplaced), RIGHT, len(wrong), 1e3 * drift)


def report(planned, page):
    runs, trials, has_office = planned
    every_run = [run for variant_runs in trials.values() for run in variant_runs]
    shown = next(variant for variant in (*GMAPPING, *VARIANTS) if variant in trials)  # the report's mapper, if there
    write_table(page / "crowd.csv", every_run, [*COLUMNS, "heading_drift", "estimate_x", "estimate_y"])
    plot_ratios(trials[shown], page / "crowd_ratios.png")
    parts = [picture("crowd_ratios.png", "Ratio of matched cells of all trials, %s scans (figure 19)." % shown)]
    study = trials[shown][-1]
    if study.rows():
        plot_times(study.rows(), page / "crowd_times.png")
        plot_match(study.rows(), page / "crowd_match.png")
        parts += [picture("crowd_times.png", "Time of each query of %s by step (figure 17)." % study.name),
                  picture("crowd_match.png", "Ratio and alignment error of %s (figure 18)." % study.name)]
        for when in ("first", "last"):
            if runs.path("%s_%s.png" % (study.name, when)).exists():
                shutil.copy(runs.path("%s_%s.png" % (study.name, when)), page)
                parts.append(picture("%s_%s.png" % (study.name, when),
                                     "The %s match of %s (figure 16)." % (when, study.name)))
    return section(
        "Crowd",
        "Report section 3.3.2: %d trials in %s with %s people who walk and stand, a Pepper with two lidars, random "
        "starts and waypoints; each with original and with scrubbed scans%s. %s [crowd.csv](crowd.csv)" % (
            len(trials["original"]),
            "the recorded ETH office at 2 cm" if has_office else "the generated office at 2 cm, since the recorded one "
            "is not there,", "%d to %d" % (PEOPLE[0], PEOPLE[len(trials["original"]) - 1]),
            ", by session_mapper, and replayed in real time by slam_gmapping, which takes the scans of the front lidar "
            "alone" if len(trials) > len(VARIANTS) else "",
            " ".join(outcome_of(variant, variant_runs) for variant, variant_runs in trials.items())),
        table(["table 1", "", "report", *trials], table_1(trials)),
        "The alignment error compares the frames of the two maps, as the report does: with a mapper that closes no "
        "loops, as session_mapper, it grows with the mapper's drift in heading times the distance from the start, "
        "while the error of the robot's pose stays that of the session map around it. Where the robot is far off and "
        "the alignment is not, the mapper has lost the robot in its own map, which still matches with what was drawn "
        "before; once it no longer fits around the robot, it is robot_lost. The report's mapper is slam_gmapping; "
        "`--mapper gmapping` adds it where it is installed.",
        *parts, arguments_of(every_run))


def plot_ratios(trials, path):
    figure, axes = plt.subplots(2, 1, sharex=True, figsize=(9, 5))
    for axis, stage in zip(axes, ("coarse", "fine")):
        for run in trials:
            known = [row for row in run.rows() if row[stage + "_ratio"] is not None]
            axis.plot([row["time"] for row in known], [row[stage + "_ratio"] for row in known], linewidth=0.8)
        axis.set_ylabel("%s ratio" % stage)
        axis.set_ylim(0, 1)
    axes[1].set_xlabel("time [s]")
    save(figure, path)
