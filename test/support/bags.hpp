/// \file
/// Bags that are not as they should be.
#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <string>

namespace map_matcher::test {

/// Adds a message to a bag, after its last one, under a topic that may have another type there.
template <typename Message>
void appendToBag(const std::string& path, const std::string& topic, const Message& message) {
  const ros::Time end = [&path] {
    const rosbag::Bag bag(path, rosbag::bagmode::Read);
    return rosbag::View(bag).getEndTime();
  }();
  rosbag::Bag bag(path, rosbag::bagmode::Append);
  bag.write(topic, end + ros::Duration(0.1), message);
}

}  // namespace map_matcher::test
