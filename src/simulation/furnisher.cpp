#include "map_matcher/simulation/furnisher.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace map_matcher::simulation {
namespace {

constexpr int kTrials = 60;      // places tried for a piece
constexpr double kTouch = 1e-6;  // [m] nearer is touching
constexpr double kMoved = 0.5;   // [m] less is not moved

}  // namespace

Furnisher::Furnisher(const Rectangle& floor, std::vector<Rectangle> kept_free, double passage, RandomNumbers& random)
    : kept_free_(std::move(kept_free)), passage_(passage), random_(&random) {
  space_.floor = floor;
}

bool Furnisher::placeAtWall(const Furniture& piece, const std::vector<Side>& sides) {
  return place({piece, sides, std::nullopt, std::nullopt});
}

bool Furnisher::placeAtAnyWall(const Furniture& piece) {
  return placeAtWall(piece, {Side::kBottom, Side::kRight, Side::kTop, Side::kLeft});
}

bool Furnisher::placeFree(const Furniture& piece) { return place({piece, {}, std::nullopt, std::nullopt}); }

bool Furnisher::place(const Placement& placement) {
  for (int i = 0; i < kTrials; ++i) {
    Furniture piece = placed(placement.piece, randomPose(placement));
    const bool is_elsewhere = !placement.from || (piece.footprint.centre() - *placement.from).norm() >= kMoved;
    if (is_elsewhere && fits(piece.footprint)) {
      space_.pieces.push_back(std::move(piece));
      placements_.push_back(placement);
      return true;
    }
  }
  return false;
}

grid::Rigid2 Furnisher::randomPose(const Placement& placement) {
  if (!placement.sides.empty()) {
    return randomPoseAtWall(placement.piece, placement.sides[random_->index(placement.sides.size())]);
  }
  const Rectangle& floor = space_.floor;
  const double yaw = random_->chance(0.5) ? 0.5 * M_PI : 0.0;
  const double x = random_->uniform(floor.x_min, floor.x_max);
  const double y = random_->uniform(floor.y_min, floor.y_max);
  return {x, y, yaw};
}

void Furnisher::remove(std::size_t index) {
  const auto k = static_cast<std::ptrdiff_t>(index);
  space_.pieces.erase(space_.pieces.begin() + k);
  placements_.erase(placements_.begin() + k);
}

void Furnisher::removeDoorLeaf(const Door& door) {
  for (std::size_t i = placements_.size(); i-- > 0;) {
    if (placements_[i].door && *placements_[i].door == door.centre) {
      remove(i);
    }
  }
}

void Furnisher::move(double share, RandomNumbers& random) {
  std::vector<Placement> moved;
  for (std::size_t i = placements_.size(); i-- > 0;) {
    if (!placements_[i].door && !placements_[i].piece.is_fixed && random.chance(share)) {
      moved.push_back(placements_[i]);
      moved.back().from = space_.pieces[i].footprint.centre();
      remove(i);
    }
  }
  RandomNumbers* const furnishing = std::exchange(random_, &random);
  for (const Placement& placement : moved) {
    place(placement);
  }
  random_ = furnishing;
}

bool Furnisher::placeDoorLeaf(const Door& door) {
  const int across = door.in_wall_along_x ? 1 : 0;
  const bool is_beyond = space_.floor.centre()[across] < door.centre[across];
  const double yaw = (door.in_wall_along_x ? 0.0 : -0.5 * M_PI) + (is_beyond ? M_PI : 0.0);
  const grid::Rigid2 T_plan_door{door.centre.x(), door.centre.y(), grid::normalizeAngle(yaw)};
  const double jamb = random_->chance(0.5) ? 0.5 : -0.5;
  Furniture leaf = placed(doorLeaf(door.width - 0.05, std::copysign(random_->uniform(0.05, 0.5), jamb)),
                          T_plan_door * grid::Rigid2{jamb * door.width, 0.0, 0.0});
  if (!isClear(leaf.footprint)) {
    return false;
  }
  placements_.push_back({leaf, {}, door.centre, std::nullopt});
  space_.pieces.push_back(std::move(leaf));
  return true;
}

grid::Rigid2 Furnisher::randomPoseAtWall(const Furniture& piece, Side side) {
  const Rectangle& floor = space_.floor;
  const bool along_x = side == Side::kBottom || side == Side::kTop;
  const double low = (along_x ? floor.x_min : floor.y_min) + 0.5 * piece.footprint.width();
  const double high = (along_x ? floor.x_max : floor.y_max) - 0.5 * piece.footprint.width();
  const double corner = random_->uniform();
  const double along = corner < 0.25 ? low : corner < 0.5 ? high : random_->uniform(low, std::max(low, high));
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
