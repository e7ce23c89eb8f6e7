#include "map_matcher/simulation/furnisher.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace map_matcher::simulation {
namespace {

constexpr int kTrials = 60;      // places tried for a piece
constexpr double kTouch = 1e-6;  // [m] nearer is touching

}  // namespace

Furnisher::Furnisher(const Rectangle& floor, std::vector<Rectangle> kept_free, double passage, RandomNumbers& random)
    : kept_free_(std::move(kept_free)), passage_(passage), random_(random) {
  space_.floor = floor;
}

bool Furnisher::placeAtWall(const Furniture& piece, const std::vector<Side>& sides) {
  for (int i = 0; i < kTrials; ++i) {
    if (add(placed(piece, randomPoseAtWall(piece, sides[random_.index(sides.size())])))) {
      return true;
    }
  }
  return false;
}

bool Furnisher::placeAtAnyWall(const Furniture& piece) {
  return placeAtWall(piece, {Side::kBottom, Side::kRight, Side::kTop, Side::kLeft});
}

bool Furnisher::placeFree(const Furniture& piece) {
  const Rectangle& floor = space_.floor;
  for (int i = 0; i < kTrials; ++i) {
    const double yaw = random_.chance(0.5) ? 0.5 * M_PI : 0.0;
    const double x = random_.uniform(floor.x_min, floor.x_max);
    const double y = random_.uniform(floor.y_min, floor.y_max);
    if (add(placed(piece, {x, y, yaw}))) {
      return true;
    }
  }
  return false;
}

bool Furnisher::placeDoorLeaf(const Door& door) {
  const int across = door.in_wall_along_x ? 1 : 0;
  const bool is_beyond = space_.floor.centre()[across] < door.centre[across];
  const double yaw = (door.in_wall_along_x ? 0.0 : -0.5 * M_PI) + (is_beyond ? M_PI : 0.0);
  const grid::Rigid2 T_plan_door{door.centre.x(), door.centre.y(), grid::normalizeAngle(yaw)};
  const double jamb = random_.chance(0.5) ? 0.5 : -0.5;
  Furniture leaf = placed(doorLeaf(door.width - 0.05, std::copysign(random_.uniform(0.05, 0.5), jamb)),
                          T_plan_door * grid::Rigid2{jamb * door.width, 0.0, 0.0});
  if (!isClear(leaf.footprint)) {
    return false;
  }
  space_.pieces.push_back(std::move(leaf));
  return true;
}

grid::Rigid2 Furnisher::randomPoseAtWall(const Furniture& piece, Side side) {
  const Rectangle& floor = space_.floor;
  const bool along_x = side == Side::kBottom || side == Side::kTop;
  const double low = (along_x ? floor.x_min : floor.y_min) + 0.5 * piece.footprint.width();
  const double high = (along_x ? floor.x_max : floor.y_max) - 0.5 * piece.footprint.width();
  const double corner = random_.uniform();
  const double along = corner < 0.25 ? low : corner < 0.5 ? high : random_.uniform(low, std::max(low, high));
  switch (side) {
    case Side::kBottom:
      return {along, floor.y_min, 0.0};
    case Side::kRight:
      return {floor.x_max, along, 0.5 * M_PI};
    case Side::kTop:
      return {along, floor.y_max, M_PI};
    case Side::kLeft:
      return {floor.x_min, along, -0.5 * M_PI};
  }
  return {};
}

bool Furnisher::add(Furniture piece) {
  if (!fits(piece.footprint)) {
    return false;
  }
  space_.pieces.push_back(std::move(piece));
  return true;
}

bool Furnisher::fits(const Rectangle& footprint) const {
  const Rectangle& floor = space_.floor;
  for (const double gap : {footprint.x_min - floor.x_min, footprint.y_min - floor.y_min, floor.x_max - footprint.x_max,
                           floor.y_max - footprint.y_max}) {
    if (gap < -kTouch || (gap > kTouch && gap < passage_)) {
      return false;
    }
  }
  return isClear(footprint);
}

/// Whether a footprint leaves the floor that is kept free and a passage to every piece.
bool Furnisher::isClear(const Rectangle& footprint) const {
  return std::all_of(kept_free_.begin(), kept_free_.end(),
                     [&](const Rectangle& kept) { return separation(footprint, kept) >= -kTouch; }) &&
         std::all_of(space_.pieces.begin(), space_.pieces.end(),
                     [&](const Furniture& piece) { return separation(footprint, piece.footprint) >= passage_; });
}

}  // namespace map_matcher::simulation
