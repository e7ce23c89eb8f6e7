/// \file
/// Scans of a bag wait until their transforms have come.
#pragma once

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>

#include <deque>
#include <functional>
#include <string>

namespace map_matcher {

/// Hands scans on in the order in which they were recorded, as soon as they can be used.
class BagScanQueue {
 public:
  static constexpr double kPatience = 1.0;  ///< [s] How much later than a scan its transforms may be recorded.

  /// Uses a scan. Throws tf2::TransformException while transforms are missing, and another std::runtime_error for a
  /// scan that cannot be used at all.
  using Use = std::function<void(const sensor_msgs::LaserScan&)>;

  explicit BagScanQueue(Use use) : use_(std::move(use)) {}

  /// `recorded`: when the bag got it.
  void add(const sensor_msgs::LaserScanConstPtr& scan, const ros::Time& recorded) {
    waiting_.push_back({scan, recorded});
  }

  /// Hands on the scans that can be used when the bag has been read up to `now`, and gives up those that have waited
  /// longer than kPatience.
  void release(const ros::Time& now) { releaseBefore(now - ros::Duration(kPatience)); }

  /// At the end of the bag: all that can be used; the others are given up.
  void releaseAll() { releaseBefore(ros::TIME_MAX); }

  int withoutTransforms() const { return without_transforms_; }     ///< Scans given up for want of transforms.
  int refused() const { return refused_; }                          ///< Scans that could not be used at all.
  const std::string& lastProblem() const { return last_problem_; }  ///< Of the latest such scan; empty: none.

 private:
  struct Waiting {
    sensor_msgs::LaserScanConstPtr scan;
    ros::Time recorded;
  };

  void releaseBefore(const ros::Time& deadline);

  Use use_;
  std::deque<Waiting> waiting_;
  int without_transforms_ = 0;
  int refused_ = 0;
  std::string last_problem_;
};

}  // namespace map_matcher
