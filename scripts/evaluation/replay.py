"""A bag and map of the user's own, replayed through the nodes with a mapper of the user's choice."""
import json
import math
import shutil
import subprocess

from pages import arguments_of, picture, section, table
from runs import SCRIPTS, BadInput


class Replay:
    NAME = "replay"

    def __init__(self, arguments):
        self._arguments = arguments

    def plan(self, runs, _):
        asked = self._arguments
        arguments = ["map:=%s" % asked.map.resolve(), "mapper:=" + asked.mapper, "truth:=" + asked.truth]
        arguments += ["scan:=" + asked.scan] if asked.scan else []
        return runs.replay("replay_" + asked.mapper, "replay.launch", asked.bag.resolve(), asked.rate, arguments,
                           ["run.csv", "summary.json"])

    def report(self, run, page):
        rows = run.rows()
        if not rows:
            raise BadInput(run.problem or "bag '%s' gave no true pose on %s" % (self._arguments.bag,
                                                                               self._arguments.truth))
        table_file, summary_file = run.outputs
        summary = json.loads(summary_file.read_text(encoding="utf-8"))
        shutil.copy(table_file, page / "replay.csv")
        figures = [["true poses", summary["samples"]], ["with a pose on tf", summary["estimates"]],
                   ["first of them after [s]", summary["time_to_first_estimate"]]]
        for name, unit in (("translation", "m"), ("rotation", "rad")):
            error = summary[name] or {"mean": math.nan, "median": math.nan, "worst": math.nan}
            figures += [["%s error, %s [%s]" % (name, kind, unit), error[kind]] for kind in ("mean", "median", "worst")]
        parts = []
        if summary["estimates"]:
            subprocess.run([SCRIPTS / "plot_run", table_file, "--output", page / "replay.png", "--title",
                            self._arguments.bag.name], check=True)
            parts.append(picture("replay.png", "Errors of the robot's pose on tf, alignment and ratio over time."))
        if (table_file.parent / "overlay.png").exists():
            shutil.copy(table_file.parent / "overlay.png", page / "replay_overlay.png")
            parts.append(picture("replay_overlay.png", "The last session map where it was matched."))
        return section(
            "%s in %s, replayed with %s" % (self._arguments.bag.name, self._arguments.map.name, self._arguments.mapper),
            "Through `replay.launch` at %g times the recorded speed: the robot's pose on tf against the bag's truth. "
            "[replay.csv](replay.csv)" % self._arguments.rate,
            table(["", ""], figures), *parts, arguments_of([run]))
