"""Starts in offices that have changed since their maps were drawn: furniture was moved, doors were opened and shut."""
import buildings
from pages import arguments_of, section, write_starts
from starts import outcome_table
from trials import Trial

NAME = "changed_world"
MOVED = 0.333  # share of the furniture
SHUT = 0.25  # share of the doors, before and after, other ones
DENSITY = 0.3  # [people/m^2]
STARTS = 10  # in each office with each kind of scans
VARIANTS = ("original", "scrubbed")


def plan(runs, arguments):
    trials = []
    for seed in (1,) if arguments.quick else (1, 2, 3, 4):
        count = 2 if arguments.quick else STARTS
        reference = buildings.floor(runs, "before_%d" % seed, "--seed", seed, "--shut-doors", SHUT, "--change-seed", 1,
                                    resolution=buildings.COARSE)
        world = buildings.floor(runs, "after_%d" % seed, "--seed", seed, "--shut-doors", SHUT, "--change-seed", 2,
                                "--moved-furniture", MOVED)
        for variant in VARIANTS:
            run = buildings.starts(runs, "changed_world_%d_%s" % (seed, variant), world, reference, count, 1000 * seed,
                                   "--density", DENSITY, "--standing-share", 0.5,
                                   *(["--scrub"] if variant == "scrubbed" else []))
            trials.append(Trial(NAME, "generated_%d" % seed, variant, run, count))
    return trials


def trials_of(trials):
    return trials


def report(trials, page):
    write_starts(page / "changed_world.csv", trials)
    return section(
        "A changed world",
        "Starts at random places of generated offices whose maps were drawn before a third of the furniture was moved "
        "elsewhere in its room and before other doors were shut (a quarter then, another quarter now), among %g "
        "people/m^2, half of whom stand. [changed_world.csv](changed_world.csv)" % DENSITY,
        outcome_table("scans", trials, lambda trial: trial.condition), arguments_of([trial.run for trial in trials]))
