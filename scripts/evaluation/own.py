"""A bag and map of the user's own."""
from monte_carlo import SPREAD, TURN, converged
from pages import COLUMNS, absolute, arguments_of, picture, plot_match, plot_times, section, table, write_table
from runs import BadInput, Statistics


class Bag:
    NAME = "own"

    def __init__(self, arguments):
        self._arguments = arguments
        self._runs = None

    def plan(self, runs, _):
        self._runs = runs
        return self._drive("own", self._arguments.truth)

    def _drive(self, name, truth):
        arguments = ["--bag", self._arguments.bag.resolve(), "--reference", self._arguments.map.resolve(),
                     "--last-overlay", self._runs.path("own_last.png")]
        for option, value in (("--truth", truth), ("--scan", self._arguments.scan)):
            arguments += [option, value] if value else []
        return self._runs.drive(name, arguments, monte_carlo=True)

    def _without_truth(self, run):
        """The run again without the truth, when that is what it failed for."""
        again = self._drive("own_without_truth", None)
        if not self._arguments.truth or not again.done() and again.carry_out():
            raise BadInput(run.problem)
        return again

    def report(self, run, page):
        notes = []
        if run.problem:
            problem, run = run.problem, self._without_truth(run)
            notes.append("**Without truth**, since it cannot be used: %s" % problem)
        notes += ["**Note**: %s" % warning for warning in run.warnings()]
        rows = run.rows()
        if not rows:
            raise BadInput("bag '%s' gave no session map" % self._arguments.bag)
        write_table(page / "own.csv", [run], COLUMNS)
        matched = [row for row in rows if row["matched"] == 1]
        if not matched:
            notes.append("**Note**: no session map was matched: the map may be another building's")
        plot_times(rows, page / "own_times.png")
        plot_match(rows, page / "own_match.png")
        errors = Statistics(absolute([row["translation_error"] for row in rows]))
        figures = [["session maps", len(rows)], ["matched", len(matched)],
                   ["time to the first match [s]", matched[0]["session_age"] if matched else None],
                   ["search time, mean [s]", Statistics([row["search_time"] for row in rows]).mean],
                   ["position error, mean [m]", errors.mean], ["position error, worst [m]", errors.largest],
                   *figures_of_filter(run)]
        return section("%s in %s" % (self._arguments.bag.name, self._arguments.map.name), *notes,
                       table(["", ""], figures), picture("own_times.png", "Time of each query by step."),
                       picture("own_match.png", "Ratio and alignment error."), arguments_of([run]))


def figures_of_filter(run):
    """When Monte-Carlo localization without a prior was sure of a place, and how far off it was from then on."""
    rows = run.side_rows()
    first = next((k for k, row in enumerate(rows) if converged(row)), None)
    later = [] if first is None else rows[first:]
    errors = Statistics([row["translation_error"] for row in later])
    return [["Monte-Carlo localization: deviation below %g m and %g rad after [s]" % (SPREAD, TURN),
             None if first is None else rows[first]["session_age"]],
            ["its position error from then on, mean [m]", errors.mean],
            ["its position error from then on, worst [m]", errors.largest]]
