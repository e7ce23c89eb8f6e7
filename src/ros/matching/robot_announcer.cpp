#include "map_matcher/ros/matching/robot_announcer.hpp"

namespace map_matcher::ros_matching {

RobotAnnouncer::RobotAnnouncer(const ros::NodeHandle& node, const RobotPoseSource& robot,
                               const RobotAnnouncerOptions& options)
    : locator_(robot),
      pose_publisher_(node, locator_, options.robot_pose_rate),
      initial_pose_publisher_(node, robot, options.publish_initialpose),
      keeper_(options.fix_file, locator_, robot) {}

void RobotAnnouncer::set(const Fix& fix) {
  locator_.set(fix);
  initial_pose_publisher_.set(fix);
}

void RobotAnnouncer::clear() {
  locator_.clear();
  initial_pose_publisher_.clear();
}

std::optional<belief::Prior> RobotAnnouncer::tick(const MapsLookup& maps, const ros::Time& now) {
  initial_pose_publisher_.publishPending();
  keeper_.keep(now);
  return keeper_.offer(maps, now);
}

}  // namespace map_matcher::ros_matching
