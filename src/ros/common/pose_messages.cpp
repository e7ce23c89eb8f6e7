#include "map_matcher/ros/common/pose_messages.hpp"

#include <array>

#include "map_matcher/ros/common/conversions.hpp"

namespace map_matcher::ros_common {
namespace {

using RowMajor = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
constexpr std::array<int, 3> kPlanar{0, 1, 5};  // x, y and yaw of x, y, z, roll, pitch and yaw

}  // namespace

geometry_msgs::PoseWithCovariance toMessage(const grid::Rigid2& pose, const Eigen::Matrix3d& covariance) {
  geometry_msgs::PoseWithCovariance message;
  message.pose = toPoseMessage(pose);
  Eigen::Map<RowMajor> all(message.covariance.data());
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      all(kPlanar.at(static_cast<std::size_t>(row)), kPlanar.at(static_cast<std::size_t>(column))) =
          covariance(row, column);
    }
  }
  return message;
}

Eigen::Matrix3d planarCovariance(const geometry_msgs::PoseWithCovariance& message) {
  const Eigen::Map<const RowMajor> all(message.covariance.data());
  Eigen::Matrix3d covariance;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      covariance(row, column) =
          all(kPlanar.at(static_cast<std::size_t>(row)), kPlanar.at(static_cast<std::size_t>(column)));
    }
  }
  return covariance;
}

}  // namespace map_matcher::ros_common
