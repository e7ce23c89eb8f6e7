"""Session maps in the maps of other buildings, where no place is right."""
import buildings
import sessions
from pages import arguments_of, section, table, write_pairs, write_starts
from starts import outcome_table
from trials import Pair, Trial

NAME = "strangers"
STARTS = 4  # in each generated office for each other one's map
MAPS = {  # recorded maps by the building that they are of
    "asl_office": "asl_office", "original_ckk": "original_ckk", "intel": "intel", "freiburg-101": "freiburg-101",
    "freiburg-campus": "freiburg-campus", "wean": "wean", "willow": "willow-full-0.05", "fetch": "4_26_15",
    "halmstad": "halmstad/HIH/HIH_01"}
QUICK_MAPS = ("freiburg-101", "wean")


def plan(runs, arguments):
    return plan_pairs(runs, arguments), plan_drives(runs, arguments)


def plan_pairs(runs, arguments):
    pairs = []
    for set_name, case, _, _ in sessions.cases(arguments):
        for building, name in MAPS.items():
            reference = arguments.data / "maps" / (name + ".yaml")
            own = building == sessions.building_of(set_name)
            if own or not reference.exists() or arguments.quick and building not in QUICK_MAPS:
                continue
            run = sessions.match(runs, "stranger_%s_%s_in_%s" % (set_name, case.name, building), reference,
                                 case / "session.yaml")
            pairs.append(Pair(NAME, building, (set_name, case.name), run, None))
    return pairs


def plan_drives(runs, arguments):
    seeds = (1, 2) if arguments.quick else (1, 2, 3, 4, 5)
    count = 2 if arguments.quick else STARTS
    trials = []
    for driven in seeds:
        world = buildings.floor(runs, "%d" % driven, "--seed", driven)
        for other in seeds:
            if other != driven:
                reference = buildings.floor(runs, "%d_reference" % other, "--seed", other, resolution=buildings.COARSE)
                run = buildings.starts(runs, "stranger_%d_in_%d" % (driven, other), world, reference, count,
                                       3000 + 100 * driven + 10 * other, "--stranger")
                trials.append(Trial(NAME, "generated_%d" % other, "drive in generated_%d" % driven, run, count,
                                    in_reference=False))
    return trials


def trials_of(planned):
    return planned[1]


def pairs_of(planned):
    return planned[0]


def report(planned, page):
    pairs, trials = planned
    write_starts(page / "strangers.csv", trials)
    write_pairs(page / "strangers_maps.csv", pairs)
    lines = []
    for building in dict.fromkeys(pair.building for pair in pairs):
        outcomes = [pair.outcome() for pair in pairs if pair.building == building]
        results = [pair.result() for pair in pairs if pair.building == building and pair.result()]
        hits = [result["candidate_ratio"] for result in results if result["candidate_ratio"] is not None]
        lines.append([building, len(results), outcomes.count("wrong"), outcomes.count("silent"),
                      max(hits, default=None)])
    return section(
        "Strangers",
        "Recorded session maps in the recorded maps of all buildings but their own, and starts in generated offices "
        "with the maps of others: whatever is announced is wrong. [strangers_maps.csv](strangers_maps.csv), "
        "[strangers.csv](strangers.csv)",
        table(["recorded map", "session maps", "wrong", "silent", "most hits of a place that was found"], lines)
        if lines else "Recorded maps are left out: they are not there.",
        outcome_table("map of", trials, lambda trial: trial.building),
        arguments_of([trial.run for trial in trials], unlisted=[pair.run for pair in pairs]))
