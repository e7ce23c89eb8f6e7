#include "map_matcher/ros/matching/robot_locator.hpp"

#include "map_matcher/grid/pose_covariance.hpp"

namespace map_matcher::ros_matching {

void RobotLocator::set(const Fix& fix) {
  const std::lock_guard<std::mutex> lock(mutex_);
  fix_ = fix;
  reckoning_.reset();
}

void RobotLocator::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  fix_.reset();
  reckoning_.reset();
}

std::optional<LocatedRobot> RobotLocator::locate(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!fix_) {
    return std::nullopt;
  }
  const RobotPose robot = robot_.atOrShortlyBefore(fix_->session_frame, now);
  if (!robot.T_session_base) {
    return std::nullopt;
  }
  if (!reckoning_) {
    beginReckoning(robot);
  }
  reckoning_->moveTo(*robot.T_session_base, robot.stamp.toSec());
  return LocatedRobot{fix_->reference, reckoning_->estimate(), robot.stamp};
}

/// From where the robot was at the stamp of the session map; from where it is `now`, if tf does not know.
void RobotLocator::beginReckoning(const RobotPose& now) {
  const RobotPose at_fix = robot_.at(fix_->session_frame, fix_->stamp);
  const RobotPose& robot = at_fix.T_session_base ? at_fix : now;
  const grid::Rigid2& T_session_base = *robot.T_session_base;
  fixes::PoseEstimate pose;
  pose.T_reference_base = fix_->T_reference_session * T_session_base;
  pose.covariance = grid::covarianceOfProduct(fix_->T_reference_session, fix_->covariance, T_session_base);
  pose.stamp = robot.stamp.toSec();
  reckoning_.emplace(pose, T_session_base);
}

}  // namespace map_matcher::ros_matching
