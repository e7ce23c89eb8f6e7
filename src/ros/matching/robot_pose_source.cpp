#include "map_matcher/ros/matching/robot_pose_source.hpp"

#include <tf2/exceptions.h>

#include <cmath>
#include <sstream>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"
#include "map_matcher/ros/common/stamps.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr std::size_t kMostFrames = 100;  // of a way up; a circle on tf has no end

RobotPose without(const std::string& reason) { return {std::nullopt, {}, reason}; }

}  // namespace

RobotPoseSource::RobotPoseSource(const tf2::BufferCore& tf, const std::string& base_frame)
    : tf_(tf), base_frame_(ros_common::frameName(base_frame)) {}

RobotPose RobotPoseSource::at(const std::string& session_frame, const ros::Time& stamp) const {
  if (stamp.isZero()) {
    return without("the session map has no stamp");
  }
  try {
    return lookUp(session_frame, stamp);
  } catch (const tf2::TransformException&) {
    return unknown(session_frame, stamp, 0.0);
  }
}

RobotPose RobotPoseSource::atOrShortlyBefore(const std::string& session_frame, const ros::Time& stamp) const {
  RobotPose pose = at(session_frame, stamp);
  if (pose.T_session_base || stamp.isZero()) {
    return pose;
  }
  try {
    RobotPose newest = lookUp(session_frame, ros::Time());
    const double age = ros_common::secondsBetween(newest.stamp, stamp);
    return age >= 0.0 && age <= kMaxAge ? newest : unknown(session_frame, stamp, kMaxAge);
  } catch (const tf2::TransformException&) {
    return pose;
  }
}

std::vector<std::string> RobotPoseSource::framesUpwards() const {
  std::vector<std::string> frames{base_frame_};
  std::string parent;
  while (frames.size() < kMostFrames && tf_._getParent(frames.back(), ros::Time(), parent)) {
    frames.push_back(parent);
  }
  return frames;
}

/// Throws tf2::TransformException when tf does not know.
RobotPose RobotPoseSource::lookUp(const std::string& session_frame, const ros::Time& stamp) const {
  const auto message = tf_.lookupTransform(ros_common::frameName(session_frame), base_frame_, stamp);
  try {
    const std::string name = "the pose of \"" + base_frame_ + "\" on tf";
    return {ros_common::projectToPlane(message.transform, name), message.header.stamp, ""};
  } catch (const ros_common::MessageError& error) {
    return without(error.what());
  }
}

/// Why tf does not know the pose at `stamp`, nor one that is at most `max_age` [s] older.
RobotPose RobotPoseSource::unknown(const std::string& session_frame, const ros::Time& stamp, double max_age) const {
  const std::string session = ros_common::frameName(session_frame);
  for (const std::string& frame : {base_frame_, session}) {
    if (!tf_._frameExists(frame)) {
      return without("tf knows no frame \"" + frame + "\"");
    }
  }
  std::ostringstream reason;
  try {
    const ros::Time newest = tf_.lookupTransform(session, base_frame_, ros::Time()).header.stamp;
    const double age = ros_common::secondsBetween(newest, stamp);
    reason << "tf knows where \"" << base_frame_ << "\" is in \"" << session << "\" ";
    if (age > 0.0) {
      reason << "up to " << age << " s before the session map, expected at most " << max_age << " s";
    } else {
      reason << "up to " << -age << " s after the session map, but not so long ago as that";
    }
  } catch (const tf2::ConnectivityException&) {
    reason << "tf connects \"" << base_frame_ << "\" and \"" << session << "\" in no way";
  } catch (const tf2::TransformException& error) {
    reason << error.what();
  }
  return without(reason.str());
}

}  // namespace map_matcher::ros_matching
