/// \file
/// The robot's last place, from one start of the node to the next.
#pragma once

#include <ros/time.h>

#include <optional>
#include <string>

#include "map_matcher/belief/prior.hpp"
#include "map_matcher/fixes/saved_fix.hpp"
#include "map_matcher/ros/matching/initial_pose_source.hpp"
#include "map_matcher/ros/matching/robot_locator.hpp"
#include "map_matcher/work/latest_job_worker.hpp"

namespace map_matcher::ros_matching {

/// Saves where the robot is in the reference map, again and again while that is known, and offers what the last run
/// saved, once: a robot that was switched off is most likely still about there. For one thread; files are written on
/// another one.
class FixKeeper {
 public:
  /// Time between two writings [s].
  static constexpr double kPeriod = 2.0;
  /// A robot that was switched off may have been pushed so far and turned so much, standard deviations [m] and [rad];
  /// rviz's tool takes people for as exact.
  static constexpr double kPushed = 0.5;
  static constexpr double kTurned = 0.26;

  /// `path`: empty means that nothing is saved and offered. A file that cannot be used is told and ignored. Both others
  /// must outlive this.
  FixKeeper(const std::string& path, RobotLocator& locator, const RobotPoseSource& robot);

  /// Saves where the robot is at last.
  ~FixKeeper();

  FixKeeper(const FixKeeper&) = delete;
  FixKeeper& operator=(const FixKeeper&) = delete;

  /// Saves where the robot is, unless that is not known or kPeriod has not passed; to be called again and again.
  void keep(const ros::Time& now);

  /// What the last run saved, as where the session lies, if it is about one of these reference maps: once, as soon as
  /// tf knows the robot in the session map. To be called again and again; the maps are looked up only while there is an
  /// offer.
  std::optional<belief::Prior> offer(const MapsLookup& look_up, const ros::Time& now);

 private:
  const std::string path_;
  RobotLocator& locator_;
  const RobotPoseSource& robot_;
  std::optional<fixes::SavedFix> offered_;  // not yet offered
  std::optional<fixes::SavedFix> last_;     // the newest one of this run
  ros::Time kept_;
  std::optional<work::LatestJobWorker> writer_;  // nothing only at the end
};

}  // namespace map_matcher::ros_matching
