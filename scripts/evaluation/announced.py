"""Places that were announced, right or wrong, in all experiments together."""
from pages import section, table
from trials import RIGHT, TURN, announced_right, candidate_right

HEADER = ["experiment", "starts or pairs", "session maps", "announced", "wrong", "wrong, of the robot alone"]


def of_trials(trials):
    """Starts, session maps, announced places, wrong ones; of these, where the session map lies right and the mapper has
    lost the robot in it."""
    figures = [0, 0, 0, 0, 0]
    for trial in trials:
        figures[0] += len(trial.starts())
        for row in trial.run.rows():
            is_announced = row["matched"] == 1
            is_judged = not (trial.in_reference and row["translation_error"] is None)  # whether the truth is known
            is_wrong = is_announced and is_judged and not (trial.in_reference and announced_right(row))
            map_is_right = trial.in_reference and candidate_right(row, "candidate_map_error",
                                                                  "candidate_map_rotation_error")
            figures[1] += 1
            figures[2] += is_announced
            figures[3] += is_wrong
            figures[4] += bool(is_wrong and map_is_right)
    return figures


def of_pairs(pairs):
    """The same of pairs of maps."""
    outcomes = [outcome for outcome in (pair.outcome() for pair in pairs) if outcome]
    return [len(outcomes), len(outcomes), len(outcomes) - outcomes.count("silent"), outcomes.count("wrong"), 0]


def count(trials, pairs):
    """A line for each experiment, and one for all."""
    lines = []
    for name in dict.fromkeys(judged.experiment for judged in (*trials, *pairs)):
        drives = of_trials([trial for trial in trials if trial.experiment == name])
        maps = of_pairs([pair for pair in pairs if pair.experiment == name])
        lines.append([name, *[a + b for a, b in zip(drives, maps)]])
    return lines + [["**all**", *[sum(line[k] for line in lines) for k in range(1, len(HEADER))]]]


def num_wrong(counts):
    return counts[-1][HEADER.index("wrong")]


def part(counts, num_candidates):
    """The part of the page."""
    return section(
        "Wrong poses announced, all experiments together",
        "Every session map for which a place was announced, whatever else happened. Wrong: the robot is more than %g m "
        "or %g rad from where it was announced to be, or the reference map does not show where it is; of pairs of "
        "maps, the session map. The last column: those of them at which the session map lies right, but the mapper has lost "
        "the robot in it. All %d session maps, with the best place that was found for each, announced or not, and the "
        "evidence of it, are in `candidates.csv` beside the results of the runs." % (RIGHT, TURN, num_candidates),
        table(HEADER, counts))
