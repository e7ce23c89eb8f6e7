#include "map_matcher/ros/mapping/session_mapping.hpp"

#include <sstream>
#include <stdexcept>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"
#include "map_matcher/ros/common/stamps.hpp"

namespace map_matcher::ros_mapping {
namespace {

constexpr double kReorderTolerance = 0.5;  // [s] scans older than their predecessor by less are out of order

}  // namespace

parameters::ParameterList parametersOf(SessionMappingOptions& options) {
  parameters::ParameterList parameters = parametersOf(options.mapper);
  parameters.push_back({"base_frame", "", "tf frame of the robot.", &options.base_frame});
  parameters.push_back({"odom_frame", "", "tf frame of the odometry.", &options.odom_frame});
  parameters.push_back(
      {"throttle_scans", "", "Only every so many-th scan of a laser is looked at.", &options.throttle_scans, 1, 10000});
  parameters.push_back({"map_update_interval", "s",
                        "A map is published after a drawn scan when the last one is older than this.",
                        &options.map_update_interval, 0.0, 3600.0});
  return parameters;
}

SessionMapping::SessionMapping(const SessionMappingOptions& options) : options_(options), mapper_(options.mapper) {
  options_.base_frame = ros_common::frameName(options.base_frame);
  options_.odom_frame = ros_common::frameName(options.odom_frame);
  SessionMappingOptions copy = options;
  parameters::throwIfAny(parameters::problemsOf(parametersOf(copy)));
}

MappingUpdate SessionMapping::addScan(const sensor_msgs::LaserScan& scan, const tf2::BufferCore& tf,
                                      std::size_t laser) {
  // Whatever can throw comes first: a scan whose transforms are still on their way may be handed in again.
  const ros::Time stamp = scan.header.stamp;
  const auto odometry = tf.lookupTransform(options_.odom_frame, options_.base_frame, stamp);
  const auto mount = tf.lookupTransform(options_.base_frame, ros_common::frameName(scan.header.frame_id), stamp);
  const grid::Rigid2 T_odom_base = ros_common::projectToPlane(odometry.transform, "the odometry");
  const scan::PlanarScan planar_scan = ros_common::fromMessage(scan);
  const scan::LaserMount laser_mount = ros_common::laserMountFrom(mount.transform);
  MappingUpdate update;
  update.new_session = beginSessionIfTimeJumped(stamp, laser);
  if (isThrottled(laser)) {
    update.report.reason = "throttle_scans leaves this scan out";
    return update;
  }
  update.report = mapper_.addScan(stamp.toSec(), T_odom_base, planar_scan, laser_mount, laser);
  if (update.report.new_session) {
    last_map_.reset();
  }
  last_used_ = stamp;
  if (mapIsDue(update.report, stamp)) {
    last_map_ = stamp;
    update.snapshot = snapshot();
  }
  return update;
}

bool SessionMapping::beginSessionIfTimeJumped(const ros::Time& stamp, std::size_t laser) {
  const ros::Time last_scan = lasers_[laser].last_scan;
  const bool jumped = ros_common::secondsBetween(stamp, last_scan) > kReorderTolerance;
  if (jumped) {
    beginNewSession();
  } else if (stamp < last_scan) {
    std::ostringstream text;
    text << "the scan's stamp is " << stamp << ", expected at least that of its predecessor, " << last_scan;
    throw ros_common::MessageError(text.str());
  }
  lasers_[laser].last_scan = stamp;
  return jumped;
}

void SessionMapping::beginNewSession() {
  mapper_.reset();
  lasers_.clear();
  last_map_.reset();
}

std::optional<SessionSnapshot> SessionMapping::snapshot() const {
  auto map = mapper_.map();
  if (!map) {
    return std::nullopt;
  }
  return SessionSnapshot{last_used_, mapper_.T_session_base(), mapper_.T_session_odom(), std::move(*map)};
}

bool SessionMapping::isThrottled(std::size_t laser) {
  return lasers_[laser].num_scans++ % options_.throttle_scans != 0;
}

bool SessionMapping::mapIsDue(const mapping::ScanReport& report, const ros::Time& stamp) const {
  return report.outcome == mapping::ScanOutcome::kDrawn &&
         (!last_map_ || ros_common::secondsBetween(*last_map_, stamp) > options_.map_update_interval);
}

}  // namespace map_matcher::ros_mapping
