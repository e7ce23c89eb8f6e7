"""Report section 3.3.1, figures 8 to 14: a generated building without people, explored by frontiers."""
import shutil

from pages import (COLUMNS, absolute, arguments_of, picture, plot_match, plot_times, section, stage_time, table,
                   write_table)
from runs import Statistics
from trials import Trial

NAME = "static"
EXACT_ODOMETRY = [f"--alpha{k}=1e-6" for k in (1, 2, 3, 4)]


def duration_of(arguments):
    """Length of a drive [s]."""
    return 60 if arguments.quick else 800


def reference_of(runs, arguments, centimetres):
    """The reference map of cells of this size, which a run draws with sigma 0.01 m, and the configuration of the
    mapper."""
    config = runs.write_config("static_mapper_%dcm" % centimetres, delta=centimetres / 100)
    reference = runs.path("static_reference_%dcm.yaml" % centimetres)
    runs.add("static_reference_%dcm" % centimetres, "evaluate_drive",
             ["--output", runs.path("static_reference_%dcm.csv" % centimetres), "--session", reference,
              "--place-session", "--itinerary", "explore", "--duration", duration_of(arguments), "--seed", 100,
              "--sigma", 0.01, *EXACT_ODOMETRY, "--mapper-config", config], [reference])
    return reference, config


def plan(runs, arguments):
    """A drive for each resolution and sigma."""
    duration = duration_of(arguments)
    drives = []
    for centimetres in (5,) if arguments.quick else (5, 2):
        reference, config = reference_of(runs, arguments, centimetres)
        for sigma in (0.03,) if arguments.quick else (0.03, 0.05):
            name = "static_%dcm_sigma%g" % (centimetres, sigma)
            drives.append(runs.drive(name, [
                "--reference", reference, "--itinerary", "explore", "--duration", duration, "--seed", 1, "--sigma",
                sigma, "--mapper-config", config, "--first-overlay", runs.path(name + "_first.png"), "--last-overlay",
                runs.path(name + "_last.png")]))
    return runs, drives


def trials_of(planned):
    return [Trial(NAME, "generated_1", run.name, run) for run in planned[1]]


def report(planned, page):
    runs, drives = planned
    write_table(page / "static.csv", drives, COLUMNS)
    rows, parts = [], []
    for run in drives:
        queries = run.rows()
        if not queries:
            continue
        coarse = Statistics([stage_time(row, "coarse") for row in queries])
        fine = Statistics([stage_time(row, "fine") for row in queries])
        x = Statistics(absolute([row["alignment_x_error"] for row in queries]))
        y = Statistics(absolute([row["alignment_y_error"] for row in queries]))
        yaw = Statistics(absolute([row["alignment_yaw_error"] for row in queries]))
        rows.append([run.name, len(queries), sum(row["matched"] == 1 for row in queries), 1e3 * coarse.mean,
                     1e3 * fine.mean, x.mean, x.largest, y.mean, y.largest, yaw.mean, yaw.largest])
        plot_times(queries, page / (run.name + "_times.png"))
        plot_match(queries, page / (run.name + "_match.png"))
        for when in ("first", "last"):
            if runs.path("%s_%s.png" % (run.name, when)).exists():
                shutil.copy(runs.path("%s_%s.png" % (run.name, when)), page)
        parts += [picture(run.name + "_first.png", "The first match of %s (figure 8, top): cells on walls red." % run.name),
                  picture(run.name + "_last.png", "The last session map of %s (figure 8, bottom)." % run.name),
                  picture(run.name + "_times.png", "Time of each query of %s by step (figures 9 and 13)." % run.name),
                  picture(run.name + "_match.png", "Ratio and alignment error of %s (figures 10 and 14)." % run.name)]
    header = ["run", "queries", "matched", "coarse [ms]", "fine [ms]", "x error mean [m]", "worst", "y error mean [m]",
              "worst", "rotation error mean [rad]", "worst"]
    return section(
        "Static building",
        "Report section 3.3.1: a robot explores a generated office (55 m x 15 m) by frontiers. The reference map is "
        "drawn from a drive with a lidar of sigma 0.01 m and nearly exact odometry, the session maps with the sigma "
        "of the run; one query a session map. The match has its default hit_tolerance of 0.05 m, which a sigma of 0.05 m "
        "and the mapper's drift exceed: maps that fall below min_hit_ratio are not accepted. [static.csv](static.csv)",
        table(header, rows), *parts, arguments_of(runs_of(runs, "static")))


def runs_of(runs, prefix):
    return [run for run in runs.all if run.name.startswith(prefix)]
