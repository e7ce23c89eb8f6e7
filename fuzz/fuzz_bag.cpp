// A bag: its topics and scans are read, or BagError says what is wrong with it.
#include <sensor_msgs/LaserScan.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "file_in_memory.hpp"
#include "map_matcher/ros/bags/bag_reading.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace map_matcher;
  const std::string path = fuzz::file("fuzz.bag", std::string(reinterpret_cast<const char*>(data), size));
  try {
    rosbag::Bag bag;
    ros_bags::openBag(bag, path);
    const ros_bags::BagTopics topics = ros_bags::topicsOf(bag);
    const std::string scans = ros_bags::chooseScanTopic(path, topics, "");
    rosbag::View view(bag, rosbag::TopicQuery(scans));
    ros_bags::forEachMessage(bag, view, [&path](const rosbag::MessageInstance& message) {
      ros_bags::readMessage<sensor_msgs::LaserScan>(path, message);
    });
  } catch (const ros_bags::BagError&) {
    return 0;
  }
  return 0;
}
