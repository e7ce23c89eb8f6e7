#include "map_matcher/ros/trials/bag_truth.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <rosbag/view.h>

#include <iterator>

#include "map_matcher/ros/common/conversions.hpp"

namespace map_matcher::ros_trials {
namespace {

constexpr double kMaxGap = 10.0;  // [s] between two true poses that are interpolated
const char* const kTruthType = "geometry_msgs/PoseStamped";

void checkFrame(const std::string& frame, const std::string& topic, const BagTruthRequest& request) {
  const std::string found = "the true poses of topic '" + topic + "' are in frame '" + frame + "', expected ";
  if (!request.frame.empty() && frame != ros_common::frameName(request.frame)) {
    throw ros_bags::BagError(found + "'" + request.frame + "'");
  }
  for (const std::string& wrong : request.wrong_frames) {
    if (frame == ros_common::frameName(wrong)) {
      throw ros_bags::BagError(found + "the frame of the reference map, which '" + wrong + "' cannot be");
    }
  }
}

}  // namespace

BagTruth::BagTruth(const rosbag::Bag& bag, const std::string& path, const BagTruthRequest& request) {
  const ros_bags::BagTopics topics = ros_bags::topicsOf(bag);
  const std::string topic = ros_bags::chooseTopic(path, topics, request.topic, {kTruthType});
  std::string frame;
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  ros_bags::forEachMessage(bag, view, [&](const rosbag::MessageInstance& message) {
    const auto pose = ros_bags::readMessage<geometry_msgs::PoseStamped>(path, message);
    const std::string this_frame = ros_common::frameName(pose->header.frame_id);
    checkFrame(this_frame, topic, request);
    if (!poses_.empty() && this_frame != frame) {
      throw ros_bags::BagError("the true poses of topic '" + topic + "' are in the frames '" + frame + "' and '" +
                               this_frame + "', expected one frame");
    }
    frame = this_frame;
    poses_[pose->header.stamp.toSec()] = ros_common::fromMessage(pose->pose, "the true pose");
  });
  if (poses_.empty()) {
    throw ros_bags::BagError("topic '" + topic + "' of bag '" + path + "' holds no message, expected true poses");
  }
}

std::optional<BagTruth> readTruth(const rosbag::Bag& bag, const std::string& path, const BagTruthRequest& request) {
  return request.topic.empty() ? std::nullopt : std::optional<BagTruth>(BagTruth(bag, path, request));
}

std::optional<grid::Rigid2> BagTruth::at(double time) const {
  const auto after = poses_.lower_bound(time);
  if (after == poses_.end() || (after == poses_.begin() && after->first > time)) {
    return std::nullopt;
  }
  if (after->first == time) {
    return after->second;
  }
  const auto before = std::prev(after);
  const double gap = after->first - before->first;
  if (gap > kMaxGap) {
    return std::nullopt;
  }
  const double part = (time - before->first) / gap;
  const grid::Rigid2 T = before->second.inverse() * after->second;
  return before->second * grid::Rigid2{part * T.x, part * T.y, part * T.yaw};
}

}  // namespace map_matcher::ros_trials
