"""The experiments of an evaluation. Each has a NAME, plan(runs, arguments), which names the runs it needs, and
report(plan, page), which draws figures into the directory of the page and returns its part of the text."""
import cold_starts
import crowd
import mapping
import monte_carlo
import own
import real_logs
import replay
import sessions
import static
from runs import BadInput

ALL = [static, crowd, cold_starts, mapping, monte_carlo, real_logs, sessions]


def own_bag(arguments):
    """Offline with session_mapper, or with a mapper that is asked for through replay."""
    for path in (arguments.bag, arguments.map):
        if not path.exists():
            raise BadInput("there is no file '%s'" % path)
    return replay.Replay(arguments) if arguments.mapper else own.Bag(arguments)


def write_page(page, parts, arguments, num_open):
    """The page of an evaluation, from the parts of its experiments."""
    kind = " of a bag" if arguments.bag else ", quick" if arguments.quick else ""
    head = ["# Evaluation" + kind, "",
            "Written by `scripts/evaluate`; do not edit. Each table and figure comes from the CSV file named beside it, "
            "each row of which holds the run it belongs to; the runs' arguments, seeds included, are listed at the "
            "end of each part. Session maps are drawn by %s." % (
                arguments.mapper if arguments.bag and arguments.mapper else "session_mapper, unless the part says "
                "otherwise"), ""]
    if num_open > 0:
        head += ["**%d runs were not done yet and are missing from the tables.**" % num_open, ""]
    (page / "README.md").write_text("\n".join(head + parts), encoding="utf-8")
