"""Cold starts along recorded drives."""
from pages import COLUMNS, arguments_of, section, table, write_table

NAME = "real_logs"
BAGS = {  # name: map, parameters of the mapper, seconds between two starts
    "intel_raw_fullrate_first1088s": ("intel", {}, 60.0),
    "wean_robotdata1": ("wean", {"delta": 0.1}, 30.0),
    "wean_robotdata4": ("wean", {"delta": 0.1}, 30.0),
    "freiburg-101": ("freiburg-101", {"linearUpdate": 0.05, "angularUpdate": 0.05}, 60.0),
}
LENGTHS = (2.0, 4.0, 8.0, 16.0)  # [m] of travel
RIGHT = 1.0  # [m]


def plan(runs, arguments):
    drives = {}
    for bag, (map_name, parameters, interval) in BAGS.items():
        path, reference = arguments.data / "bags" / (bag + ".bag"), arguments.data / "maps" / (map_name + ".yaml")
        if not path.exists() or not reference.exists() or arguments.quick and bag != "wean_robotdata4":
            continue
        config = runs.write_config("real_logs_%s_mapper" % bag, map_update_interval=0.5, **parameters)
        drives[bag] = runs.drive("real_logs_" + bag, [
            "--bag", path, "--reference", reference, "--truth", "/ground_truth", "--mapper-config", config,
            "--restart-interval", interval])
    return drives


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
    for bag, run in drives.items():
        for length in LENGTHS:
            outcomes = outcomes_at(run.rows(), length)
            rows.append([bag, length, len(outcomes), *[outcomes.count(o) for o in ("correct", "wrong", "none")]])
    return section(
        "Real logs",
        "Cold starts along recorded drives: the session map is thrown away again and again, and matched after so many "
        "metres of travel. Correct: less than %g m off. [real_logs.csv](real_logs.csv)" % RIGHT,
        table(["bag", "travel [m]", "starts", "correct", "wrong", "none"], rows), arguments_of(list(drives.values())))
