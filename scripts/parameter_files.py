"""What the parameter files in config/ say of the nodes' parameters; a test holds them to the program."""

from pathlib import Path

CHECKOUT = Path(__file__).resolve().parent.parent


class Parameter:
    """One parameter, as its file has it: `value`, the default, as YAML writes it, and `range` in words, as "0 to 1" or
    "inf | nan"."""

    def __init__(self, section, comment, name, value):
        self.section, self.name, self.value = section, name, value
        *description, allowed = comment
        self.description = " ".join(description)
        unit, separator, rest = allowed.partition("] ")
        has_unit = separator and unit.startswith("[")
        self.unit = unit[1:] if has_unit else ""
        self.range = rest if has_unit else allowed


def parameters_of(node):
    """The parameters of config/<node>.yaml, in its order; each has a comment above it, whose last line says what is
    allowed."""
    path = CHECKOUT / f"config/{node}.yaml"
    section, comment, parameters = "", [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("# ---"):
            section = line.strip("#- ")
        elif line.startswith("# "):
            comment.append(line[2:])
        elif ": " in line and not line.startswith(" "):
            name, value = line.split(": ", maxsplit=1)
            if len(comment) < 2:
                raise SystemExit(f"{path}: {name} has no comment of a description and what is allowed")
            parameters.append(Parameter(section, comment, name, value))
            comment = []
        elif not line:
            comment = []
    return parameters
