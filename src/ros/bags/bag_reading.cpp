#include "map_matcher/ros/bags/bag_reading.hpp"

#include <ros/exception.h>
#include <rosbag/view.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <new>
#include <system_error>

#include "map_matcher/parameters/number_text.hpp"

namespace map_matcher::ros_bags {
namespace {

const char* const kScanType = "sensor_msgs/LaserScan";
const char* const kPosesType = "geometry_msgs/PoseArray";
const char* const kDetectionsType = "map_matcher/PersonDetections";
const char* const kMagic = "#ROSBAG V";
const char* const kRepair = "; rosbag reindex or rosbag fix may save what is good, else record it anew";

/// What can be said of a file before rosbag looks at it.
void requireBagFile(const std::string& path) {
  std::error_code unreadable;
  if (std::filesystem::is_directory(path, unreadable)) {
    throw BagError("bag '" + path + "' cannot be read: it is a directory");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw BagError("bag '" + path + "' cannot be read: " + std::generic_category().message(errno));
  }
  std::string line;
  std::getline(file, line);
  if (line.rfind(kMagic, 0) != 0) {
    throw BagError("file '" + path + "' is " + (line.empty() ? "empty or no bag" : "no bag") +
                   ", expected one that begins with " + kMagic);
  }
}

}  // namespace

BagTopics topicsOf(const rosbag::Bag& bag) {
  rosbag::View view(bag);
  BagTopics topics;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    std::string& types = topics[connection->topic];  // a topic has a connection for each of its publishers
    if (types.empty()) {
      types = connection->datatype;
    } else if ((" and " + types + " and ").find(" and " + connection->datatype + " and ") == std::string::npos) {
      types += " and " + connection->datatype;
    }
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

std::string chooseTopic(const std::string& bag, const BagTopics& topics, const std::string& asked,
                        const std::vector<std::string>& types) {
  const auto found = topics.count(asked) > 0 ? topics.find(asked) : topics.find("/" + asked);
  if (found == topics.end()) {
    throw BagError("bag '" + bag + "' has no topic '" + asked + "'; it has " + listed(topics));
  }
  if (!types.empty() && std::find(types.begin(), types.end(), found->second) == types.end()) {
    std::string expected;
    for (const std::string& type : types) {
      expected += (expected.empty() ? "" : " or ") + type;
    }
    throw BagError("topic '" + found->first + "' of bag '" + bag + "' is " + found->second + ", expected " + expected +
                   "; the bag has " + listed(topics));
  }
  return found->first;
}

std::string chooseScanTopic(const std::string& bag, const BagTopics& topics, const std::string& asked) {
  if (!asked.empty()) {
    return chooseTopic(bag, topics, asked, {kScanType});
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

std::vector<std::string> chooseDetectionTopics(const std::string& bag, const BagTopics& topics,
                                               const std::vector<std::string>& asked) {
  std::vector<std::string> chosen;
  chosen.reserve(asked.size());
  for (const std::string& name : asked) {
    chosen.push_back(chooseTopic(bag, topics, name, {kPosesType, kDetectionsType}));
  }
  return chosen;
}

void requireTransforms(const std::string& bag, const BagTopics& topics, const std::string& odom_frame) {
  if (topics.count("/tf") == 0) {
    throw BagError("bag '" + bag + "' has no /tf, expected the transforms from " + odom_frame +
                   " to the laser; it has " + listed(topics));
  }
}

void openBag(rosbag::Bag& bag, const std::string& path) {
  requireBagFile(path);
  try {
    bag.open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw BagError("bag '" + path + "' has no index, expected a bag that was closed; rosbag reindex repairs it");
  } catch (const ros::Exception& error) {
    throw BagError("bag '" + path + "' is damaged: " + error.what() + kRepair);
  } catch (const std::bad_alloc& error) {
    throw BagError("bag '" + path + "' is damaged: " + error.what() + kRepair);
  } catch (const std::length_error& error) {
    throw BagError("bag '" + path + "' is damaged: " + error.what() + kRepair);
  }
}

void forEachMessage(const rosbag::Bag& bag, rosbag::View& view,
                    const std::function<void(const rosbag::MessageInstance&)>& use) {
  std::string place = "its first message";
  const auto damaged = [&](const std::exception& error) {
    return BagError("bag '" + bag.getFileName() + "' is damaged at " + place + ": " + error.what() + kRepair);
  };
  try {
    for (const rosbag::MessageInstance& message : view) {
      place = "a message of topic '" + message.getTopic() + "' recorded at " +
              parameters::numberText(message.getTime().toSec()) + " s";
      use(message);
    }
  } catch (const ros::Exception& error) {
    throw damaged(error);
  } catch (const std::bad_alloc& error) {  // a length that is none
    throw damaged(error);
  } catch (const std::length_error& error) {
    throw damaged(error);
  }
}

}  // namespace map_matcher::ros_bags
