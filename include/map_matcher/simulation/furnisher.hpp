/// \file
/// Finds places for furniture in one space of a floor.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "map_matcher/simulation/floor_plan.hpp"
#include "map_matcher/simulation/furnishing.hpp"
#include "map_matcher/simulation/furniture.hpp"
#include "map_matcher/simulation/random_numbers.hpp"

namespace map_matcher::simulation {

/// A wall of a space.
enum class Side { kBottom, kRight, kTop, kLeft };

/// Furnishes one space. Every place* function tries some random places, leaves the piece out when none is free, and
/// tells which. A place is free when the piece touches a wall or leaves a passage to it, leaves a passage to every
/// other piece, and stands on no floor that is kept free.
class Furnisher {
 public:
  /// `floor`: between the faces of the walls [m]. `kept_free`: in the frame of the plan. `passage` [m]. `random` must
  /// outlive the furnisher.
  Furnisher(const Rectangle& floor, std::vector<Rectangle> kept_free, double passage, RandomNumbers& random);

  bool placeAtWall(const Furniture& piece, const std::vector<Side>& sides);
  bool placeAtAnyWall(const Furniture& piece);
  bool placeFree(const Furniture& piece);

  /// Stands a door's leaf open on this side of it, when it is in nobody's way there.
  bool placeDoorLeaf(const Door& door);

  /// Takes the leaf of a door away, if there is one.
  void removeDoorLeaf(const Door& door);

  /// Moves this share of the pieces that are not fixed to random places of the space at least 0.5 m away, of the kind
  /// that they stood at; those that find none are taken away. Door leaves stay.
  void move(double share, RandomNumbers& random);

  RandomNumbers& random() { return *random_; }
  const Rectangle& floor() const { return space_.floor; }
  const FurnishedSpace& space() const { return space_; }

 private:
  /// How a piece of the space came to its place.
  struct Placement {
    Furniture piece;                      // before it was placed
    std::vector<Side> sides;              // walls that it may stand at; none: free in the room
    std::optional<Eigen::Vector2d> door;  // centre of the door that it is the leaf of [m]
    std::optional<Eigen::Vector2d> from;  // where it stood before it was moved [m]
  };

  bool place(const Placement& placement);
  grid::Rigid2 randomPose(const Placement& placement);
  grid::Rigid2 randomPoseAtWall(const Furniture& piece, Side side);
  void remove(std::size_t index);
  bool fits(const Rectangle& footprint) const;
  bool isClear(const Rectangle& footprint) const;

  FurnishedSpace space_;
  std::vector<Placement> placements_;  // of the pieces, in their order
  std::vector<Rectangle> kept_free_;
  double passage_;
  RandomNumbers* random_;
};

}  // namespace map_matcher::simulation
