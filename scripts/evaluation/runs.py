"""Runs of the package's programs whose results are kept."""
import csv
import json
import math
import subprocess
from pathlib import Path

MATCHING = ("evaluate_drive", "match_maps")  # programs that take parameters of the matcher
SCRIPTS = Path(__file__).resolve().parent.parent


class BadInput(Exception):
    """Something that cannot be evaluated; the text tells what and why."""


class Run:
    """One call of a program, known by its name. It is done when its output is there, made with the same arguments."""

    def __init__(self, directory, name, program, arguments, outputs, phase, accepted_statuses):
        self.name = name
        self.program = program
        self.arguments = [str(argument) for argument in arguments]
        self.outputs = outputs
        self.accepted_statuses = accepted_statuses
        self.phase = phase  # runs of later phases need the outputs of earlier ones
        self.problem = ""
        self._record = directory / (name + ".json")

    def done(self):
        record = self._read_record()
        return record.get("arguments") == self.arguments and all(path.exists() for path in self.outputs)

    def _read_record(self):
        try:
            with open(self._record, encoding="utf-8") as file:
                return json.load(file)
        except (OSError, ValueError):
            return {}

    def carry_out(self):
        """Returns what went wrong, or an empty text."""
        done = subprocess.run([self.program, *self.arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              check=False)
        lines = done.stdout.decode().strip().split("\n")
        if done.returncode not in self.accepted_statuses:
            self.problem = lines[-1] or "exit status %d" % done.returncode
            return self.problem
        warnings = [line.split("warning: ", 1)[1] for line in lines if "warning: " in line]
        with open(self._record, "w", encoding="utf-8") as file:
            json.dump({"arguments": self.arguments, "warnings": warnings}, file)
        return ""

    def warnings(self):
        """What the program warned of when the run was done."""
        return self._read_record().get("warnings", [])

    def rows(self):
        """The rows of its CSV file with numbers where there are numbers, None where there is nothing; none of a run
        that failed."""
        return self._rows_of(self.outputs[0])

    def side_rows(self):
        """The same of its second table, which is about what the drive is compared with."""
        return self._rows_of(self.outputs[1])

    def _rows_of(self, path):
        if self.problem or not path.exists():
            return []
        with open(path, newline="", encoding="utf-8") as file:
            return [{name: number(text) for name, text in row.items()} for row in csv.DictReader(file)]


def number(text):
    if text == "":
        return None
    try:
        return float(text)
    except ValueError:
        return text


class Runs:
    """All runs of an evaluation."""

    def __init__(self, directory, tools, config=None):
        self.directory = directory
        self.tools = tools
        self.config = config  # parameters of the matcher in all runs; None: its defaults
        self.all = []
        directory.mkdir(parents=True, exist_ok=True)

    def path(self, name):
        return self.directory / name

    def add(self, name, program, arguments, outputs, phase=0, accepted_statuses=(0,)):
        """The same name is the same run, whichever experiments need it."""
        for run in self.all:
            if run.name == name:
                return run
        if self.config and program in MATCHING:
            arguments = [*arguments, "--config", self.config]
        run = Run(self.directory, name, self.tools / program, arguments, outputs, phase, accepted_statuses)
        self.all.append(run)
        return run

    def drive(self, name, arguments, phase=1, monte_carlo=False):
        """A run of evaluate_drive; its first output is the table, the second one that of Monte-Carlo
        localization."""
        outputs = [self.path(name + ".csv")]
        options = ["--output", outputs[0]]
        if monte_carlo:
            outputs.append(self.path(name + "_monte_carlo.csv"))
            options += ["--monte-carlo", outputs[1]]
        return self.add(name, "evaluate_drive", [*options, *arguments], outputs, phase)

    def replay(self, name, launch_file, bag, rate, arguments, outputs, phase=0):
        """A run of scripts/replay_bag with more arguments of the launch file, which leaves the outputs in a directory
        of the run's name."""
        directory = self.path(name)
        setup = self.tools.parent.parent / "setup.bash"
        return self.add(name, SCRIPTS / "replay_bag", [setup, launch_file, bag, directory, rate, *arguments],
                        [directory / output for output in outputs], phase)

    def write_config(self, name, **parameters):
        path = self.path(name + ".yaml")
        path.write_text("".join("%s: %s\n" % item for item in parameters.items()), encoding="utf-8")
        return path

    def open(self):
        return [run for run in self.all if not run.done()]

    def failed(self):
        return [run for run in self.all if run.problem]


class Statistics:
    """Mean, standard deviation, least and largest of some numbers; nan of none."""

    def __init__(self, values):
        values = [value for value in values if value is not None]
        self.count = len(values)
        self.mean = sum(values) / len(values) if values else math.nan
        self.deviation = math.sqrt(sum((v - self.mean) ** 2 for v in values) / len(values)) if values else math.nan
        self.least = min(values, default=math.nan)
        self.largest = max(values, default=math.nan)
