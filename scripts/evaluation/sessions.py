"""Recorded session maps: what is proven of each, how far ahead it is, and what the refinement gains."""
import csv
import json
import math

from pages import arguments_of, section, table, text
from runs import Statistics

NAME = "sessions"
RIGHT = 0.5  # [m]
COLUMNS = ("set", "session", "status", "certified", "hit_ratio", "margin", "has_runner_up", "error_searched",
           "error_refined", "yaw_error_searched", "yaw_error_refined", "search_time")


def plan(runs, arguments):
    """Each session in the map of its case or of its set."""
    matches = []
    for truth in sorted(arguments.data.glob("sessions/*/*/truth.json")):
        case = truth.parent
        reference = next((r for r in (case / "reference.yaml", case.parent / "reference.yaml") if r.exists()), None)
        if reference is None or arguments.quick and case.parent.name != "intel-1m":
            continue
        name = "session_%s_%s" % (case.parent.name, case.name)
        output = runs.path(name + "_result.json")
        matches.append((truth, runs.add(name, "match_maps", [
            "--reference", reference, "--session", case / "session.yaml", "--json", output], [output],
                                        accepted_statuses=(0, 1))))
    return matches


def row_of(truth_file, run):
    """One row of the table; None of a run that failed."""
    if run.problem:
        return None
    truth = json.loads(truth_file.read_text(encoding="utf-8"))
    result = json.loads(run.outputs[0].read_text(encoding="utf-8"))

    def errors(pose):
        if pose is None:
            return None, None
        turn = (pose["yaw"] - truth["yaw"] + math.pi) % (2 * math.pi) - math.pi
        return math.hypot(pose["x"] - truth["x"], pose["y"] - truth["y"]), abs(turn)

    matched = result["transform"] is not None
    searched, refined = errors(result["searched"] if matched else None), errors(result["transform"])
    return dict(zip(COLUMNS, (
        truth_file.parent.parent.name, truth_file.parent.name, result["status"], int(result["certified"]),
        result["hit_ratio"], result["margin"], int(result["runner_up"] is not None), searched[0], refined[0],
        searched[1], refined[1], result["search_time"])))


def report(matches, page):
    rows = [row for row in (row_of(truth, run) for truth, run in matches) if row]
    if not rows:
        return section("Recorded sessions", "Left out: the recorded session maps are not there.")
    with open(page / "sessions.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for row in rows:
            writer.writerow(["" if row[c] is None else text(row[c]) for c in COLUMNS])
    lines = []
    for name in sorted({row["set"] for row in rows}):
        chosen = [row for row in rows if row["set"] == name]
        accepted = [row for row in chosen if row["error_refined"] is not None]
        lines.append([
            name, len(chosen), sum(row["certified"] for row in chosen), len(accepted),
            sum(row["error_refined"] > RIGHT for row in accepted),
            Statistics([row["hit_ratio"] for row in accepted]).least,
            Statistics([row["margin"] for row in accepted]).least,
            1e3 * Statistics([row["error_searched"] for row in accepted]).mean,
            1e3 * Statistics([row["error_refined"] for row in accepted]).mean,
            1e3 * Statistics([row["yaw_error_searched"] for row in accepted]).mean,
            1e3 * Statistics([row["yaw_error_refined"] for row in accepted]).mean,
            1e3 * Statistics([row["search_time"] for row in chosen]).mean])
    return section(
        "Recorded sessions",
        "Session maps drawn by slam_gmapping with a known place, each matched alone. Certified: it is proven that no "
        "pose has more hits, or that none has enough. Accepted: certified, and ahead of every other place by the margin. "
        "Wrong: more than %g m off. The errors are those of the origin of the session map, of the pose in whole cells "
        "(searched) and after the refinement; they hold what bends the two maps as well. "
        "[sessions.csv](sessions.csv)" % RIGHT,
        table(["set", "sessions", "certified", "accepted", "wrong", "least hit ratio", "least margin",
               "error searched [mm]", "refined [mm]", "rotation error searched [mrad]", "refined [mrad]",
               "search [ms]"], lines), arguments_of([run for _, run in matches]))
