"""Floors that generate_building draws."""

from trials import PATIENCE

FINE = 0.02  # [m] cells of the floors that are driven in
COARSE = 0.05  # [m] cells of the reference maps


def floor(runs, name, *options, resolution=FINE):
    """The map file of a floor of this name, which a run draws."""
    path = runs.path("building_%s.yaml" % name)
    runs.add("building_" + name, "generate_building", [
        "--resolution", resolution, *options, "--output", path], [path])
    return path


def floor_and_reference(runs, name, *options):
    """The map file to drive in, and that of the reference map: the same floor in coarser cells."""
    return floor(runs, name, *options), floor(runs, name + "_reference", *options, resolution=COARSE)


def starts(runs, name, world, reference, count, seed, *options):
    """The run of so many starts at random places."""
    config = runs.write_config("starts_mapper", delta=COARSE, map_update_interval=1.0)
    return runs.drive(name, ["--map", world, "--reference", reference, "--starts", count, "--seed", seed, "--duration",
                             PATIENCE, "--mapper-config", config, *options])
