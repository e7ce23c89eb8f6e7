"""A bag and map of the user's own."""
from pages import COLUMNS, absolute, arguments_of, picture, plot_match, plot_times, section, table, write_table
from runs import BadInput, Statistics


class Bag:
    NAME = "own"

    def __init__(self, arguments):
        for path in (arguments.bag, arguments.map):
            if not path.exists():
                raise BadInput("there is no file '%s'" % path)
        self._arguments = arguments

    def plan(self, runs, _):
        arguments = ["--bag", self._arguments.bag.resolve(), "--reference", self._arguments.map.resolve(),
                     "--last-overlay", runs.path("own_last.png")]
        for option, value in (("--truth", self._arguments.truth), ("--scan", self._arguments.scan)):
            arguments += [option, value] if value else []
        return runs.drive("own", arguments)

    def report(self, run, page):
        rows = run.rows()
        if not rows:
            raise BadInput(run.problem or "bag '%s' gave no session map" % self._arguments.bag)
        write_table(page / "own.csv", [run], COLUMNS)
        plot_times(rows, page / "own_times.png")
        plot_match(rows, page / "own_match.png")
        errors = Statistics(absolute([row["translation_error"] for row in rows]))
        figures = [["session maps", len(rows)], ["matched", sum(row["matched"] == 1 for row in rows)],
                   ["search time, mean [s]", Statistics([row["search_time"] for row in rows]).mean],
                   ["position error, mean [m]", errors.mean], ["position error, worst [m]", errors.largest]]
        return section("%s in %s" % (self._arguments.bag.name, self._arguments.map.name), table(["", ""], figures),
                       picture("own_times.png", "Time of each query by step."),
                       picture("own_match.png", "Ratio and alignment error."), arguments_of([run]))
