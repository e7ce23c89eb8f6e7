#include "map_matcher/ros/scrubbing/detection_subscriber.hpp"

#include <exception>
#include <utility>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/detection_messages.hpp"

namespace map_matcher::ros_scrubbing {
namespace {

constexpr std::uint32_t kQueue = 10;

template <typename Message>
bool isA(const topic_tools::ShapeShifter& message) {
  return message.getMD5Sum() == ros::message_traits::MD5Sum<Message>::value();
}

scrubbing::DetectionSet read(const topic_tools::ShapeShifter& message, const std::string& source) {
  if (isA<geometry_msgs::PoseArray>(message)) {
    return ros_common::fromMessage(*message.instantiate<geometry_msgs::PoseArray>(), source);
  }
  if (isA<PersonDetections>(message)) {
    return ros_common::fromMessage(*message.instantiate<PersonDetections>(), source);
  }
  throw ros_common::MessageError("messages of type " + message.getDataType() +
                                 ", expected geometry_msgs/PoseArray or map_matcher/PersonDetections");
}

}  // namespace

DetectionSubscriber::DetectionSubscriber(ros::NodeHandle node, const std::string& topic, OnDetections on_detections,
                                         OnBadMessage on_bad_message)
    : topic_(topic), on_detections_(std::move(on_detections)), on_bad_message_(std::move(on_bad_message)) {
  subscriber_ = node.subscribe<topic_tools::ShapeShifter>(
      topic, kQueue, [this](const topic_tools::ShapeShifter::ConstPtr& message) { onMessage(*message); });
}

void DetectionSubscriber::onMessage(const topic_tools::ShapeShifter& message) const {
  try {
    on_detections_(read(message, topic_));
  } catch (const std::exception& error) {  // no people in it, a message shorter than its type, or no memory for it
    on_bad_message_(error.what());
  }
}

}  // namespace map_matcher::ros_scrubbing
