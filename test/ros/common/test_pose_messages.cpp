#include <gtest/gtest.h>

#include "map_matcher/ros/common/pose_messages.hpp"

namespace map_matcher::ros_common {
namespace {

TEST(PoseMessages, HoldTheCovarianceOfTheirPlaneAndNothingElse) {
  Eigen::Matrix3d covariance;
  covariance << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;

  const geometry_msgs::PoseWithCovariance message = toMessage({1.0, 2.0, 0.0}, covariance);

  EXPECT_EQ(message.pose.position.x, 1.0);
  EXPECT_EQ(message.covariance[0], 1.0);
  EXPECT_EQ(message.covariance[1], 2.0);
  EXPECT_EQ(message.covariance[5], 3.0);
  EXPECT_EQ(message.covariance[11], 6.0);
  EXPECT_EQ(message.covariance[30], 7.0);
  EXPECT_EQ(message.covariance[35], 9.0);
  EXPECT_EQ(message.covariance[14], 0.0);
  EXPECT_EQ(planarCovariance(message), covariance);
}

}  // namespace
}  // namespace map_matcher::ros_common
