"""Report figure 20: cold starts in crowds of growing density, with original and with scrubbed scans."""
import matplotlib.pyplot as plt
import office
from map_picture import draw_map
from pages import COLUMNS, arguments_of, picture, save, section, table, write_table
from trials import Trial

NAME = "cold_starts"
INTERVAL = 30.0  # [s] between two starts
PATIENCE = 20.0  # [s] in which the robot is to find itself
RIGHT = 1.0  # [m] of a correct start
DENSE = 1.0  # [people/m^2] beyond which a robot hardly moves, so that a short drive tells as much as a long one
VARIANTS = ("original", "scrubbed")
COLOURS = {"correct": "tab:green", "wrong": "tab:red", "none": "0.6"}


def simulations(arguments):
    """Density, seed and arguments of each simulated drive."""
    world = office.world(arguments)
    for density in (0, 1) if arguments.quick else (0, 0.3, 0.6, 1, 2, 3):
        duration = 60 if arguments.quick else 300 if density <= DENSE else 150
        for seed in (1,) if arguments.quick or density >= 1 else (1, 2):
            yield density, seed, [*world, "--duration", duration - 0.1, "--seed", seed, "--density", density,
                                  "--standing-share", 0.5]


def plan(runs, arguments):
    config = runs.write_config("cold_starts_mapper", delta=0.05, map_update_interval=1.0)
    drives = {}
    for density, seed, simulation in simulations(arguments):
        for variant in VARIANTS:
            drives.setdefault((density, variant), []).append(
                runs.drive("cold_starts_%g_%s_%d" % (density, variant, seed), [
                    *simulation, "--mapper-config", config, "--restart-interval", INTERVAL,
                    *(["--scrub"] if variant == "scrubbed" else [])], monte_carlo=True))
    return drives, office.recorded_map(arguments)


def trials_of(planned):
    drives, walls = planned
    building = "asl_office" if walls else "generated_1"
    return [Trial(NAME, building, "%g %s" % condition, run) for condition, runs in drives.items() for run in runs]


def starts_of(run):
    """Outcome and place of each start of a run."""
    sessions = {}
    for row in run.rows():
        sessions.setdefault(row["session"], []).append(row)
    starts = []
    for rows in sessions.values():
        first = next((row for row in rows if row["matched"] == 1 and row["session_age"] <= PATIENCE), None)
        if first is None:
            starts.append(("none", rows[0]))
        else:
            starts.append(("correct" if first["translation_error"] < RIGHT else "wrong", first))
    return starts


def report(planned, page):
    drives, walls = planned
    all_runs = [run for runs in drives.values() for run in runs]
    write_table(page / "cold_starts.csv", all_runs, COLUMNS)
    densities = sorted({density for density, _ in drives})
    rows, totals = [], {variant: [0, 0] for variant in VARIANTS}
    for density in densities:
        cells = [density]
        for variant in VARIANTS:
            outcomes = [outcome for run in drives[density, variant] for outcome, _ in starts_of(run)]
            correct = outcomes.count("correct")
            totals[variant][0] += correct
            totals[variant][1] += len(outcomes)
            cells += [len(outcomes), correct, outcomes.count("wrong"), outcomes.count("none")]
        rows.append(cells)
    shares = {variant: 100.0 * correct / max(1, count) for variant, (correct, count) in totals.items()}
    plot(drives, densities, walls, page / "cold_starts.png")
    header = ["people/m^2", *["%s: %s" % (v, what) for v in VARIANTS for what in ("starts", "correct", "wrong", "none")]]
    return section(
        "Cold starts in a crowd",
        "Report figure 20: the session map is thrown away every %g s; the first match within %g s is correct (less "
        "than %g m off), wrong, or there is none. Half of the people stand in groups. The report: 17.5 %% more correct "
        "starts with scrubbed scans. Here: %.1f %% of all starts are correct with original scans, %.1f %% with scrubbed "
        "ones. [cold_starts.csv](cold_starts.csv)" % (INTERVAL, PATIENCE, RIGHT, shares["original"],
                                                      shares["scrubbed"]),
        table(header, rows), picture("cold_starts.png", "Where the robot was at each start, and what became of it."),
        arguments_of(all_runs))


def plot(drives, densities, walls, path):
    """Each start where the robot was, on the map where it is a file."""
    figure, axes = plt.subplots(len(densities), 2, figsize=(11, 2.7 * len(densities)), squeeze=False, sharex=True,
                                sharey=True)
    for line, density in zip(axes, densities):
        for axis, variant in zip(line, VARIANTS):
            if walls:
                draw_map(axis, walls)
            for run in drives[density, variant]:
                for outcome, row in starts_of(run):
                    axis.plot(row["truth_x"], row["truth_y"], "o", color=COLOURS[outcome], markersize=4)
            axis.set_title("%s, %g people/m^2" % (variant, density), fontsize=9)
            axis.set_aspect("equal")
    save(figure, path)
