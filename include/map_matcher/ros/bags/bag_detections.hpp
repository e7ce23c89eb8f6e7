/// \file
/// Detections of people in a bag.
#pragma once

#include <rosbag/message_instance.h>

#include <optional>
#include <string>
#include <vector>

#include "map_matcher/ros/bags/bag_reading.hpp"
#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher::ros_bags {

/// Reads the detections of a bag, message by message.
class BagDetections {
 public:
  /// `bag` names the bag, `asked` its topics of detections, see chooseDetectionTopics(), which also tells what is
  /// thrown.
  BagDetections(const std::string& bag, const BagTopics& topics, const std::vector<std::string>& asked);

  /// Whether a message is on one of the topics.
  bool has(const rosbag::MessageInstance& message) const;

  /// The people of such a message; nothing, and counted, when it makes no sense. Throws BagError for a message of
  /// another type.
  std::optional<scrubbing::DetectionSet> read(const rosbag::MessageInstance& message);

  int leftOut() const { return left_out_; }                         ///< Messages that made no sense.
  const std::string& lastProblem() const { return last_problem_; }  ///< Why the last of them did not; empty: none.

 private:
  std::string bag_;
  std::vector<std::string> topics_;
  int left_out_ = 0;
  std::string last_problem_;
};

}  // namespace map_matcher::ros_bags
