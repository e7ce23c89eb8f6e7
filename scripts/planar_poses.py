"""Poses in the plane, for the scripts that compare them."""
import math


def planar(pose):
    """x, y and yaw of a geometry_msgs/Pose."""
    q = pose.orientation
    return pose.position.x, pose.position.y, math.atan2(2.0 * (q.w * q.z + q.x * q.y),
                                                        1.0 - 2.0 * (q.y * q.y + q.z * q.z))


def errors(estimate, truth):
    """How far two poses x, y, yaw are apart: in metres, and in rad."""
    return (math.hypot(estimate[0] - truth[0], estimate[1] - truth[1]),
            abs(math.remainder(estimate[2] - truth[2], 2.0 * math.pi)))


def between(earlier, later, share):
    """The pose at a share of the way from one pose to another."""
    turn = math.remainder(later[2] - earlier[2], 2.0 * math.pi)
    return (earlier[0] + share * (later[0] - earlier[0]), earlier[1] + share * (later[1] - earlier[1]),
            earlier[2] + share * turn)
