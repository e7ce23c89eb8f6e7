"""Maps as map_server's two files."""
import os

from building import OCCUPIED

YAML = "image: %s\nresolution: %g\norigin: [%g, %g, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"


def write_map(message, directory, name):
    """Writes the map, of free and occupied cells, and returns the path of its YAML file."""
    width, height = message.info.width, message.info.height
    rows = [message.data[row * width:(row + 1) * width] for row in reversed(range(height))]
    with open(os.path.join(directory, name + ".pgm"), "wb") as file:
        file.write(b"P5\n%d %d\n255\n" % (width, height))
        file.write(bytes(0 if value == OCCUPIED else 254 for row in rows for value in row))
    path = os.path.join(directory, name + ".yaml")
    origin = message.info.origin.position
    with open(path, "w", encoding="utf-8") as file:
        file.write(YAML % (name + ".pgm", message.info.resolution, origin.x, origin.y))
    return path
