#include "map_matcher/ros/matching/frame_diagnostics.hpp"

#include <ros/console.h>

#include <utility>

namespace map_matcher::ros_matching {

std::string textOf(const ros_common::ContestedFrame& contested) {
  std::string parents;
  for (const ros_common::FrameParent& parent : contested.parents) {
    parents += (parents.empty() ? "\"" : ", \"") + parent.parent + "\" by " + parent.publisher;
  }
  return "the frame \"" + contested.frame + "\" has two parents on tf: " + parents +
         "; stop one of these nodes, or let one leave tf alone (amcl: tf_broadcast false; map_matcher: tf_mode none)";
}

FrameDiagnostics::FrameDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                   std::function<std::vector<ros_common::ContestedFrame>()> contested)
    : contested_(std::move(contested)), report_(node, private_node, [this] { look(); }) {
  report_.add("frames", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    if (told_.empty()) {
      status.summary(ros_common::diagnostics::kOk, "none of the robot's frames has two parents");
    } else {
      status.summary(ros_common::diagnostics::kError, told_);
    }
  });
}

void FrameDiagnostics::look() {
  std::string problem;
  for (const ros_common::ContestedFrame& frame : contested_()) {
    problem += (problem.empty() ? "" : "; ") + textOf(frame);
  }
  if (!problem.empty() && problem != told_) {
    ROS_ERROR_STREAM(problem);
  } else if (problem.empty() && !told_.empty()) {
    ROS_INFO_STREAM("none of the robot's frames has two parents any more");
  }
  told_ = problem;
}

}  // namespace map_matcher::ros_matching
