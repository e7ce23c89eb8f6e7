"""The office that is driven in: the recorded one where it is there, else the generated one."""


def recorded_map(arguments):
    """The file of the recorded office's map; None where it is not there."""
    path = arguments.data / "maps/asl_office.yaml"
    return path if path.exists() else None


def world(arguments):
    """The arguments that let a simulated drive take place there."""
    recorded = recorded_map(arguments)
    return ["--map", recorded] if recorded else []


def map_file(runs, arguments):
    """The file of its map, which a run makes where it is generated."""
    generated = runs.path("office.yaml")
    recorded = recorded_map(arguments)
    if not recorded:
        runs.add("office", "generate_building", ["--output", generated], [generated])
    return recorded or generated
