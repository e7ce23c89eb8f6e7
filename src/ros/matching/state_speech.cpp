#include "map_matcher/ros/matching/state_speech.hpp"

#include <std_msgs/String.h>

#include "map_matcher/ros/common/names.hpp"

namespace map_matcher::ros_matching {
namespace {

std::string sentenceOf(std::uint8_t state, const std::string& reference) {
  switch (state) {
    case MapMatch::LOCALIZED:
      return "I know where I am, in " + reference + ".";
    case MapMatch::LOST:
      return "I am lost.";
    default:
      return "I am looking for where I am.";
  }
}

}  // namespace

StateSpeech::StateSpeech(ros::NodeHandle node, bool enabled) {
  if (enabled) {
    publisher_ = node.advertise<std_msgs::String>(ros_common::names::kSpeech, 1, true);
  }
}

void StateSpeech::tell(const MapMatch& report) {
  std::uint8_t state = report.state;
  if (state == MapMatch::TENTATIVE) {
    state = MapMatch::SEARCHING;
  }
  const bool is_found = report.status == MapMatch::MATCHED;
  if (!publisher_ || (state == state_ && (!is_found || report.reference_frame == reference_))) {
    return;
  }
  if (state == MapMatch::LOCALIZED && !is_found) {
    return;  // the place in use is told of when it is found
  }
  state_ = state;
  reference_ = is_found ? report.reference_frame : reference_;
  std_msgs::String message;
  message.data = sentenceOf(state, reference_);
  publisher_.publish(message);
}

}  // namespace map_matcher::ros_matching
