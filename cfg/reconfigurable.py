"""Describes to dynamic_reconfigure what may change while a node runs, as the parameter files in config/ have it."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "scripts"))
from parameter_files import parameters_of

# What takes effect at once. All else goes into the reference map as it is prepared, into what the mapper has drawn
# already, or into names and frames: a node that is to have it otherwise is started anew.
RECONFIGURABLE = {
    "map_matcher": ["min_probability", "tentative_probability", "min_hit_ratio", "min_margin", "maps_per_proof",
                    "follow_alignment", "confirm_relocation", "nearby_distance", "min_nearby_ratio", "min_nearby_walls",
                    "withdraw_when_lost", "exact_deadline", "threads"],
    "lidar_scrubber": ["score_threshold", "max_detections", "removal_radius", "removed_range", "max_removed_fraction",
                       "cache_duration", "radius_growth", "max_removal_radius", "silence_warning", "silence_error",
                       "on_silence"],
}


def generate(node, name):
    """Generates the class <name>Config from config/<node>.yaml; an exit code."""
    from dynamic_reconfigure import parameter_generator_catkin as dynamic_reconfigure

    generator = dynamic_reconfigure.ParameterGenerator()
    described = {parameter.name: parameter for parameter in parameters_of(node)}
    for parameter in RECONFIGURABLE[node]:
        add(generator, dynamic_reconfigure, described[parameter])
    return generator.generate("map_matcher", node, name)


def add(generator, types, parameter):
    """Adds a parameter: a flag, one of some texts, or a number with its range."""
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    what = {"name": parameter.name, "level": 0, "description": parameter.description + unit}
    if parameter.value in ("true", "false"):
        generator.add(paramtype=types.bool_t, default=parameter.value == "true", **what)
    elif parameter.value.startswith('"'):
        choices = [generator.const(f"{parameter.name}_{choice}", types.str_t, choice, "")
                   for choice in parameter.range.split(" | ")]
        generator.add(paramtype=types.str_t, default=parameter.value.strip('"'),
                      edit_method=generator.enum(choices, ""), **what)
    else:
        number, number_type = (float, types.double_t) if "." in parameter.value else (int, types.int_t)
        smallest, largest = (number(bound) for bound in parameter.range.split(" to "))
        generator.add(paramtype=number_type, default=number(parameter.value), min=smallest, max=largest, **what)
