"""Report section 3.3.2, figures 15 to 19 and table 1: trials among pedestrians in the recorded office."""
import shutil

import matplotlib.pyplot as plt
from pages import (COLUMNS, absolute, arguments_of, picture, plot_match, plot_times, save, section, stage_time, table,
                   write_table)
from runs import Statistics

NAME = "crowd"
PEOPLE = (5, 8, 10, 12, 15, 18, 20, 25, 30, 40)  # of each trial
REPORT = {  # table 1: mean, standard deviation, least, largest
    "coarse stage [s]": (2.898, 2.398, 0.100, 12.100),
    "fine stage [s]": (0.622, 1.025, 0.100, 7.950),
    "alignment error x [m]": (0.037, 0.033, 0.0, 0.160),
    "alignment error y [m]": (0.037, 0.046, 0.0, 0.240),
    "alignment error rotation [rad]": (2.92e-3, 2.55e-3, 0.0, 0.013),
    "time to the first match [s]": (1.910, 0.265, 1.500, 2.350),
}


def plan(runs, arguments):
    office = arguments.data / "maps/asl_office.yaml"
    world = ["--map", office] if office.exists() else []
    config = runs.write_config("crowd_mapper", delta=0.02, map_update_interval=5.0)
    trials = []
    for k, people in enumerate(PEOPLE[:2] if arguments.quick else PEOPLE):
        name = "crowd_%02d" % k
        trials.append(runs.drive(name, [
            *world, "--robot", "pepper", "--duration", 45 if arguments.quick else 300, "--seed", k + 1, "--people",
            people, "--mapper-config", config, "--first-overlay", runs.path(name + "_first.png"), "--last-overlay",
            runs.path(name + "_last.png")]))
    return runs, trials, bool(world)


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
    }


def report(planned, page):
    runs, trials, has_office = planned
    write_table(page / "crowd.csv", trials, COLUMNS)
    rows = []
    for name, values in values_of(trials).items():
        ours = Statistics(values)
        for figure, theirs, value in zip(("mean", "std. dev.", "min", "max"), REPORT[name],
                                         (ours.mean, ours.deviation, ours.least, ours.largest)):
            rows.append([name, figure, theirs, value])
    plot_ratios(trials, page / "crowd_ratios.png")
    parts = [picture("crowd_ratios.png", "Ratio of matched cells of all trials (figure 19).")]
    study = trials[-1]
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
    queries = [row for run in trials for row in run.rows()]
    matched = [row for row in queries if row["matched"] == 1]
    wrong = [row for row in matched if row["translation_error"] is not None and row["translation_error"] > 1.0]
    return section(
        "Crowd",
        "Report section 3.3.2: %d trials in %s with %s people who walk and stand, a Pepper with two lidars, random "
        "starts and waypoints. %d session maps, %d matched, %d of them more than 1 m off. [crowd.csv](crowd.csv)" % (
            len(trials), "the recorded ETH office at 2 cm" if has_office else "the generated office at 2 cm, since the "
            "recorded one is not there,", "%d to %d" % (PEOPLE[0], PEOPLE[len(trials) - 1]), len(queries),
            len(matched), len(wrong)),
        table(["table 1", "", "report", "here"], rows), *parts, arguments_of(trials))


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
