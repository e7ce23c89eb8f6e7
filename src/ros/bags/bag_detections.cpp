#include "map_matcher/ros/bags/bag_detections.hpp"

#include <geometry_msgs/PoseArray.h>
#include <map_matcher/PersonDetections.h>

#include <algorithm>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/detection_messages.hpp"

namespace map_matcher::ros_bags {

BagDetections::BagDetections(const std::string& bag, const BagTopics& topics, const std::vector<std::string>& asked)
    : bag_(bag), topics_(chooseDetectionTopics(bag, topics, asked)) {}

bool BagDetections::has(const rosbag::MessageInstance& message) const {
  return std::find(topics_.begin(), topics_.end(), message.getTopic()) != topics_.end();
}

std::optional<scrubbing::DetectionSet> BagDetections::read(const rosbag::MessageInstance& message) {
  try {
    return message.isType<PersonDetections>()
               ? ros_common::fromMessage(*readMessage<PersonDetections>(bag_, message), message.getTopic())
               : ros_common::fromMessage(*readMessage<geometry_msgs::PoseArray>(bag_, message), message.getTopic());
  } catch (const ros_common::MessageError& error) {
    ++left_out_;
    last_problem_ = error.what();
    return std::nullopt;
  }
}

}  // namespace map_matcher::ros_bags
