#include "map_matcher/ros/matching/robot_announcer_options.hpp"

namespace map_matcher::ros_matching {

parameters::ParameterList parametersOf(RobotAnnouncerOptions& options) {
  return {
      {"robot_pose_rate", "Hz",
       "How often robot_pose, the robot in the reference map, is sent in a second; 0 is never.",
       &options.robot_pose_rate, 0.0, 1000.0},
      {"publish_initialpose", "",
       "Whether initialpose is sent, for amcl, each time the robot was found: once, with the stamp of the session map.",
       &options.publish_initialpose},
      {"fix_file", "",
       "File that the robot's last place is kept in, as a hint for the next start in the same map; empty is none.",
       &options.fix_file},
  };
}

}  // namespace map_matcher::ros_matching
