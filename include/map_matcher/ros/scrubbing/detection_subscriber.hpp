/// \file
/// Listens to a detector, whichever message it speaks.
#pragma once

#include <ros/node_handle.h>
#include <topic_tools/shape_shifter.h>

#include <functional>
#include <string>

#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher::ros_scrubbing {

/// Subscribes at once, since DR-SPAAM rests while nobody listens. Takes geometry_msgs/PoseArray and
/// map_matcher/PersonDetections; the publisher decides. Anything else is an error that is told once.
class DetectionSubscriber {
 public:
  using OnDetections = std::function<void(scrubbing::DetectionSet)>;
  using OnBadMessage = std::function<void(const std::string& reason)>;

  /// The callbacks are called on the thread of the node handle's queue. The source of the sets is `topic`.
  DetectionSubscriber(ros::NodeHandle node, const std::string& topic, OnDetections on_detections,
                      OnBadMessage on_bad_message);

  DetectionSubscriber(const DetectionSubscriber&) = delete;
  DetectionSubscriber& operator=(const DetectionSubscriber&) = delete;

  const std::string& topic() const { return topic_; }
  std::uint32_t numPublishers() const { return subscriber_.getNumPublishers(); }

 private:
  void onMessage(const topic_tools::ShapeShifter& message) const;

  std::string topic_;
  OnDetections on_detections_;
  OnBadMessage on_bad_message_;
  ros::Subscriber subscriber_;
};

}  // namespace map_matcher::ros_scrubbing
