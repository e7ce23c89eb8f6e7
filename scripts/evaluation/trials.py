"""What became of the starts of drives, and of pairs of maps: one rule for all experiments."""
import json
import math

RIGHT = 0.5  # [m] that a right place may be off
TURN = 0.2  # [rad] the same of its heading
PATIENCE = 20.0  # [s] in which the robot is to find itself
OUTCOMES = ("right", "wrong", "silent")
NO_MAP = "no_map"  # cause of a start without any session map
TOLD = ("candidate_", "answer.", "evidence.", "travelled", "occupied")  # columns of the table of candidates begin so


class Start:
    """What became of one start: the first place decides that was announced where the truth is known; without one the
    last status is the cause."""

    def __init__(self, number, rows, in_reference, clock):
        self.number = number
        early = [row for row in rows if row[clock] <= PATIENCE]
        first = next((row for row in early if row["matched"] == 1 and
                      not (in_reference and row["translation_error"] is None)), None)
        self.row = first or (early[-1] if early else None)
        self.age = first[clock] if first else None
        self.outcome = "silent" if first is None else "right" if in_reference and announced_right(first) else "wrong"
        self.cause = "" if first else self.row["status"] if self.row else NO_MAP


class Trial:
    """A run of evaluate_drive. With --starts each drive is a start, however often its mapper begins anew, else each
    session."""

    def __init__(self, experiment, building, condition, run, starts=None, in_reference=True):
        self.experiment = experiment
        self.building = building
        self.condition = condition  # whatever else there is to tell, in a word or two
        self.run = run
        self.in_reference = in_reference  # whether the robot drives anywhere that the reference map shows
        self._starts = starts  # how many drives there should be; None: the sessions that left a map

    def seed(self, number):
        """Of a start."""
        arguments = self.run.arguments
        first = int(arguments[arguments.index("--seed") + 1]) if "--seed" in arguments else 1
        return first + int(number) if self._starts else first

    def starts(self):
        """Every start, those that no map came of as well; none of a run that was not done."""
        rows_of = {float(number): [] for number in range(self._starts or 0)} if self.run.done() else {}
        for row in self.run.rows():
            rows_of.setdefault(row[self._counter()], []).append(row)
        clock = "time" if self._starts else "session_age"
        return [Start(number, rows, self.in_reference, clock) for number, rows in sorted(rows_of.items())]

    def _counter(self):
        """The column that counts starts."""
        return "drive" if self._starts else "session"

    def judged(self):
        """Each session map: a row of the table of candidates."""
        for row in self.run.rows():
            right = candidate_right(row) if self.in_reference or row.get("candidate_x") is None else False
            yield {"experiment": self.experiment, "building": self.building, "condition": self.condition,
                   "run": self.run.name, "seed": self.seed(row[self._counter()]), "session": row["session"],
                   "age": row["session_age"], "status": row["status"], "announced": row["matched"],
                   "candidate_right": None if right is None else int(right),
                   **{name: value for name, value in row.items() if name.startswith(TOLD)}}


class Pair:
    """A run of match_maps with a session map and a reference map that it lies in, or does not."""

    def __init__(self, experiment, building, session, run, truth):
        self.experiment = experiment
        self.building = building  # of the reference map
        self.session = session
        self.run = run
        self.truth = truth  # T_reference_session as {x, y, yaw}; None: the session map is from elsewhere

    def result(self):
        """What match_maps said; None of a run that was not done."""
        if self.run.problem or not self.run.done():
            return None
        return json.loads(self.run.outputs[0].read_text(encoding="utf-8"))

    def errors(self, pose):
        """Distance [m] and angle [rad] between the origin of the session map there and where it is in truth."""
        if pose is None or self.truth is None:
            return None, None
        turn = (pose["yaw"] - self.truth["yaw"] + math.pi) % (2.0 * math.pi) - math.pi
        return math.hypot(pose["x"] - self.truth["x"], pose["y"] - self.truth["y"]), abs(turn)

    def is_right(self, pose):
        """Whether this place is right; None where there is none."""
        if pose is None:
            return None
        distance, turn = self.errors(pose)
        return distance is not None and distance < RIGHT and turn < TURN

    def outcome(self):
        result = self.result()
        if result is None:
            return None
        if result["transform"] is None:
            return "silent"
        return "right" if self.is_right(result["transform"]) else "wrong"

    def judged(self):
        """The row of the table of candidates, as of a trial."""
        result = self.result()
        if result is None:
            return
        right = self.is_right(result["candidate"])
        error, turn = self.errors(result["candidate"])
        answer = {"answer." + name: float(value) for name, value in result.items()
                  if isinstance(value, (bool, int, float))}
        evidence = {"evidence." + piece["name"]: piece["value"] for piece in result["evidence"]}
        yield {"experiment": self.experiment, "building": self.building, "condition": "", "run": self.run.name,
               "seed": None, "session": "/".join(self.session), "age": None, "status": result["status"],
               "announced": float(result["transform"] is not None),
               "candidate_right": None if right is None else int(right), "candidate_map_error": error,
               "candidate_map_rotation_error": turn, **answer, **evidence}


def announced_right(row):
    """Whether the place that a row announces is the robot's."""
    return row["translation_error"] is not None and row["translation_error"] < RIGHT and row["rotation_error"] < TURN


def candidate_right(row, error="candidate_error", rotation="candidate_rotation_error"):
    """Whether the best place that a row found is the robot's, announced or not; None where there is none or the truth
    is not known."""
    return None if row.get(error) is None else row[error] < RIGHT and row[rotation] < TURN


def wilson(successes, count):
    """The 95 % interval of a share (Wilson: "Probable inference, the law of succession, and statistical inference",
    1927); from 0 to 1 of nothing."""
    if count == 0:
        return 0.0, 1.0
    z = 1.959964
    share = successes / count
    middle = share + z * z / (2 * count)
    spread = z * math.sqrt(share * (1 - share) / count + z * z / (4 * count * count))
    scale = 1 + z * z / count
    return max(0.0, (middle - spread) / scale), min(1.0, (middle + spread) / scale)


def share_text(successes, count):
    """A share in percent with its interval: "95 (83 to 99)"."""
    if count == 0:
        return "-"
    low, high = wilson(successes, count)
    return "%.0f (%.0f to %.0f)" % (100.0 * successes / count, 100.0 * low, 100.0 * high)


def causes_text(starts):
    """Why starts are silent: "ambiguous 3, not_certified 1"."""
    causes = [start.cause for start in starts if start.outcome == "silent"]
    return ", ".join("%s %d" % (cause, causes.count(cause)) for cause in sorted(set(causes))) or "-"

