/// \file
/// Holds scans back until their detections are there.
#pragma once

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>

#include <deque>
#include <string>
#include <vector>

#include "map_matcher/scrubbing/detections.hpp"

namespace map_matcher {

/// Scans of the mode synchronised, in the order in which they came; none overtakes another.
class WaitingScans {
 public:
  /// A scan that may go.
  struct Released {
    sensor_msgs::LaserScanConstPtr scan;
    bool answered = false;  ///< Whether its detections came; false: it waited long enough.
  };

  /// `timeout`: how long a scan waits.
  explicit WaitingScans(ros::WallDuration timeout) : timeout_(timeout) {}

  /// `now` is a time that never goes back.
  void add(const sensor_msgs::LaserScanConstPtr& scan, ros::SteadyTime now);

  /// Detections made from a scan of this frame and stamp have come, maybe before the scan.
  void onDetections(const std::string& frame, Stamp stamp);

  /// Those that may go at `now`, the oldest first; they wait no longer.
  std::vector<Released> release(ros::SteadyTime now);

  bool empty() const { return waiting_.empty(); }

 private:
  struct Waiting {
    sensor_msgs::LaserScanConstPtr scan;
    ros::SteadyTime deadline;
  };
  struct Answer {
    std::string frame;
    Stamp stamp{0};
  };

  bool isAnswered(const sensor_msgs::LaserScan& scan) const;

  ros::WallDuration timeout_;
  std::deque<Waiting> waiting_;
  std::deque<Answer> answers_;  // the last ones
};

}  // namespace map_matcher
