"""Recorded session maps: what becomes of each, what is proven of it, and what the refinement gains."""
import csv
import json

from pages import arguments_of, section, table, text
from runs import Statistics
from trials import OUTCOMES, RIGHT, TURN, Pair, share_text

NAME = "sessions"
QUICK_SET = "intel-1m"
COLUMNS = ("set", "session", "outcome", "status", "certified", "hit_ratio", "margin", "has_runner_up",
           "candidate_error", "candidate_yaw_error", "error_searched", "error_refined", "yaw_error_searched",
           "yaw_error_refined", "search_time")


def cases(arguments):
    """Set, session, directory, reference map and truth of each recorded session map."""
    for truth in sorted(arguments.data.glob("sessions/*/*/truth.json")):
        case = truth.parent
        reference = next((r for r in (case / "reference.yaml", case.parent / "reference.yaml") if r.exists()), None)
        if reference and not (arguments.quick and case.parent.name != QUICK_SET):
            yield case.parent.name, case, reference, json.loads(truth.read_text(encoding="utf-8"))


def building_of(set_name):
    """The building that the sessions of a set are from: "intel-1m" is of intel, "asl_office_d0.3" of asl_office."""
    return next(b for b in ("asl_office", "freiburg-101", "intel", "wean") if set_name.startswith(b))


def match(runs, name, reference, session):
    """The run that matches a session map to a reference map."""
    output = runs.path(name + "_result.json")
    return runs.add(name, "match_maps", ["--reference", reference, "--session", session, "--json", output], [output],
                    phase=1, accepted_statuses=(0, 1))


def plan(runs, arguments):
    """Each session in the map of its case or of its set."""
    pairs = []
    for set_name, case, reference, truth in cases(arguments):
        run = match(runs, "session_%s_%s" % (set_name, case.name), reference, case / "session.yaml")
        pairs.append(Pair(NAME, building_of(set_name), (set_name, case.name), run, truth))
    return pairs


def pairs_of(pairs):
    return pairs


def row_of(pair):
    """One row of the table; None of a run that failed."""
    result = pair.result()
    if result is None:
        return None
    matched = result["transform"] is not None
    candidate = pair.errors(result["candidate"])
    searched, refined = pair.errors(result["searched"] if matched else None), pair.errors(result["transform"])
    return dict(zip(COLUMNS, (
        *pair.session, pair.outcome(), result["status"], int(result["certified"]), result["hit_ratio"],
        result["margin"], int(result["runner_up"] is not None), *candidate, searched[0], refined[0], searched[1],
        refined[1], result["search_time"])))


def report(pairs, page):
    rows = [row for row in map(row_of, pairs) if row]
    if not rows:
        return section("Recorded sessions", "Left out: the recorded session maps are not there.")
    with open(page / "sessions.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for row in rows:
            writer.writerow(["" if row[c] is None else text(row[c]) for c in COLUMNS])
    return section(
        "Recorded sessions",
        "Session maps drawn by slam_gmapping with a known place, each matched alone: %s. Right: at most %g m and %g "
        "rad off; wrong: farther; silent: nothing is announced. Certified: it is proven that no pose has more hits, or "
        "that none has enough. The errors are those of the origin of the session map, of the pose in whole cells (searched) "
        "and after the refinement; they hold what bends the two maps as well. [sessions.csv](sessions.csv)" % (
            outcomes_text(rows), RIGHT, TURN),
        table(["set", "sessions", *OUTCOMES, "right [%]", "certified", "least hit ratio", "least margin",
               "error searched [mm]", "refined [mm]", "rotation error searched [mrad]", "refined [mrad]",
               "search [ms]"], [line_of(name, rows) for name in sorted({row["set"] for row in rows})]),
        "By status, and whether the best place that was found is the right one:",
        table(["status", "sessions", "best place right", "best place wrong", "no place"],
              [status_line(status, rows) for status in sorted({row["status"] for row in rows})]),
        arguments_of([pair.run for pair in pairs]))


def outcomes_text(rows):
    outcomes = [row["outcome"] for row in rows]
    return ", ".join("%d %s" % (outcomes.count(outcome), outcome) for outcome in OUTCOMES) + " of %d" % len(rows)


def line_of(name, rows):
    chosen = [row for row in rows if row["set"] == name]
    outcomes = [row["outcome"] for row in chosen]
    accepted = [row for row in chosen if row["error_refined"] is not None]
    return [name, len(chosen), *[outcomes.count(outcome) for outcome in OUTCOMES],
            share_text(outcomes.count("right"), len(chosen)), sum(row["certified"] for row in chosen),
            Statistics([row["hit_ratio"] for row in accepted]).least,
            Statistics([row["margin"] for row in accepted]).least,
            *[1e3 * Statistics([row[c] for row in accepted]).mean for c in (
                "error_searched", "error_refined", "yaw_error_searched", "yaw_error_refined")],
            1e3 * Statistics([row["search_time"] for row in chosen]).mean]


def status_line(status, rows):
    chosen = [row for row in rows if row["status"] == status]
    found = [row for row in chosen if row["candidate_error"] is not None]
    right = [row for row in found if row["candidate_error"] < RIGHT and row["candidate_yaw_error"] < TURN]
    return [status, len(chosen), len(right), len(found) - len(right), len(chosen) - len(found)]
