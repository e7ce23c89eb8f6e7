#include "placing.hpp"

#include "map_matcher/search/refinement/pose_refiner.hpp"

namespace map_matcher::search {

/// The maps' walls as they are tell where the session lies best, not the wider hits.
Place Placing::placeOf(const SearchPose& pose) const {
  Place place;
  place.searched = mapPose(pose);
  const RefinedPose refined = refine(reference_.walls(), cells_, centrePose(pose), hit_tolerance_);
  place.T_reference_session = frames_.mapPose(refined.pose, cells_.centre);
  place.covariance = frames_.mapCovariance(refined.covariance, refined.pose.angle, cells_.centre);
  place.matched_cells = matchesAt(refined.pose);
  place.hit_cells = pose.count;
  place.hit_ratio = ratio(pose.count);
  place.worth = place.hit_ratio;
  return place;
}

CentrePose Placing::centrePose(const SearchPose& pose) const {
  const Eigen::Vector2d cells(pose.translation.x, pose.translation.y);
  return {rotations_.angle(pose.rotation), cells * cells_.resolution};
}

int Placing::matchesAt(const CentrePose& pose) const {
  const PooledLevel& walls = reference_.fine().level(0);
  const grid::Rigid2 T{pose.position.x() / cells_.resolution, pose.position.y() / cells_.resolution, pose.angle};
  const Eigen::Matrix2d R = T.rotation();
  int matches = 0;
  for (const Eigen::Vector2d& p : cells_.points) {
    const Eigen::Vector2d cell = (R * p + T.translation()).array().floor();
    matches += walls.at(static_cast<int>(cell.x()), static_cast<int>(cell.y()));
  }
  return matches;
}

}  // namespace map_matcher::search
