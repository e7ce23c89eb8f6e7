"""Cold starts at random places of an office, in crowds of growing density, with original and with scrubbed scans."""
import matplotlib.pyplot as plt
import office
from map_picture import draw_map
from pages import arguments_of, picture, save, section, write_starts
from starts import outcome_table
from trials import PATIENCE, RIGHT, TURN, Trial

NAME = "random_starts"
DENSITIES = (0, 0.3, 0.6, 1, 2, 3)  # [people/m^2]
STARTS = 40  # of each density
CHUNK = 10  # starts of a run
VARIANTS = ("original", "scrubbed")
COLOURS = {"right": "tab:green", "wrong": "tab:red", "silent": "0.6"}


def plan(runs, arguments):
    world = office.world(arguments)
    building = "asl_office" if world else "generated_1"
    config = runs.write_config("random_starts_mapper", delta=0.05, map_update_interval=1.0)
    densities, starts, chunk = ((0, 1), 3, 3) if arguments.quick else (DENSITIES, STARTS, CHUNK)
    trials = []
    for density in densities:
        for first in range(0, starts, chunk):
            seed = 1 + DENSITIES.index(density) * STARTS + first  # another place for each start of each density
            for variant in VARIANTS:
                run = runs.drive("random_starts_%g_%s_%d" % (density, variant, seed), [
                    *world, "--starts", chunk, "--seed", seed, "--duration", PATIENCE, "--density", density,
                    "--standing-share", 0.5, "--mapper-config", config,
                    *(["--scrub"] if variant == "scrubbed" else [])])
                trials.append(Trial(NAME, building, "%g %s" % (density, variant), run, chunk))
    return trials, office.recorded_map(arguments)


def trials_of(planned):
    return planned[0]


def starts_in(planned, density, variant):
    condition = "%g %s" % (density, variant)
    return [start for trial in planned[0] if trial.condition == condition for start in trial.starts()]


def densities_of(planned):
    return sorted({float(trial.condition.split()[0]) for trial in planned[0]})


def report(planned, page):
    trials, walls = planned
    write_starts(page / "random_starts.csv", trials)
    plot(planned, walls, page / "random_starts.png")
    return section(
        "Cold starts at random places",
        "Every start is a drive of its own from a random place and heading, with a seed of its own; half of the people "
        "stand in groups. The first place that is announced within %g s decides: right is the robot's pose to %g m and "
        "%g rad, wrong anything else; a start without one is silent, its cause the status of its last map. The "
        "intervals are Wilson's of 95 %%. [random_starts.csv](random_starts.csv)" % (PATIENCE, RIGHT, TURN),
        outcome_table("people/m^2, scans", trials, lambda trial: trial.condition),
        picture("random_starts.png", "Where the robot was at each start, and what became of it."),
        arguments_of([trial.run for trial in trials]))


def plot(planned, walls, path):
    """Each start where the robot was, on the map where it is a file."""
    densities = densities_of(planned)
    figure, axes = plt.subplots(len(densities), 2, figsize=(11, 2.7 * len(densities)), squeeze=False, sharex=True,
                                sharey=True)
    for line, density in zip(axes, densities):
        for axis, variant in zip(line, VARIANTS):
            if walls:
                draw_map(axis, walls)
            for start in starts_in(planned, density, variant):
                if start.row:
                    axis.plot(start.row["truth_x"], start.row["truth_y"], "o", color=COLOURS[start.outcome],
                              markersize=4)
            axis.set_title("%s, %g people/m^2" % (variant, density), fontsize=9)
            axis.set_aspect("equal")
    save(figure, path)
