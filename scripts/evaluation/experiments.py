"""The experiments of an evaluation. Each has a NAME, plan(runs, arguments), which names the runs it needs, and
report(plan, page), which draws figures into the directory of the page and returns its part of the text. Those that
let session maps be matched have trials_of(plan), their drives, or pairs_of(plan), their pairs of maps."""
import announced
import candidates
import changed_world
import cold_starts
import crowd
import goals
import look_alikes
import mapping
import missing_part
import monte_carlo
import noise
import own
import random_starts
import real_logs
import replay
import sessions
import static
import strangers
from runs import BadInput

ALL = [static, noise, crowd, random_starts, changed_world, missing_part, strangers, look_alikes, cold_starts, mapping,
       monte_carlo, real_logs, sessions]


def own_bag(arguments):
    """Offline with session_mapper, or with a mapper that is asked for through replay."""
    for path in (arguments.bag, arguments.map):
        if not path.exists():
            raise BadInput("there is no file '%s'" % path)
    return replay.Replay(arguments) if arguments.mapper else own.Bag(arguments)


def judged_by(chosen, plans):
    """The trials and the pairs of maps of all experiments."""
    trials = [trial for e, plan in zip(chosen, plans) if hasattr(e, "trials_of") for trial in e.trials_of(plan)]
    pairs = [pair for e, plan in zip(chosen, plans) if hasattr(e, "pairs_of") for pair in e.pairs_of(plan)]
    return trials, pairs


def summaries(chosen, plans, directory):
    """The parts of the page about all experiments together, which come first; none where no session map was matched.
    Leaves the table of candidates in the directory."""
    trials, pairs = judged_by(chosen, plans)
    if not trials and not pairs:
        return []
    counts = announced.count(trials, pairs)
    count = candidates.write_candidates(directory / "candidates.csv", trials, pairs)
    by_name = {experiment.NAME: plan for experiment, plan in zip(chosen, plans)}
    return [goals.part(by_name, trials, announced.num_wrong(counts)), announced.part(counts, count)]


def write_page(page, parts, arguments, num_open):
    """The page of an evaluation, from the parts of its experiments."""
    kind = " of a bag" if arguments.bag else ", quick" if arguments.quick else ""
    head = ["# Evaluation" + kind, "",
            "Written by `scripts/evaluate`; do not edit. Each table and figure comes from the CSV file named beside it, "
            "each row of which holds the run it belongs to; the runs' arguments, seeds included, are listed at the "
            "end of each part. Session maps are drawn by %s." % (
                arguments.mapper if arguments.bag and arguments.mapper else "session_mapper, unless the part says "
                "otherwise"), ""]
    if arguments.note:
        head += [arguments.note, ""]
    if num_open > 0:
        head += ["**%d runs were not done yet and are missing from the tables.**" % num_open, ""]
    (page / "README.md").write_text("\n".join(head + parts), encoding="utf-8")
