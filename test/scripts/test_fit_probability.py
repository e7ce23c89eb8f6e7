#!/usr/bin/env python3
"""Fits the probability of places to tables of candidates whose answer is known."""
import csv
import math
import random
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts/fit_probability"
COLUMNS = ("building", "candidate_right", "answer.certified", "evidence.seen_through", "evidence.margin",
           "evidence.agreeing_walls", "evidence.probability")
TRUE = {"kBias": -6.0, "kMarginWeight": 30.0, "kSeenThroughWeight": -15.0, "kWallsWeight": 2.0}


def candidates(number, seed=1):
    """Places that are right as often as TRUE says."""
    draw = random.Random(seed)
    for k in range(number):
        margin, through, walls = draw.uniform(0.0, 0.2), draw.uniform(0.0, 0.5), draw.uniform(0.0, 30.0)
        evidence = TRUE["kBias"] + TRUE["kMarginWeight"] * margin + TRUE["kSeenThroughWeight"] * through + \
            TRUE["kWallsWeight"] * math.log1p(walls)
        right = draw.random() < 1.0 / (1.0 + math.exp(-evidence))
        yield {"building": "AB"[k % 2], "candidate_right": int(right), "answer.certified": 1.0,
               "evidence.seen_through": through, "evidence.margin": margin, "evidence.agreeing_walls": walls,
               "evidence.probability": 0.5}


class FitProbability(unittest.TestCase):
    def setUp(self):
        self._directory = tempfile.TemporaryDirectory()
        self.addCleanup(self._directory.cleanup)
        self.table = Path(self._directory.name) / "candidates.csv"
        self.diagram = Path(self._directory.name) / "diagram.png"

    def write(self, rows):
        with open(self.table, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, COLUMNS, restval="")
            writer.writeheader()
            writer.writerows(rows)

    def run_script(self, *arguments):
        return subprocess.run([SCRIPT, self.table, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, check=False)

    def test_finds_the_weights_that_the_places_were_drawn_with(self):
        self.write(candidates(20000))

        result = self.run_script("--diagram", self.diagram)

        self.assertEqual(result.returncode, 0, result.stderr)
        for line in result.stdout.splitlines()[:len(TRUE)]:
            name, value = line.split()[2], float(line.split()[4].rstrip(";"))
            self.assertLess(abs(value / TRUE[name] - 1.0), 0.1, line)
        self.assertIn("| A |", result.stdout)
        self.assertIn("| all |", result.stdout)
        self.assertTrue(self.diagram.read_bytes().startswith(b"\x89PNG"))

    def test_leaves_out_what_is_not_certified_and_what_was_followed(self):
        rows = list(candidates(2000))
        self.write(rows)
        expected = self.run_script().stdout
        uncertified = [{**row, "candidate_right": 1, "answer.certified": 0.0} for row in rows]
        followed = [{**row, "candidate_right": 1, "evidence.probability": ""} for row in rows]
        self.write(rows + uncertified + followed)

        self.assertEqual(self.run_script().stdout, expected)

    def test_tells_what_is_missing(self):
        self.write([])
        self.assertIn("0 certified places", self.run_script().stderr)
        self.table.write_text("building,candidate_right\nA,1\n", encoding="utf-8")
        self.assertIn("line 2", self.run_script().stderr)
        self.table.unlink()
        self.assertIn("candidates.csv", self.run_script().stderr)


if __name__ == "__main__":
    unittest.main()
