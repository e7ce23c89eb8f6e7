#include "map_matcher/belief/free_space.hpp"

namespace map_matcher::belief {
namespace {

/// How the walls of one map lie in another one [m].
struct Walls {
  double near = 0.0;
  double open = 0.0;
};

Walls wallsIn(const grid::SeenSpace& map, const grid::SeenSpace& other, const grid::Rigid2& T_other_map) {
  Walls walls;
  const Eigen::Matrix2d R = T_other_map.rotation();
  for (const Eigen::Vector2d& p : map.walls()) {
    switch (other.at(R * p + T_other_map.translation())) {
      case grid::Seen::kNearWall:
        walls.near += map.resolution();
        break;
      case grid::Seen::kOpen:
        walls.open += map.resolution();
        break;
      case grid::Seen::kUnseen:
        break;
    }
  }
  return walls;
}

}  // namespace

FreeSpace freeSpace(const grid::SeenSpace& reference, const grid::SeenSpace& session,
                    const grid::Rigid2& T_reference_session) {
  const Walls of_session = wallsIn(session, reference, T_reference_session);
  const Walls of_reference = wallsIn(reference, session, T_reference_session.inverse());
  return {of_session.near, of_session.open, of_reference.near, of_reference.open};
}

}  // namespace map_matcher::belief
