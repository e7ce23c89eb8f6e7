#include "map_matcher/ros/bags/bag_scan_queue.hpp"

#include <tf2/exceptions.h>

#include <stdexcept>
#include <utility>

#include "map_matcher/ros/bags/bag_reading.hpp"

namespace map_matcher::ros_bags {

BagScanQueue::BagScanQueue(const rosbag::Bag& bag, const std::string& path, Use use)
    : path_(path), use_(std::move(use)) {
  tf_.takeStatic(bag);
}

void BagScanQueue::read(const rosbag::MessageInstance& message) {
  if (message.getTopic() == "/tf") {
    if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
      tf_.take(*transforms);
    }
  }
  releaseBefore(message.getTime() - ros::Duration(kPatience));
}

void BagScanQueue::addScan(const rosbag::MessageInstance& message, std::size_t laser) {
  waiting_.push_back({readMessage<sensor_msgs::LaserScan>(path_, message), laser, message.getTime()});
}

void BagScanQueue::releaseBefore(const ros::Time& deadline) {
  for (; !waiting_.empty(); waiting_.pop_front()) {
    try {
      use_(*waiting_.front().scan, waiting_.front().laser);
    } catch (const tf2::TransformException& error) {
      if (waiting_.front().recorded >= deadline) {
        return;
      }
      ++without_transforms_;
      last_problem_ = error.what();
    } catch (const std::runtime_error& error) {
      ++refused_;
      last_problem_ = error.what();
    }
  }
}

}  // namespace map_matcher::ros_bags
