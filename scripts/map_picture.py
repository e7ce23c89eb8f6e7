"""Map files as pictures, for the scripts that draw on them."""
import os


class BadMap(Exception):
    """A map file that cannot be drawn; the text tells why."""


def read_map(path):
    """The image of a map_server map, bright where it is free, and its extent [m]: x_min, x_max, y_min, y_max. Raises
    BadMap where there is no such map, or its origin is turned."""
    import matplotlib.image
    import yaml
    try:
        with open(path, encoding="utf-8") as file:
            about = yaml.safe_load(file)
        image = matplotlib.image.imread(os.path.join(os.path.dirname(path), about["image"]))
        x, y, yaw = about["origin"]
        cell = float(about["resolution"])
    except (OSError, ValueError, KeyError, TypeError, SyntaxError, yaml.YAMLError) as error:
        raise BadMap("map '%s' cannot be read: %s" % (path, error)) from error
    if abs(yaw) > 1e-6:
        raise BadMap("map '%s' has an origin turned by %g rad, expected 0" % (path, yaw))
    return image, (x, x + cell * image.shape[1], y, y + cell * image.shape[0])


def draw_map(axis, path):
    """Draws the walls of a map file, pale, behind what is drawn on the axis."""
    image, extent = read_map(path)
    axis.imshow(image, cmap="gray", extent=extent, alpha=0.6)
