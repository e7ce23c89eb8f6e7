"""The table of all places that were found, right and wrong, with their evidence: what a probability is fitted on."""
import csv

FIRST = ("experiment", "building", "condition", "run", "seed", "session", "age", "status", "announced",
         "candidate_right")


def write_candidates(path, trials, pairs):
    """A row for each judged session map; its columns are whatever the answers tell."""
    rows = [row for judged in (*trials, *pairs) for row in judged.judged()]
    names = dict.fromkeys(FIRST)
    for row in rows:
        names.update(dict.fromkeys(row))
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(names), restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return len(rows)
