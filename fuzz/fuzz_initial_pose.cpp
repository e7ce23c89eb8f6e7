// A geometry_msgs/PoseWithCovarianceStamped as `initialpose`, with the robot's pose by tf: told what is wrong with it,
// or made a place that the session is supposed to lie at.
#include <cstddef>
#include <cstdint>
#include <memory>

#include "map_matcher/belief/prior.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/pose_messages.hpp"
#include "map_matcher/ros/matching/initial_pose_source.hpp"
#include "messages.hpp"

namespace map_matcher {
namespace {

ros_matching::ReferenceMapList smallMap() {
  grid::OccupancyGrid grid({0.1, 100, 50, {-3.0, 2.0, 0.7}});
  grid.at(3, 4) = grid::kOccupied;
  return {std::make_shared<const ros_matching::ReferenceMap>(grid, search::SearchOptions(), "map")};
}

geometry_msgs::PoseWithCovarianceStamped takeMessage(fuzz::Bytes& bytes) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header = fuzz::takeHeader(bytes);
  message.pose.pose = fuzz::takePose(bytes);
  const bool fits = bytes.choose(3) != 0;
  for (std::size_t k = 0; k < message.pose.covariance.size(); ++k) {
    message.pose.covariance[k] = fits ? (k % 7 == 0 ? 0.01 * bytes.choose(255) : 0.0) : bytes.take<double>();
  }
  return message;
}

}  // namespace
}  // namespace map_matcher

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace map_matcher;
  static const ros_matching::ReferenceMapList references = smallMap();
  fuzz::Bytes bytes(data, size);
  tf2::BufferCore tf;
  fuzz::takeTf(bytes, tf);
  const geometry_msgs::PoseWithCovarianceStamped message = takeMessage(bytes);
  const ros_matching::RobotPoseSource robot(tf, "base_link");
  const ros_matching::RobotPose pose = robot.atOrShortlyBefore(fuzz::takeFrame(bytes), message.header.stamp);
  if (!problemWithInitialPose(message, references).empty() || !pose.T_session_base) {
    return 0;
  }
  const grid::Rigid2 T_reference_base = ros_common::fromMessage(message.pose.pose, "the pose");
  const belief::Prior prior = belief::priorOfRobot(T_reference_base, ros_common::planarCovariance(message.pose),
                                                   *pose.T_session_base, "initialpose");
  belief::priorEvidence(prior, {{fuzz::takeCoordinate(bytes), fuzz::takeCoordinate(bytes), 0.3}, 0});
  return 0;
}
