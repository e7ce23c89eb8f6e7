"""The report's comparison with Monte-Carlo localization without a prior, on the drives of the cold starts."""
import amcl
import cold_starts
import matplotlib.pyplot as plt
from cold_starts import COLOURS, INTERVAL, PATIENCE, RIGHT, VARIANTS
from pages import arguments_of, picture, save, section, table, write_table
from runs import Statistics

NAME = "monte_carlo"
SPREAD = 0.5  # [m] standard deviation of the particles below which they have converged
TURN = 0.25  # [rad] the same of their heading
COLUMNS = ["session", "time", "session_age", "travelled", "estimate_x", "estimate_y", "estimate_yaw",
           "position_deviation", "yaw_deviation", "particles", "updates", "update_time", "truth_x", "truth_y",
           "translation_error", "rotation_error"]


def plan(runs, arguments):
    drives, _ = cold_starts.plan(runs, arguments)
    return drives, amcl.plan(runs, arguments) if arguments.amcl else {}


def sessions_of(rows):
    sessions = {}
    for row in rows:
        sessions.setdefault(row["session"], []).append(row)
    return list(sessions.values())


def converged(row):
    return row["position_deviation"] < SPREAD and row["yaw_deviation"] < TURN


def starts_of(rows_of_run):
    """Of each start: its outcome, as for the maps, the row it comes from, and the rows after that."""
    starts = []
    for rows in sessions_of(rows_of_run):
        first = next((k for k, row in enumerate(rows) if converged(row) and row["session_age"] <= PATIENCE), None)
        if first is None or rows[first]["translation_error"] is None:
            starts.append(("none", rows[0], []))
        else:
            right = rows[first]["translation_error"] < RIGHT
            starts.append(("correct" if right else "wrong", rows[first], rows[first:]))
    return starts


def figures_of_estimates(tables):
    """Starts, correct, wrong, none, time to converge, error after it."""
    starts = [start for rows in tables for start in starts_of(rows)]
    outcomes = [outcome for outcome, _, _ in starts]
    correct = [(row, later) for outcome, row, later in starts if outcome == "correct"]
    return [len(starts), *[outcomes.count(outcome) for outcome in COLOURS],
            Statistics([row["session_age"] for row, _ in correct]).mean,
            Statistics([row["translation_error"] for _, later in correct for row in later]).mean]


def figures_of_filter(runs):
    """The same and the processor time: of each update, and of all updates for a second of driving."""
    rows = [row for run in runs for row in run.side_rows() if row["updates"]]
    driven = sum(rows[-1]["session_age"] for run in runs for rows in sessions_of(run.side_rows()))
    return [*figures_of_estimates([run.side_rows() for run in runs]),
            1e3 * Statistics([row["update_time"] for row in rows]).mean,
            1e3 * sum(row["update_time"] * row["updates"] for row in rows) / max(1e-9, driven)]


def figures_of_amcl(runs):
    """The same; amcl does not tell its processor time."""
    return [*figures_of_estimates([run.rows() for run in runs]), None, None]


def figures_of_maps(runs):
    """The same of session maps and matcher; the time is that of the search."""
    outcomes, correct, errors, rows, ages = [], [], [], [], {}
    for run in runs:
        good = set()
        for outcome, row in cold_starts.starts_of(run):
            outcomes.append(outcome)
            if outcome == "correct":
                correct.append(row)
                good.add(row["session"])
        for row in run.rows():
            rows.append(row)
            ages[run.name, row["session"]] = row["session_age"]
            if row["session"] in good and row["matched"] == 1:
                errors.append(row["translation_error"])
    return [len(outcomes), *[outcomes.count(outcome) for outcome in COLOURS],
            Statistics([row["session_age"] + row["search_time"] for row in correct]).mean, Statistics(errors).mean,
            1e3 * Statistics([row["search_time"] for row in rows]).mean,
            1e3 * sum(row["search_time"] for row in rows) / max(1e-9, sum(ages.values()))]


