#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/pose_messages.hpp"
#include "map_matcher/ros/matching/initial_pose_source.hpp"

namespace map_matcher::ros_matching {
namespace {

/// A map of 10 m x 5 m that is turned by a quarter: it covers x from -5 to 0 m and y from 0 to 10 m.
ReferenceMapList turnedMap() {
  grid::GridGeometry geometry;
  geometry.resolution = 0.5;
  geometry.width = 20;
  geometry.height = 10;
  geometry.T_map_grid = {0.0, 0.0, 1.5707963267948966};
  return {std::make_shared<const ReferenceMap>(
      grid::OccupancyGrid(geometry, std::vector<std::int8_t>(200, grid::kOccupied)), search::SearchOptions{}, "map")};
}

geometry_msgs::PoseWithCovarianceStamped poseAt(double x, double y) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = "/map";
  message.pose = ros_common::toMessage({x, y, 0.3}, Eigen::Vector3d(0.25, 0.25, 0.07).asDiagonal());
  return message;
}

TEST(InitialPose, InTheMapCanBeUsed) { EXPECT_EQ(problemWithInitialPose(poseAt(-4.0, 9.0), turnedMap()), ""); }

TEST(InitialPose, OutsideTheMapIsTold) {
  EXPECT_EQ(problemWithInitialPose(poseAt(4.0, 9.0), turnedMap()),
            "(4 m, 9 m) lies outside the reference map of frame \"map\"");
}

TEST(InitialPose, OfAnotherFrameIsTold) {
  geometry_msgs::PoseWithCovarianceStamped message = poseAt(-4.0, 9.0);
  message.header.frame_id = "odom";

  EXPECT_EQ(problemWithInitialPose(message, turnedMap()),
            "it is in the frame \"odom\", expected that of the reference map, \"map\" (rviz: Fixed Frame)");
}

TEST(InitialPose, ThatIsNoPoseIsTold) {
  geometry_msgs::PoseWithCovarianceStamped nowhere = poseAt(std::numeric_limits<double>::quiet_NaN(), 9.0);
  geometry_msgs::PoseWithCovarianceStamped tilted = poseAt(-4.0, 9.0);
  tilted.pose.pose.orientation.w = 0.0;

  EXPECT_NE(problemWithInitialPose(nowhere, turnedMap()).find("expected finite numbers"), std::string::npos);
  EXPECT_NE(problemWithInitialPose(tilted, turnedMap()).find("expected norm 1"), std::string::npos);
}

TEST(InitialPose, WithoutACovarianceIsTold) {
  geometry_msgs::PoseWithCovarianceStamped message = poseAt(-4.0, 9.0);
  message.pose.covariance[35] = 0.0;

  EXPECT_EQ(problemWithInitialPose(message, turnedMap()), "the variance of yaw is 0, expected above 0");
}

}  // namespace
}  // namespace map_matcher::ros_matching
