"""Runs of the package's programs whose results are kept."""
import csv
import json
import math
import subprocess


class BadInput(Exception):
    """Something that cannot be evaluated; the text tells what and why."""


class Run:
    """One call of a program, known by its name. It is done when its output is there, made with the same arguments."""

    def __init__(self, directory, name, program, arguments, outputs, phase):
        self.name = name
        self.program = program
        self.arguments = [str(argument) for argument in arguments]
        self.outputs = outputs
        self.phase = phase  # runs of later phases need the outputs of earlier ones
        self.problem = ""
        self._record = directory / (name + ".json")

    def done(self):
        try:
            with open(self._record, encoding="utf-8") as file:
                record = json.load(file)
        except (OSError, ValueError):
            return False
        return record["arguments"] == self.arguments and all(path.exists() for path in self.outputs)

    def carry_out(self):
        """Returns what went wrong, or an empty text."""
        done = subprocess.run([self.program, *self.arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              check=False)
        if done.returncode != 0:
            self.problem = done.stdout.decode().strip().split("\n")[-1] or "exit status %d" % done.returncode
            return self.problem
        with open(self._record, "w", encoding="utf-8") as file:
            json.dump({"arguments": self.arguments}, file)
        return ""

    def rows(self):
        """The rows of its CSV file with numbers where there are numbers, None where there is nothing; none of a run
        that failed."""
        if self.problem or not self.outputs[0].exists():
            return []
        with open(self.outputs[0], newline="", encoding="utf-8") as file:
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

    def __init__(self, directory, tools):
        self.directory = directory
        self.tools = tools
        self.all = []
        directory.mkdir(parents=True, exist_ok=True)

    def path(self, name):
        return self.directory / name

    def add(self, name, program, arguments, outputs, phase=0):
        run = Run(self.directory, name, self.tools / program, arguments, outputs, phase)
        self.all.append(run)
        return run

    def drive(self, name, arguments, phase=1):
        """A run of evaluate_drive; its first output is the table."""
        table = self.path(name + ".csv")
        return self.add(name, "evaluate_drive", ["--output", table, *arguments], [table], phase)

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
