/// \file
/// What stands in an office, as a lidar near the floor sees it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/rectangle.hpp"

namespace map_matcher::simulation {

/// A box or a round post that no ray passes.
struct Solid {
  grid::Rigid2 pose;          ///< Of its centre.
  Eigen::Vector2d half_size;  ///< Half its extents along its own axes [m]; of a round one both are the radius.
  bool is_round = false;
};

/// Some solids that stand together. Against a wall, y points from the wall (y = 0) into the room and x = 0 is the
/// middle; a piece that stands free has its centre at the origin.
struct Furniture {
  std::vector<Solid> solids;
  Rectangle footprint;    ///< Holds all solids, and where people sit [m].
  bool is_fixed = false;  ///< Whether nobody can move it.
};

/// The piece at a pose whose yaw is a multiple of a right angle.
Furniture placed(const Furniture& piece, const grid::Rigid2& T_plan_piece);

// Against a wall. Sizes vary from piece to piece.
Furniture wallBlock(double width, double depth);    ///< A cupboard, shelf, shaft, pilaster: a box [m].
Furniture deskAtWall(RandomNumbers& random);        ///< Its long side to the wall, a chair before it.
Furniture deskPairFromWall(RandomNumbers& random);  ///< Two desks face to face, their ends to the wall.
Furniture kitchenette(RandomNumbers& random);       ///< A counter and a refrigerator.
Furniture sofa(RandomNumbers& random);              ///< With a low table before it, sometimes.
Furniture plantAtWall(RandomNumbers& random);       ///< A round pot.
/// A door leaf of this length [m], hinged at the origin and open at a right angle and `lean` [rad] more, towards +x.
Furniture doorLeaf(double length, double lean);

// Free in the room.
Furniture meetingTable(int chairs_per_side, RandomNumbers& random);  ///< With chairs all around.
Furniture deskCluster(int desks_per_side, RandomNumbers& random);    ///< Two rows face to face, with chairs.
Furniture roundTable(RandomNumbers& random);                         ///< With some stools.
Furniture workbench(RandomNumbers& random);                          ///< A long box.
Furniture pillar(RandomNumbers& random);                             ///< Square or round.

}  // namespace map_matcher::simulation
