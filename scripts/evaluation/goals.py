"""What is asked of all experiments together, and what came of it."""
import random_starts
from pages import section, table
from trials import announced_right, share_text

SAID = 0.99  # probability from which an answer counts as sure
PROBABILITY = ("answer.probability", "evidence.probability")  # where answers may tell it


def starts_line(name, goal, starts):
    right = sum(start.outcome == "right" for start in starts)
    return [name, goal, "%d of %d" % (right, len(starts)), share_text(right, len(starts))]


def of_starts(plans):
    lines = []
    if "random_starts" in plans:
        plan = plans["random_starts"]
        sparse = [density for density in random_starts.densities_of(plan) if density <= 1.0]
        for name, goal, densities in (("up to 1 person/m^2", "99 %", sparse), ("2 people/m^2", "90 %", [2.0]),
                                      ("3 people/m^2", "50 %", [3.0])):
            starts = [start for density in densities for start in random_starts.starts_in(plan, density, "scrubbed")]
            lines += [starts_line("right within 20 s, %s, scrubbed" % name, goal, starts)] if starts else []
    if "changed_world" in plans:
        starts = [start for trial in plans["changed_world"] for start in trial.starts()]
        lines.append(starts_line("changed world, right within 20 s", "97 %", starts))
    return lines


def of_sessions(plans):
    outcomes = [pair.outcome() for pair in plans.get("sessions", ()) if pair.outcome()]
    right = outcomes.count("right")
    return [["recorded sessions", "67 of 70", "%d of %d" % (right, len(outcomes)),
             share_text(right, len(outcomes))]] if outcomes else []


def of_noise(plans):
    lines = []
    for run in plans["static"][1] if "static" in plans else ():
        rows = run.rows()
        right = sum(row["matched"] == 1 and announced_right(row) for row in rows)
        if "sigma0.05" in run.name:
            lines.append(["session maps of %s" % run.name, "110 of 113", "%d of %d" % (right, len(rows)),
                          share_text(right, len(rows))])
    return lines


def of_probability(trials):
    """Of the answers that were said to be this probable, which are right."""
    sure = [row["candidate_right"] for trial in trials for row in trial.judged()
            if any((row.get(name) or 0.0) >= SAID for name in PROBABILITY) and row["candidate_right"] is not None]
    return [["said %g %%, right" % (100.0 * SAID), "99 %", "%d of %d" % (sum(sure), len(sure)),
             share_text(sum(sure), len(sure))]] if sure else []


def part(plans, trials, num_wrong):
    """The part of the page, from the plans of experiments by name."""
    lines = [["wrong poses announced, all experiments", "0", str(num_wrong), "-"], *of_sessions(plans),
             *of_starts(plans), *of_noise(plans), *of_probability(trials)]
    return section("Goals", "What the other parts come to. The last column: percent, with the 95 % interval.",
                   table(["", "goal", "here", "[%]"], lines))
