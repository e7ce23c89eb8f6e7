#include "map_matcher/belief/prior.hpp"

#include "map_matcher/grid/pose_covariance.hpp"

namespace map_matcher::belief {

Prior priorOfRobot(const grid::Rigid2& T_reference_base, const Eigen::Matrix3d& covariance,
                   const grid::Rigid2& T_session_base, const std::string& source) {
  const grid::Rigid2 T_base_session = T_session_base.inverse();
  return {T_reference_base * T_base_session, grid::covarianceOfProduct(T_reference_base, covariance, T_base_session),
          source};
}

}  // namespace map_matcher::belief
