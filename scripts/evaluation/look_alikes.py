"""Starts where other places look alike: copied rooms, corridors that repeat, floors with the same plan."""
import buildings
from pages import arguments_of, section, write_starts
from starts import outcome_table
from trials import Trial

NAME = "look_alikes"
STARTS = 20  # in each of them
WIDTH = 4  # [m] of copied rooms, a whole number of cells
KINDS = {  # name: options of generate_building, options of the drive
    "copied rooms, same furniture": (["--copied-rooms", WIDTH], []),
    "copied rooms, other furniture": (["--copied-rooms", WIDTH, "--copied-furniture", "false"], []),
    "bare corridor that repeats": (["--copied-rooms", WIDTH, "--furnished", "false"], []),
    "two floors, other furniture": (["--floors", 2], []),
}


def plan(runs, arguments):
    trials = []
    for k, (kind, (options, drive)) in enumerate(KINDS.items()):
        for seed in (1,) if arguments.quick else (1, 2):
            count = 2 if arguments.quick else STARTS
            world, reference = buildings.floor_and_reference(runs, "alike_%d_%d" % (k, seed), "--seed", seed, *options)
            run = buildings.starts(runs, "look_alikes_%d_%d" % (k, seed), world, reference, count,
                                   4000 + 1000 * k + 100 * seed, *drive)
            trials.append(Trial(NAME, "alike_%d_%d" % (k, seed), kind, run, count))
    return trials


def trials_of(trials):
    return trials


def report(trials, page):
    write_starts(page / "look_alikes.csv", trials)
    return section(
        "Look-alikes",
        "Starts at random places of generated offices in which other places look alike. Copied rooms are %g m wide and "
        "lie side by side along the corridors; lockers and plants in the corridors, foyer and hall differ. In the bare "
        "one nothing differs but foyer, hall and ends. Two floors lie in one reference map: the same plan with other "
        "furniture. To be silent is right where nothing tells the places apart. [look_alikes.csv](look_alikes.csv)" % (
            WIDTH), outcome_table("look-alike", trials, lambda trial: trial.condition),
        arguments_of([trial.run for trial in trials]))
