/// \file
/// A recorded drive as a trial takes it.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/ros/bags/bag_reading.hpp"
#include "map_matcher/simulation/inserted_crowd.hpp"
#include "map_matcher/trials/trial.hpp"

namespace map_matcher::ros_trials {

/// Where a bag holds what a trial needs.
struct BagTrialRequest {
  std::string bag;                            ///< Path of the bag.
  std::string scan_topic;                     ///< sensor_msgs/LaserScan; empty: the only one in the bag.
  std::string truth_topic;                    ///< geometry_msgs/PoseStamped in the reference map; empty: not known.
  std::string truth_frame;                    ///< Frame that the true poses must have; empty: any.
  std::vector<std::string> detection_topics;  ///< Made from the scans of scan_topic; none: nobody was detected.
  std::string odom_frame = "odom";            ///< tf frame of the odometry.
  std::string base_frame = "base_link";       ///< tf frame of the robot.
};

/// What a bag gave to a trial.
struct BagTrialResult {
  int scans = 0;                 ///< Scans in the bag.
  int scans_left_out = 0;        ///< Those that could not be used.
  int scans_without_people = 0;  ///< Those that no crowd was put into, since the truth is not known.
  int detections_left_out = 0;   ///< Messages of detections that could not be used.
  std::string last_problem;      ///< Why the last scan or detections could not be used; empty: all could.
};

/// Hands the scans of a bag, in the order in which they were recorded, to the trial, with the odometry of tf and the
/// truth interpolated at their stamps, and the detections when they were recorded. Throws BagError for a bag that
/// cannot be read, lacks a topic or has it with another type, whose true poses are in a wrong frame, or of which no
/// scan could be used.
///
/// `crowd`, if not null, is put into the scans: people walk where the truth says that the robot was, their legs hide
/// what lies behind them, and a simulated detector looks for them. Scans without truth stay as they were recorded.
/// Throws BagError without truth_topic.
BagTrialResult playBag(const BagTrialRequest& request, trials::Trial& trial,
                       simulation::InsertedCrowd* crowd = nullptr);

}  // namespace map_matcher::ros_trials
