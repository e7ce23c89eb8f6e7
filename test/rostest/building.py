"""A small building drawn as occupancy grids: a reference map, and session maps that lie in it as told."""
import math

from geometry_msgs.msg import Pose
from nav_msgs.msg import OccupancyGrid

RESOLUTION = 0.1  # [m]
SIZE = (240, 160)  # columns and rows of the reference map
OCCUPIED, FREE, UNKNOWN = 100, 0, -1

# Walls as boxes of the reference frame [m]: x and y of the lower left corner, width, height. No symmetry.
WALLS = [
    (1.0, 1.0, 22.0, 0.2), (1.0, 14.0, 22.0, 0.2), (1.0, 1.0, 0.2, 13.2), (22.8, 1.0, 0.2, 13.2),
    (1.0, 6.0, 5.0, 0.2), (7.2, 6.0, 7.0, 0.2), (15.5, 6.0, 7.4, 0.2), (1.0, 8.2, 9.0, 0.2), (11.3, 8.2, 8.0, 0.2),
    (6.0, 1.0, 0.2, 3.5), (11.0, 1.0, 0.2, 5.0), (17.5, 2.2, 0.2, 4.0), (8.0, 8.2, 0.2, 4.5), (14.5, 9.6, 0.2, 4.4),
    (19.0, 8.2, 0.2, 2.5), (3.0, 2.5, 0.8, 0.8), (12.5, 3.5, 1.6, 0.4), (20.0, 11.5, 0.5, 1.5), (4.0, 10.5, 0.4, 2.0),
]


def is_wall(x, y):
    """Whether a point of the reference frame [m] lies in a wall."""
    return any(left <= x < left + width and low <= y < low + height for left, low, width, height in WALLS)


def transformed(transform, x, y):
    """T * p for T = (x, y, yaw)."""
    cos, sin = math.cos(transform[2]), math.sin(transform[2])
    return transform[0] + cos * x - sin * y, transform[1] + sin * x + cos * y


def pose(x, y, yaw=0.0):
    message = Pose()
    message.position.x, message.position.y = x, y
    message.orientation.z, message.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return message


def grid(frame, origin, size, value_at, resolution=RESOLUTION):
    """A map of `size` cells with its corner at `origin`; value_at(x, y) is asked for every cell centre [m]."""
    message = OccupancyGrid()
    message.header.frame_id = frame
    message.info.resolution = resolution
    message.info.width, message.info.height = size
    message.info.origin = pose(*origin)
    message.data = [value_at(origin[0] + (column + 0.5) * resolution, origin[1] + (row + 0.5) * resolution)
                    for row in range(size[1]) for column in range(size[0])]
    return message


def is_wall_mirrored(x, y):
    """The same of another building: this one in a mirror, which no turn makes of it."""
    return is_wall(SIZE[0] * RESOLUTION - x, y)


def reference_map(frame="map", shift=(0.0, 0.0), wall=is_wall):
    """The building; `shift` [m] moves it in its frame."""
    return grid(frame, shift, SIZE, lambda x, y: OCCUPIED if wall(x - shift[0], y - shift[1]) else FREE)


def session_map(T_reference_session, frame="session_map", origin=(-9.6, -9.6), size=(192, 192), seen=8.0, wall=is_wall):
    """What a robot has drawn that started at T_reference_session = (x, y, yaw) and saw `seen` metres around itself."""
    def value_at(x, y):
        if math.hypot(x, y) > seen:
            return UNKNOWN
        return OCCUPIED if wall(*transformed(T_reference_session, x, y)) else FREE
    return grid(frame, origin, size, value_at)
