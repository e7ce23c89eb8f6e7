/// \file
/// Scans of a bag wait until their transforms have come.
#pragma once

#include <ros/time.h>
#include <rosbag/bag.h>
#include <rosbag/message_instance.h>
#include <sensor_msgs/LaserScan.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <string>

#include "map_matcher/ros/bags/bag_transforms.hpp"

namespace map_matcher::ros_bags {

/// Hands the scans of a bag on in the order in which they were recorded, as soon as their transforms are there.
class BagScanQueue {
 public:
  static constexpr double kPatience = 1.0;  ///< [s] How much later than a scan its transforms may be recorded.

  /// Uses a scan of a laser. Throws tf2::TransformException while transforms are missing, and another
  /// std::runtime_error for a scan that cannot be used at all.
  using Use = std::function<void(const sensor_msgs::LaserScan& scan, std::size_t laser)>;

  /// `path` names the bag, all of whose static transforms are taken at once.
  BagScanQueue(const rosbag::Bag& bag, const std::string& path, Use use);

  /// Takes the message when it is one of /tf, and hands on the scans that can be used now that the bag has been read
  /// up to it; those that have waited longer than kPatience are given up. To be called with every message of interest,
  /// after addScan().
  void read(const rosbag::MessageInstance& message);

  /// Adds the scan of a message, of the laser of this number. Throws BagError, naming the bag, the topic and both
  /// types, for another type.
  void addScan(const rosbag::MessageInstance& message, std::size_t laser = 0);

  /// At the end of the bag: hands on all that can be used; the others are given up.
  void finish() { releaseBefore(ros::TIME_MAX); }

  const tf2::BufferCore& tf() const { return tf_.buffer(); }        ///< The transforms of the last moments.
  int withoutTransforms() const { return without_transforms_; }     ///< Scans given up for want of transforms.
  int refused() const { return refused_; }                          ///< Scans that could not be used at all.
  const std::string& lastProblem() const { return last_problem_; }  ///< Of the latest such scan; empty: none.

 private:
  struct Waiting {
    sensor_msgs::LaserScanConstPtr scan;
    std::size_t laser = 0;
    ros::Time recorded;
  };

  void releaseBefore(const ros::Time& deadline);

  std::string path_;
  Use use_;
  BagTransforms tf_;
  std::deque<Waiting> waiting_;
  int without_transforms_ = 0;
  int refused_ = 0;
  std::string last_problem_;
};

}  // namespace map_matcher::ros_bags
