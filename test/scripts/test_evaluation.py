#!/usr/bin/env python3
"""What the evaluation makes of the tables of its runs."""

import csv
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(CHECKOUT / "scripts"), str(CHECKOUT / "scripts" / "evaluation")]

import announced  # noqa: E402
import candidates  # noqa: E402
import trials  # noqa: E402
from runs import Runs  # noqa: E402

KNOWN = {"matched": 0.0, "status": "ambiguous", "translation_error": None, "rotation_error": None,
         "candidate_x": 1.0, "candidate_error": 0.1, "candidate_rotation_error": 0.01, "candidate_map_error": 0.1,
         "candidate_map_rotation_error": 0.01}


def row(session, age, **more):
    return {"session": float(session), "drive": float(session), "time": age, "session_age": age, **KNOWN, **more}


def announced_row(session, age, error, turn=0.0):
    return row(session, age, matched=1.0, status="matched", translation_error=error, rotation_error=turn,
               candidate_error=error, candidate_rotation_error=turn)


class FakeRun:
    """A run that was done, with these rows."""

    name = "drive"
    problem = ""

    def __init__(self, rows, arguments=()):
        self._rows = rows
        self.arguments = list(arguments)

    def rows(self):
        return self._rows

    def done(self):
        return True


class Starts(unittest.TestCase):

    def starts_of(self, rows, count, **more):
        return trials.Trial("experiment", "building", "", FakeRun(rows), count, **more).starts()

    def test_the_first_announced_place_decides(self):
        rows = [row(0, 0.0), announced_row(0, 2.0, 0.1), announced_row(0, 3.0, 9.0),
                row(1, 0.0), announced_row(1, 5.0, 9.0), announced_row(1, 6.0, 0.1),
                announced_row(2, 0.0, 0.1, turn=0.3)]
        starts = self.starts_of(rows, 3)
        self.assertEqual([start.outcome for start in starts], ["right", "wrong", "wrong"])
        self.assertEqual([start.age for start in starts], [2.0, 5.0, 0.0])

    def test_a_start_that_comes_too_late_is_silent_for_its_last_status_in_time(self):
        rows = [row(0, 0.0), row(0, 19.0, status="not_certified"), announced_row(0, 21.0, 0.1)]
        start, = self.starts_of(rows, 1)
        self.assertEqual((start.outcome, start.cause, start.age), ("silent", "not_certified", None))

    def test_a_start_without_any_map_is_not_forgotten(self):
        starts = self.starts_of([announced_row(1, 0.0, 0.1)], 3)
        self.assertEqual([(start.outcome, start.cause) for start in starts],
                         [("silent", "no_map"), ("right", ""), ("silent", "no_map")])
        self.assertEqual(trials.causes_text(starts), "no_map 2")

    def test_a_place_whose_truth_is_not_known_decides_nothing(self):
        rows = [announced_row(0, 0.0, None), announced_row(0, 1.0, 0.1)]
        start, = self.starts_of(rows, 1)
        self.assertEqual((start.outcome, start.age), ("right", 1.0))
        trial = trials.Trial("experiment", "building", "", FakeRun(rows))
        self.assertEqual(announced.count([trial], [])[0], ["experiment", 1, 2, 2, 0, 0])

    def test_a_drive_whose_mapper_begins_anew_is_one_start(self):
        rows = [row(0, 0.0), {**announced_row(0, 12.0, 0.1), "session": 1.0, "session_age": 2.0},
                {**announced_row(1, 21.0, 0.1), "session": 3.0, "session_age": 1.0}]
        starts = self.starts_of(rows, 2)
        self.assertEqual([(start.outcome, start.age) for start in starts], [("right", 12.0), ("silent", None)])

    def test_whatever_is_announced_in_a_strangers_map_is_wrong(self):
        start, = self.starts_of([announced_row(0, 0.0, None)], 1, in_reference=False)
        self.assertEqual(start.outcome, "wrong")

    def test_each_start_has_the_next_seed(self):
        trial = trials.Trial("experiment", "building", "", FakeRun([], ["--seed", "41"]), 4)
        self.assertEqual(trial.seed(3.0), 44)


class Plans(unittest.TestCase):

    def test_parameters_of_the_matcher_go_to_all_that_match(self):
        with tempfile.TemporaryDirectory() as directory:
            runs = Runs(Path(directory), Path("tools"), Path("matcher.yaml"))
            drive = runs.drive("drive", ["--seed", 1])
            drawn = runs.add("floor", "generate_building", [], [])
            self.assertEqual(drive.arguments[-2:], ["--config", "matcher.yaml"])
            self.assertEqual(drawn.arguments, [])
            self.assertIs(runs.drive("drive", []), drive)


class Shares(unittest.TestCase):

    def test_intervals_are_wilsons(self):
        low, high = trials.wilson(38, 40)
        self.assertAlmostEqual(low, 0.8350, 4)
        self.assertAlmostEqual(high, 0.9862, 4)
        self.assertEqual(trials.wilson(0, 0), (0.0, 1.0))
        self.assertAlmostEqual(trials.wilson(10, 10)[1], 1.0)
        self.assertEqual(trials.share_text(38, 40), "95 (83 to 99)")
        self.assertEqual(trials.share_text(0, 0), "-")


