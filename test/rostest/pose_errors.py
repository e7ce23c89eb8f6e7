"""How far the robot's pose on tf is from the truth."""
import math


def position_errors(buffer, true_poses):
    """Distances [m] of base_link in map from the true poses (PoseStamped) that tf knows one for."""
    errors = []
    for truth in true_poses:
        if buffer.can_transform("map", "base_link", truth.header.stamp):
            translation = buffer.lookup_transform("map", "base_link", truth.header.stamp).transform.translation
            errors.append(math.hypot(translation.x - truth.pose.position.x, translation.y - truth.pose.position.y))
    return errors
