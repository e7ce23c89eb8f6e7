#include "map_matcher/ros/matching/fix_keeper.hpp"

#include <ros/console.h>

#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "map_matcher/ros/common/stamps.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr double kErrorPeriod = 30.0;  // between two lines about a file that cannot be written [s]

void tellUnwritten(const std::string& what) {
  ROS_ERROR_STREAM_THROTTLE(kErrorPeriod, "the fix is not saved: " << what);
}

/// The fix that the last run saved; nothing when there is none that can be used.
std::optional<fixes::SavedFix> savedFix(const std::string& path) {
  std::error_code unreadable;
  if (path.empty() || !std::filesystem::exists(path, unreadable)) {
    return std::nullopt;  // as before the first fix
  }
  try {
    return fixes::loadFix(path);
  } catch (const fixes::FixFileError& error) {
    ROS_WARN_STREAM("the saved fix is ignored: " << error.what());
    return std::nullopt;
  }
}

belief::Prior priorOf(const fixes::SavedFix& fix, const grid::Rigid2& T_session_base, std::size_t map) {
  Eigen::Matrix3d covariance = fix.pose.covariance;
  covariance(0, 0) += FixKeeper::kPushed * FixKeeper::kPushed;
  covariance(1, 1) += FixKeeper::kPushed * FixKeeper::kPushed;
  covariance(2, 2) += FixKeeper::kTurned * FixKeeper::kTurned;
  return belief::priorOfRobot(fix.pose.T_reference_base, covariance, T_session_base, "saved fix", map);
}

}  // namespace

FixKeeper::FixKeeper(const std::string& path, RobotLocator& locator, const RobotPoseSource& robot)
    : path_(path), locator_(locator), robot_(robot), offered_(savedFix(path)) {
  writer_.emplace(tellUnwritten);
}

FixKeeper::~FixKeeper() {
  writer_.reset();  // so that no two write at a time
  if (!last_) {
    return;
  }
  try {
    fixes::saveFix(*last_, path_);
  } catch (const std::exception& error) {
    tellUnwritten(error.what());
  }
}

void FixKeeper::keep(const ros::Time& now) {
  if (path_.empty() || (now >= kept_ && ros_common::secondsBetween(kept_, now) < kPeriod)) {
    return;
  }
  const std::optional<LocatedRobot> robot = locator_.locate(now);
  if (!robot) {
    return;
  }
  kept_ = now;
  last_ = fixes::SavedFix{robot->reference->frame, robot->reference->digest, robot->pose};
  writer_->submit([path = path_, fix = *last_](const work::StopToken& /*stop*/) { fixes::saveFix(fix, path); });
}

std::optional<belief::Prior> FixKeeper::offer(const MapsLookup& look_up, const ros::Time& now) {
  if (!offered_) {
    return std::nullopt;
  }
  const MapsInUse maps = look_up();
  if (maps.references.empty() || maps.session_frame.empty()) {
    return std::nullopt;
  }
  const auto reference = findFrame(maps.references, offered_->reference_map);
  if (reference == maps.references.end() || (*reference)->digest != offered_->reference_digest) {
    ROS_WARN_STREAM("the saved fix of " << path_ << " is ignored: it is about another reference map, \""
                                        << offered_->reference_map << "\" as it was when it was saved");
    offered_.reset();
    return std::nullopt;
  }
  const RobotPose robot = robot_.atOrShortlyBefore(maps.session_frame, now);
  if (!robot.T_session_base) {
    return std::nullopt;
  }
  const grid::Rigid2& pose = offered_->pose.T_reference_base;
  ROS_INFO_STREAM("the robot was last at (" << pose.x << " m, " << pose.y << " m, " << pose.yaw << " rad) in \""
                                            << (*reference)->frame << "\", by " << path_
                                            << ": that is weighed against what the next map shows");
  return priorOf(*std::exchange(offered_, std::nullopt), *robot.T_session_base,
                 static_cast<std::size_t>(reference - maps.references.begin()));
}

}  // namespace map_matcher::ros_matching