class CutMap(unittest.TestCase):

    DESCRIPTION = "resolution: 1.0\norigin: [%g, %g, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"

    def test_what_the_session_map_shows_and_its_surroundings_are_unknown(self):
        with tempfile.TemporaryDirectory() as name:
            directory = Path(name)
            (directory / "reference.pgm").write_bytes(b"P5 6 5 255\n" + bytes([254] * 29 + [0]))
            (directory / "reference.yaml").write_text("image: reference.pgm\n" + self.DESCRIPTION % (10, 20))
            # one known cell, at (0.5, 1.5) of its map, where the truth puts it to (14.5, 23.5) of the reference map
            (directory / "session.pgm").write_bytes(b"P5 2 2 255\n" + bytes([254, 205, 205, 205]))
            (directory / "session.yaml").write_text("image: session.pgm\n" + self.DESCRIPTION % (0, 0))
            truth = {"x": 16.0, "y": 23.0, "yaw": math.pi / 2}
            (directory / "truth.json").write_text(json.dumps(truth))
            subprocess.run([CHECKOUT / "scripts/evaluation/cut_map", directory / "reference.yaml",
                            directory / "session.yaml", directory / "truth.json", "1", directory / "cut.yaml"],
                           check=True)
            rows = (directory / "cut.pgm").read_bytes()[-30:]
        drawn = ["".join({254: ".", 0: "#", 147: "?"}[v] for v in rows[k:k + 6]) for k in range(0, 30, 6)]
        self.assertEqual(drawn, ["...???", "...???", "...???", "......", ".....#"])


class Judged(unittest.TestCase):

    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.path = Path(self.directory.name)

    def table(self, drives, pairs=()):
        candidates.write_candidates(self.path / "candidates.csv", drives, pairs)
        with open(self.path / "candidates.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def pair(self, result, truth):
        runs = Runs(self.path, self.path)
        run = runs.add("pair", "match_maps", [], [self.path / "pair_result.json"])
        (self.path / "pair_result.json").write_text(json.dumps(result), encoding="utf-8")
        (self.path / "pair.json").write_text(json.dumps({"arguments": []}), encoding="utf-8")
        return trials.Pair("pairs", "intel", ("intel", "00"), run, truth)

    def test_places_that_are_not_believed_are_right_or_wrong_as_well(self):
        drives = [trials.Trial("a", "b", "c", FakeRun([row(0, 0.0), row(0, 1.0, candidate_error=3.0),
                                                       row(0, 2.0, candidate_x=None, candidate_error=None)]))]
        self.assertEqual([line["candidate_right"] for line in self.table(drives)], ["1", "0", ""])

    def test_places_in_a_strangers_map_are_wrong(self):
        drives = [trials.Trial("a", "b", "c", FakeRun([row(0, 0.0, candidate_error=None)]), in_reference=False)]
        self.assertEqual(self.table(drives)[0]["candidate_right"], "0")

    def test_evidence_that_only_some_answers_have_is_a_column(self):
        old = FakeRun([row(0, 0.0, **{"evidence.hit_ratio": 0.5})])
        new = FakeRun([row(0, 0.0, **{"evidence.seen_through": 1.5})])
        lines = self.table([trials.Trial("a", "b", "c", old), trials.Trial("a", "b", "c", new)])
        self.assertEqual([line["evidence.hit_ratio"] for line in lines], ["0.5", ""])
        self.assertEqual([line["evidence.seen_through"] for line in lines], ["", "1.5"])

    def test_pairs_of_maps_are_in_the_table(self):
        result = {"status": "ambiguous", "transform": None, "candidate": {"x": 1.0, "y": 2.1, "yaw": 6.3},
                  "hit_ratio": 0.5, "certified": True, "evidence": [{"name": "margin", "value": 0.25}]}
        line, = self.table([], [self.pair(result, {"x": 1.0, "y": 2.0, "yaw": 0.0})])
        self.assertEqual((line["candidate_right"], line["evidence.margin"], line["answer.hit_ratio"],
                          line["answer.certified"], line["session"]), ("1", "0.25", "0.5", "1.0", "intel/00"))
        self.assertAlmostEqual(float(line["candidate_map_error"]), 0.1)

    def test_a_pair_is_wrong_where_it_is_announced_elsewhere(self):
        place = {"x": 1.0, "y": 2.0, "yaw": 0.0}
        result = {"status": "matched", "transform": place, "candidate": place, "evidence": []}
        self.assertEqual(self.pair(result, place).outcome(), "right")
        self.assertEqual(self.pair(result, {**place, "x": 2.0}).outcome(), "wrong")
        self.assertEqual(self.pair(result, {**place, "yaw": 3.0}).outcome(), "wrong")
        self.assertEqual(self.pair(result, None).outcome(), "wrong")
        self.assertEqual(self.pair({**result, "transform": None}, place).outcome(), "silent")

    def test_wrong_places_of_all_experiments_are_counted_together(self):
        right = trials.Trial("good", "b", "c", FakeRun([announced_row(0, 0.0, 0.1), row(0, 1.0)]))
        lost = {**announced_row(0, 2.0, 9.0), "candidate_map_error": 0.1}
        wrong = trials.Trial("bad", "b", "c", FakeRun([announced_row(0, 0.0, 0.1), lost]))
        stranger = trials.Trial("bad", "b", "c", FakeRun([announced_row(0, 0.0, None)]), in_reference=False)
        counts = announced.count([right, wrong, stranger], [])
        self.assertEqual(counts, [["good", 1, 2, 1, 0, 0], ["bad", 2, 3, 3, 2, 1], ["**all**", 3, 5, 4, 2, 1]])
        self.assertEqual(announced.num_wrong(counts), 2)


if __name__ == "__main__":
    unittest.main()
