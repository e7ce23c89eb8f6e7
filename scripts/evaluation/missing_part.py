"""Starts in a part of the building that the reference map does not have."""
from pathlib import Path

import buildings
import office
import sessions
from map_picture import read_map
from pages import arguments_of, section, table, write_pairs, write_starts
from starts import outcome_table
from trials import OUTCOMES, Pair, Trial

NAME = "missing_part"
MARGIN = 3.0  # [m] of the missing part, at the border of which nobody starts
STARTS = 10  # in each part
THIRDS = 3
AROUND = 3.0  # [m] around what a recorded session map shows that the reference map lacks, too
CUT_MAP = Path(__file__).resolve().parent / "cut_map"


def worlds(runs, arguments):
    """Name, map to drive in, reference map and extent along x and y [m] of each building."""
    for seed in (1,) if arguments.quick else (1, 2, 3):
        world, reference = buildings.floor_and_reference(runs, "missing_%d" % seed, "--seed", seed)
        yield "generated_%d" % seed, world, reference, (0.0, 0.0, 55.0, 15.0)
    recorded = office.recorded_map(arguments)
    if recorded and not arguments.quick:
        x_min, x_max, y_min, y_max = read_map(recorded)[1]
        yield "asl_office", recorded, recorded, (x_min, y_min, x_max, y_max)


def plan(runs, arguments):
    return plan_drives(runs, arguments), plan_pairs(runs, arguments)


def plan_pairs(runs, arguments):
    """Each recorded session map in the reference map without the part that it shows."""
    pairs = []
    for set_name, case, reference, truth in sessions.cases(arguments):
        name = "missing_part_%s_%s" % (set_name, case.name)
        cut = runs.path(name + ".yaml")
        runs.add(name + "_map", CUT_MAP, [reference, case / "session.yaml", case / "truth.json", AROUND, cut], [cut])
        run = sessions.match(runs, name, cut, case / "session.yaml")
        pairs.append(Pair(NAME, sessions.building_of(set_name), (set_name, case.name), run, truth))
    return pairs


def plan_drives(runs, arguments):
    trials = []
    for name, world, reference, (x_min, y_min, x_max, y_max) in worlds(runs, arguments):
        width = (x_max - x_min) / THIRDS
        for k in (1,) if arguments.quick else range(THIRDS):
            count = 3 if arguments.quick else STARTS
            left, right = x_min + k * width, x_min + (k + 1) * width
            run = buildings.starts(
                runs, "missing_part_%s_%d" % (name, k), world, reference, count, 2000 + 100 * k,
                "--missing", left, y_min, right, y_max,
                "--area", left + (MARGIN if k > 0 else 0.0), y_min, right - (MARGIN if k < THIRDS - 1 else 0.0), y_max)
            trials.append(Trial(NAME, name, "third %d" % (k + 1), run, count))
    return trials


def trials_of(planned):
    return planned[0]


def pairs_of(planned):
    return planned[1]


def report(planned, page):
    trials, pairs = planned
    write_starts(page / "missing_part.csv", trials)
    write_pairs(page / "missing_part_maps.csv", pairs)
    return section(
        "A missing part",
        "The reference map lacks one third of the building, along its length; the robot starts in that third, %g m and "
        "more from the others, and its waypoints lie there, too. It may see or even reach what the map has: a start is "
        "right where the robot's pose is, wrong anywhere else, and to be silent is as good. "
        "[missing_part.csv](missing_part.csv)" % MARGIN,
        outcome_table("building", trials, lambda trial: trial.building),
        "Recorded session maps in their reference maps, where what they show and %g m around it are unknown: "
        "[missing_part_maps.csv](missing_part_maps.csv)" % AROUND if pairs else "",
        table(["building", "session maps", *OUTCOMES], outcomes_of(pairs)) if pairs else "",
        arguments_of([trial.run for trial in trials], unlisted=[pair.run for pair in pairs]))


def outcomes_of(pairs):
    lines = []
    for building in dict.fromkeys(pair.building for pair in pairs):
        outcomes = [pair.outcome() for pair in pairs if pair.building == building and pair.outcome()]
        lines.append([building, len(outcomes), *[outcomes.count(outcome) for outcome in OUTCOMES]])
    return lines
