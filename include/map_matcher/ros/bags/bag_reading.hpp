/// \file
/// Opening bags and finding one's way in them.
#pragma once

#include <ros/exception.h>
#include <ros/message_traits.h>
#include <rosbag/bag.h>
#include <rosbag/message_instance.h>
#include <rosbag/view.h>

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace map_matcher::ros_bags {

/// A bag that cannot be used; the message names the bag, what is wrong and what is there instead.
class BagError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Topics of a bag with their types; a topic of several types has all of them in one text, "a and b".
using BagTopics = std::map<std::string, std::string>;

/// Opens a bag for reading. Throws BagError, with what can be done about it, for a file that cannot be read, is no bag,
/// has no index or is damaged.
void openBag(rosbag::Bag& bag, const std::string& path);

/// Calls `use` for each message of the view. Throws BagError, with bag, topic and time, where the file is damaged;
/// `use` throws what it likes.
void forEachMessage(const rosbag::Bag& bag, rosbag::View& view,
                    const std::function<void(const rosbag::MessageInstance&)>& use);

BagTopics topicsOf(const rosbag::Bag& bag);

/// "/odom (nav_msgs/Odometry), /scan (sensor_msgs/LaserScan)"; "nothing" when there is none.
std::string listed(const BagTopics& topics);

/// A topic by its name with or without the leading slash. Throws BagError when there is none, or it has none of the
/// `types`, if any are given; `bag` names the bag.
std::string chooseTopic(const std::string& bag, const BagTopics& topics, const std::string& asked,
                        const std::vector<std::string>& types = {});

/// The topic of the scans: the one asked for, with or without its leading slash, or when that is empty the only one of
/// type sensor_msgs/LaserScan. Throws BagError when there is none or no telling which. `bag` names the bag.
std::string chooseScanTopic(const std::string& bag, const BagTopics& topics, const std::string& asked);

/// The topics of detections that are asked for, with or without their leading slashes. Throws BagError, naming the bag,
/// for one that is not there or is neither geometry_msgs/PoseArray nor map_matcher/PersonDetections.
std::vector<std::string> chooseDetectionTopics(const std::string& bag, const BagTopics& topics,
                                               const std::vector<std::string>& asked);

/// The content of a message. Throws BagError, naming the bag, the topic and both types, for a message of another type,
/// and for one that is damaged.
template <typename Message>
boost::shared_ptr<const Message> readMessage(const std::string& bag, const rosbag::MessageInstance& message) {
  const std::string where = "topic '" + message.getTopic() + "' of bag '" + bag + "' holds ";
  try {
    if (boost::shared_ptr<const Message> content = message.instantiate<Message>()) {
      return content;
    }
  } catch (const ros::Exception& error) {
    throw BagError(where + "a damaged " + message.getDataType() + ": " + error.what());
  }
  throw BagError(where + "a " + message.getDataType() + " that is not the " +
                 ros::message_traits::DataType<Message>::value() + " that was expected");
}

/// Throws BagError, naming the bag and what it has, unless there is /tf with the transforms from `odom_frame` on.
void requireTransforms(const std::string& bag, const BagTopics& topics, const std::string& odom_frame);

}  // namespace map_matcher::ros_bags
