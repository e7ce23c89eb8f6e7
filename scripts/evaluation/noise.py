"""Maps of lidars with more and less noise."""
import matplotlib.pyplot as plt
import static
from pages import COLUMNS, arguments_of, picture, save, section, table, write_table
from trials import Trial, announced_right, candidate_right, share_text

NAME = "noise"
SIGMAS = (0.01, 0.02, 0.03, 0.05, 0.07, 0.1)  # [m]
DURATION = 240  # [s]


def plan(runs, arguments):
    """A drive for each resolution and sigma, in the reference maps of the static building."""
    drives = {}
    for centimetres in (5,) if arguments.quick else (5, 2):
        reference, config = static.reference_of(runs, arguments, centimetres)
        for sigma in (0.01, 0.1) if arguments.quick else SIGMAS:
            drives[centimetres, sigma] = runs.drive("noise_%dcm_sigma%g" % (centimetres, sigma), [
                "--reference", reference, "--itinerary", "explore", "--duration", 40 if arguments.quick else DURATION,
                "--seed", 1, "--sigma", sigma, "--mapper-config", config], phase=2)
    return drives


def trials_of(drives):
    return [Trial(NAME, "generated_1", "%d cm, sigma %g" % key, run) for key, run in drives.items()]


def figures_of(run):
    """Maps, right, wrong, silent, best places that are right, least and mean hits at those."""
    rows = run.rows()
    announced = [row for row in rows if row["matched"] == 1]
    right = sum(announced_right(row) for row in announced)
    candidates = [row for row in rows if candidate_right(row)]
    hits = [row["hit_ratio"] for row in candidates if row["hit_ratio"] is not None]
    return [len(rows), right, len(announced) - right, len(rows) - len(announced), share_text(right, len(rows)),
            len(candidates), min(hits, default=None), sum(hits) / len(hits) if hits else None]


def report(drives, page):
    write_table(page / "noise.csv", list(drives.values()), COLUMNS)
    plot(drives, page / "noise.png")
    return section(
        "Noise",
        "A robot explores the generated office for %d s; the standard deviation of its lidar goes up, the reference "
        "map is that of the static building. One query a session map. [noise.csv](noise.csv)" % DURATION,
        table(["cells [cm]", "sigma [m]", "session maps", "right", "wrong", "silent", "right [%]", "best place right",
               "its least hit ratio", "mean"], [[*("%g" % value for value in key), *figures_of(run)]
                                                for key, run in drives.items()]),
        picture("noise.png", "Share of the session maps that were announced right."),
        arguments_of(list(drives.values())))


def plot(drives, path):
    figure, axis = plt.subplots(figsize=(7, 4))
    for centimetres in sorted({key[0] for key in drives}):
        shares = [(sigma, figures_of(run)) for (cells, sigma), run in drives.items() if cells == centimetres]
        axis.plot([sigma for sigma, _ in shares], [f[1] / max(1, f[0]) for _, f in shares], "o-",
                  label="%d cm" % centimetres)
    axis.set_xlabel("sigma [m]")
    axis.set_ylabel("share announced right")
    axis.set_ylim(0, 1.05)
    axis.legend()
    save(figure, path)