def methods_of(replays):
    """Name, colour, runs by density and scans, and figures of each method."""
    methods = [("Monte-Carlo", "tab:orange", figures_of_filter)]
    if replays:
        methods.append(("amcl", "tab:red", figures_of_amcl))
    return [*methods, ("session maps", "tab:blue", figures_of_maps)]


def figures_by_density(drives, replays):
    """Figures of each density, kind of scans and method, in this order."""
    return {(density, variant, name): figures((replays if name == "amcl" else drives)[density, variant])
            for density in sorted({density for density, _ in drives}) for variant in VARIANTS
            for name, _, figures in methods_of(replays)}


def report(planned, page):
    drives, replays = planned
    all_runs = [run for runs in drives.values() for run in runs]
    all_replays = [run for runs in replays.values() for run in runs]
    write_table(page / "monte_carlo.csv", all_runs, COLUMNS, lambda run: run.side_rows())
    if replays:
        write_table(page / "amcl.csv", all_replays, [c for c in COLUMNS if c not in amcl.UNKNOWN])
    figures = figures_by_density(drives, replays)
    plot(figures, replays, page / "monte_carlo.png")
    header = ["people/m^2", "scans", "method", "starts", *COLOURS, "time to converge [s]", "error [m]", "update [ms]",
              "a second of driving [ms]"]
    return section(
        "Against Monte-Carlo localization without a prior",
        "The drives of the cold starts once more: MRPT's particle filter (`mrpt::slam::CMonteCarloLocalization2D`) "
        "gets the same scans and odometry as the mapper, starts every %g s without a pose, and is looked at whenever a "
        "session map is matched. It has amcl's parameters where it has such (KLD sampling down to 100 particles, "
        "likelihood field, 30 beams, updates after 0.2 m or 30 degrees), 50000 particles at first where amcl has "
        "5000, the true noise of the odometry, and likelihoods to the power of 0.3, with which it does better without "
        "people than with 1 or 0.1. It has *converged* when the standard deviation of its particles is below %g m and "
        "%g rad; what it says the first time within %g s is correct (less than %g m off) or wrong. The session maps "
        "are judged by their first match, as above. The error is that of all later estimates and matches of correct "
        "starts; update is the processor time of one update of the particles, or the search time of one session map "
        "without the time to draw it. %s [monte_carlo.csv](monte_carlo.csv)" % (
            INTERVAL, SPREAD, TURN, PATIENCE, RIGHT, amcl.SENTENCE if replays else amcl.LEFT_OUT),
        table(header, [[*key, *values] for key, values in figures.items()]),
        picture("monte_carlo.png", "Share of starts that are correct, wrong and undecided, and the time to the first "
                                   "correct answer."),
        arguments_of([*all_runs, *all_replays]))


def plot(figures, replays, path):
    """Above the shares of the outcomes, below the times: for each density a bar of each method and kind of scans."""
    colours = {name: colour for name, colour, _ in methods_of(replays)}
    figure, axes = plt.subplots(2, 1, figsize=(11, 7), sharex=True)
    places, last, labelled = [], None, set()
    for (density, variant, name), values in figures.items():
        place = 0 if not places else places[-1] + (1 if density == last else 2)
        bottom, last = 0.0, density
        for outcome, count in zip(COLOURS, values[1:4]):
            share = count / max(1, values[0])
            axes[0].bar(place, share, bottom=bottom, color=COLOURS[outcome], label=None if places else outcome)
            bottom += share
        axes[1].bar(place, values[4], color=colours[name], label=None if name in labelled else name)
        labelled.add(name)
        places.append(place)
    axes[0].set_ylabel("share of the starts")
    axes[1].set_ylabel("time to a correct answer [s]")
    axes[1].set_xticks(places)
    axes[1].set_xticklabels(["%s, %s, %g" % (name, variant, density) for density, variant, name in figures],
                            fontsize=7, rotation=90)
    axes[1].set_xlabel("method, scans, people/m^2")
    for axis in axes:
        axis.legend(fontsize=8, loc="upper left")
    save(figure, path)
