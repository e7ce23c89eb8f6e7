#include "map_matcher/ros/bag_reading.hpp"

#include <rosbag/view.h>

#include "map_matcher/ros/conversions.hpp"

namespace map_matcher {
namespace {

const char* const kScanType = "sensor_msgs/LaserScan";

}  // namespace

BagTopics topicsOf(const rosbag::Bag& bag) {
  rosbag::View view(bag);
  BagTopics topics;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    topics[connection->topic] = connection->datatype;
  }
  return topics;
}

std::string listed(const BagTopics& topics) {
  std::string text;
  for (const auto& [topic, type] : topics) {
    text += (text.empty() ? "" : ", ") + topic + " (" + type + ")";
  }
  return text.empty() ? "nothing" : text;
}

std::string chooseTopic(const std::string& bag, const BagTopics& topics, const std::string& asked) {
  for (const std::string& name : {asked, "/" + asked}) {
    if (topics.count(name) > 0) {
      return name;
    }
  }
  throw BagError("bag '" + bag + "' has no topic '" + asked + "'; it has " + listed(topics));
}

std::string chooseScanTopic(const std::string& bag, const BagTopics& topics, const std::string& asked) {
  if (!asked.empty()) {
    const auto found = topics.count(asked) > 0 ? topics.find(asked) : topics.find("/" + asked);
    if (found == topics.end()) {
      throw BagError("bag '" + bag + "' has no topic '" + asked + "'; it has " + listed(topics));
    }
    if (found->second != kScanType) {
      throw BagError("topic '" + found->first + "' of bag '" + bag + "' is " + found->second + ", expected " +
                     kScanType + "; the bag has " + listed(topics));
    }
    return found->first;
  }
  BagTopics scans;
  for (const auto& [topic, type] : topics) {
    if (type == kScanType) {
      scans[topic] = type;
    }
  }
  if (scans.empty()) {
    throw BagError("bag '" + bag + "' has no topic of " + kScanType + "; it has " + listed(topics));
  }
  if (scans.size() > 1) {
    throw BagError("bag '" + bag + "' has several topics of " + kScanType +
                   ", expected the choice of one: " + listed(scans));
  }
  return scans.begin()->first;
}

void openBag(rosbag::Bag& bag, const std::string& path) {
  try {
    bag.open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw BagError("bag '" + path + "' has no index, expected a bag that was closed; rosbag reindex repairs it");
  } catch (const rosbag::BagException& error) {
    throw BagError("bag '" + path + "' cannot be read: " + error.what());
  }
}

void takeTransforms(const tf2_msgs::TFMessage& message, bool is_static, tf2::BufferCore& tf) {
  for (geometry_msgs::TransformStamped transform : message.transforms) {
    transform.header.frame_id = frameName(transform.header.frame_id);
    transform.child_frame_id = frameName(transform.child_frame_id);
    tf.setTransform(transform, "bag", is_static);
  }
}

void takeStaticTransforms(const rosbag::Bag& bag, tf2::BufferCore& tf) {
  rosbag::View view(bag, rosbag::TopicQuery(std::string("/tf_static")));
  for (const rosbag::MessageInstance& message : view) {
    if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
      takeTransforms(*transforms, true, tf);
    }
  }
}

}  // namespace map_matcher
