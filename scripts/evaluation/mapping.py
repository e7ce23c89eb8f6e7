"""Report figures 3 to 5: the same drive through a crowd mapped without and with scrubbing."""
import math
import shutil

from pages import COLUMNS, arguments_of, picture, section, table, write_table
from runs import Statistics
from trials import Trial

NAME = "mapping"
VARIANTS = ("original", "scrubbed")


def plan(runs, arguments):
    drives = {}
    config = runs.write_config("mapping_mapper", delta=0.05, map_update_interval=5.0)
    for density in (0.3,) if arguments.quick else (0.3, 1.0):
        for seed in (1,) if arguments.quick else (1, 2, 3, 4):
            for variant in VARIANTS:
                name = "mapping_%g_%d_%s" % (density, seed, variant)
                drives[density, seed, variant] = runs.drive(name, [
                    "--duration", 60 if arguments.quick else 180, "--seed", seed, "--density", density,
                    "--standing-share", 0.7, "--mapper-config", config, "--last-overlay", runs.path(name + ".png"),
                    *(["--scrub"] if variant == "scrubbed" else [])])
    return runs, drives


def trials_of(planned):
    return [Trial(NAME, "generated_1", "%g %s" % (density, variant), run)
            for (density, _, variant), run in planned[1].items()]


def distortion(rows):
    """Largest difference [rad] between the mapper's heading errors of two moments of the drive: the angle by which
    walls that are parallel in truth differ in the map."""
    errors = [row["heading_drift"] for row in rows]
    return max(errors) - min(errors) if errors else math.nan


def report(planned, page):
    runs, drives = planned
    write_table(page / "mapping.csv", list(drives.values()), [*COLUMNS, "heading_drift"])
    rows = []
    for density in sorted({key[0] for key in drives}):
        for variant in VARIANTS:
            chosen = [run.rows() for key, run in drives.items() if key[0] == density and key[2] == variant]
            known = [[row for row in rows if row["occupied"]] for rows in chosen]  # where the map lies is known
            last = [rows[-1] for rows in known if rows]
            false = Statistics([100.0 * row["falsely_occupied"] / row["occupied"] for row in last])
            bent = Statistics([distortion(rows) for rows in chosen if rows])
            cells = Statistics([row["falsely_occupied"] for row in last])
            rows.append([density, variant, len(last), cells.mean, false.mean, 1e3 * bent.mean, 1e3 * bent.largest])
    parts = []
    density, seed = sorted({key[:2] for key in drives})[0]
    for variant in VARIANTS:
        name = drives[density, seed, variant].name + ".png"
        if runs.path(name).exists():
            shutil.copy(runs.path(name), page)
            parts.append(picture(name, "The %s session map (figure 5): cells on walls red, all others blue." % variant))
    return section(
        "Mapping in a crowd",
        "Report figures 3 to 5: the same drives through a generated office, 70 % of the people standing in groups, "
        "mapped without and with scrubbing. False occupancy: cells that are occupied in the last session map that was "
        "matched, and more than 0.15 m from a wall in the truth. Rotational distortion: how much the heading error of the "
        "mapper varies over the drive, which is the angle between walls that are parallel in truth. "
        "[mapping.csv](mapping.csv)",
        table(["people/m^2", "scans", "drives", "falsely occupied [cells]", "[% of occupied]", "distortion mean [mrad]",
               "worst"], rows), *parts, arguments_of(list(drives.values())))
