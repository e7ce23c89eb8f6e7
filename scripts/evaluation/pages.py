"""Text, tables and figures of the page."""
import csv
import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def text_of(value):
    if value is None or isinstance(value, float) and math.isnan(value):
        return "-"
    return "%.3g" % value if isinstance(value, float) else str(value)


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(text_of(value) for value in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def section(title, *paragraphs):
    return "\n\n".join(["## " + title, *[p.rstrip("\n") for p in paragraphs if p]]) + "\n"


def picture(name, caption):
    return "![%s](%s)\n\n*%s*" % (caption.split(".")[0], name, caption)


def arguments_of(runs, unlisted=()):
    """The runs with their arguments, to be unfolded; of the unlisted ones, those that failed."""
    runs = [*runs, *[run for run in unlisted if run.problem]]
    lines = ["<details><summary>%d runs</summary>" % len(runs), "", "```"]
    for run in runs:
        arguments = [a.rsplit("/", 1)[-1] for a in run.arguments]
        lines.append("%s: %s %s%s" % (run.name, run.program.name, " ".join(arguments),
                                      "    FAILED: " + run.problem if run.problem else ""))
    return "\n".join(lines + ["```", "", "</details>"])


def write_table(path, runs, columns, rows_of=lambda run: run.rows()):
    """The given columns of all rows of the runs, with the name of the run before them."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["run", *columns])
        for run in runs:
            for row in rows_of(run):
                writer.writerow([run.name, *["" if row.get(c) is None else text(row[c]) for c in columns]])


START_COLUMNS = ("session_age", "travelled", "hit_ratio", "margin", "translation_error", "rotation_error", "truth_x",
                 "truth_y", "candidate_error", "candidate_rotation_error")


def write_starts(path, trials):
    """A row for each start: what became of it, why not more, and the row that decided or came last."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["run", "building", "condition", "seed", "start", "outcome", "cause", *START_COLUMNS])
        for trial in trials:
            for start in trial.starts():
                row = start.row or {}
                writer.writerow([trial.run.name, trial.building, trial.condition, trial.seed(start.number),
                                 int(start.number), start.outcome, start.cause,
                                 *["" if row.get(c) is None else text(row[c]) for c in START_COLUMNS]])


PAIR_COLUMNS = ("status", "certified", "hit_ratio", "upper_bound", "margin", "search_time")


def write_pairs(path, pairs):
    """A row for each pair of maps: what became of it, and where the best place is off that was found."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["building", "set", "session", "outcome", *PAIR_COLUMNS, "candidate_error"])
        for pair in pairs:
            result = pair.result()
            if result is not None:
                writer.writerow([pair.building, *pair.session, pair.outcome(),
                                 *[text(result[c]) for c in PAIR_COLUMNS],
                                 "" if result["candidate"] is None or pair.truth is None
                                 else text(pair.errors(result["candidate"])[0])])


def text(value):
    return "%.6g" % value if isinstance(value, float) else value


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=80)
    plt.close(figure)


def stage_time(row, stage):
    """Seconds of a stage, from its three steps; None when it did not run."""
    steps = [row["%s_%s_time" % (stage, step)] for step in STEPS]
    return None if None in steps else sum(steps)


STEPS = ("initialization", "rotation_expansion", "depth_first_search")
STEP_NAMES = ("initialization", "expansion of the rotation nodes", "depth-first search")
COLUMNS = ["session", "time", "session_age", "travelled", "status", "ratio", "search_time", "coarse_ratio",
           *["coarse_%s_time" % step for step in STEPS], "fine_ratio", *["fine_%s_time" % step for step in STEPS],
           "certified", "hit_ratio", "upper_bound", "margin", "exact_time",
           "alignment_x_error", "alignment_y_error", "alignment_yaw_error", "truth_x", "truth_y", "translation_error",
           "rotation_error", "occupied", "falsely_occupied"]


def absolute(values):
    return [abs(value) for value in values if value is not None]


def plot_times(rows, path):
    """Report figures 9, 13 and 17: time of each query by step, and the proportions."""
    figure, axes = plt.subplots(2, 2, figsize=(11, 6))
    for column, stage in enumerate(("coarse", "fine")):
        known = [row for row in rows if stage_time(row, stage) is not None]
        times = [row["time"] for row in known]
        parts = [[1e3 * row["%s_%s_time" % (stage, step)] for row in known] for step in STEPS]
        axes[0][column].stackplot(times, parts, labels=STEP_NAMES)
        axes[0][column].set_title("%s stage" % stage)
        axes[0][column].set_ylabel("time of a query [ms]")
        axes[0][column].set_xlabel("time [s]")
        shares = [[part / max(1e-12, sum(step[k] for step in parts)) for k, part in enumerate(row)] for row in parts]
        axes[1][column].boxplot([share or [0.0] for share in shares])
        axes[1][column].set_xticks([1, 2, 3])
        axes[1][column].set_xticklabels(["initialization", "rotations", "depth first"])
        axes[1][column].set_ylabel("share of the time")
    axes[0][0].legend(loc="upper left", fontsize=8)
    save(figure, path)


def plot_match(rows, path):
    """Report figures 10, 14 and 18: match ratio and error of the alignment over time."""
    figure, axes = plt.subplots(3, 1, sharex=True, figsize=(9, 7))
    for stage in ("coarse", "fine"):
        known = [row for row in rows if row[stage + "_ratio"] is not None]
        axes[0].plot([row["time"] for row in known], [row[stage + "_ratio"] for row in known], ".-", label=stage)
    axes[0].set_ylabel("ratio of matched cells")
    axes[0].set_ylim(0, 1)
    axes[0].legend()
    known = [row for row in rows if row["alignment_x_error"] is not None]
    times = [row["time"] for row in known]
    for name in "xy":
        axes[1].plot(times, [row["alignment_%s_error" % name] for row in known], ".-", label=name)
    axes[1].set_ylabel("alignment error [m]")
    axes[1].legend()
    axes[2].plot(times, [row["alignment_yaw_error"] for row in known], ".-")
    axes[2].set_ylabel("alignment error [rad]")
    axes[2].set_xlabel("time [s]")
    save(figure, path)
