"""Cold starts along recorded drives, as they were recorded and among simulated people."""
from pages import COLUMNS, arguments_of, section, table, write_table
from trials import Trial

NAME = "real_logs"
BAGS = {  # name: map, parameters of the mapper, seconds between two starts
    "intel_raw_fullrate_first1088s": ("intel", {}, 60.0),
    "wean_robotdata1": ("wean", {"delta": 0.1}, 30.0),
    "wean_robotdata4": ("wean", {"delta": 0.1}, 30.0),
    "freiburg-101": ("freiburg-101", {"linearUpdate": 0.05, "angularUpdate": 0.05}, 60.0),
}
LENGTHS = (2.0, 4.0, 8.0, 16.0)  # [m] of travel
RIGHT = 1.0  # [m]
VARIANTS = ("original", "scrubbed")


def plan(runs, arguments):
    drives = {}
    for bag, (map_name, parameters, interval) in BAGS.items():
        path, reference = arguments.data / "bags" / (bag + ".bag"), arguments.data / "maps" / (map_name + ".yaml")
        if not path.exists() or not reference.exists() or arguments.quick and bag != "wean_robotdata4":
            continue
        config = runs.write_config("real_logs_%s_mapper" % bag, map_update_interval=0.5, **parameters)
        scrubber = runs.write_config("real_logs_scrubber", mode="synchronised")
        for density in (0, 0.3):
            for variant in VARIANTS if density else VARIANTS[:1]:  # where nobody is, nobody is detected
                people = ["--density", density, "--standing-share", 0.5, "--seed", 1] if density else []
                scrub = ["--scrub", "--scrubber-config", scrubber] if variant == "scrubbed" else []
                drives[bag, density, variant] = runs.drive("real_logs_%s_%g_%s" % (bag, density, variant), [
                    "--bag", path, "--reference", reference, "--truth", "/ground_truth", "--mapper-config", config,
                    "--restart-interval", interval, *people, *scrub])
    return drives


def trials_of(drives):
    return [Trial(NAME, BAGS[bag][0], "%s %g %s" % (bag, density, variant), run)
            for (bag, density, variant), run in drives.items()]


def outcomes_at(rows, length):
    """Of each session: what its first map after so many metres says."""
    outcomes, seen = [], set()
    for row in rows:
        if row["session"] not in seen and row["travelled"] >= length:
            seen.add(row["session"])
            if row["matched"] != 1:
                outcomes.append("none")
            elif row["translation_error"] is not None:
                outcomes.append("correct" if row["translation_error"] < RIGHT else "wrong")
    return outcomes


def report(drives, page):
    if not drives:
        return section("Real logs", "Left out: the recorded bags are not there.")
    write_table(page / "real_logs.csv", list(drives.values()), COLUMNS)
    rows = []
    for (bag, density, variant), run in drives.items():
        cells = [bag, density, variant]
        for length in LENGTHS:
            outcomes = outcomes_at(run.rows(), length)
            cells.append(" / ".join(str(outcomes.count(outcome)) for outcome in ("correct", "wrong", "none")))
        rows.append(cells)
    return section(
        "Real logs",
        "Cold starts along recorded drives: the session map is thrown away again and again, and matched after so many "
        "metres of travel. Each cell: correct (less than %g m off) / wrong / none. With people per square metre, legs "
        "of simulated walkers, half of whom stand, are put into the recorded scans where the ground truth says how the "
        "robot stands to them; they hide what lies behind, and a simulated detector looks for them. The recorded robot "
        "does not wait for them. These lasers are slow (up to 3 s between two scans), so each scan waits for its "
        "detections (`mode: synchronised`). A place is that of the robot: it is wrong as well where the maps lie right on each "
        "other (alignment_x_error and so on in the table) but the mapper has slipped. [real_logs.csv](real_logs.csv)" % RIGHT,
        table(["bag", "people/m^2", "scans", *["%g m" % length for length in LENGTHS]], rows),
        arguments_of(list(drives.values())))
