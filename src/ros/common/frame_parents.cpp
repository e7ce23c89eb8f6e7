#include "map_matcher/ros/common/frame_parents.hpp"

#include "map_matcher/ros/common/conversions.hpp"

namespace map_matcher::ros_common {

void FrameParents::add(const tf2_msgs::TFMessage& message, const std::string& publisher, bool is_static,
                       const ros::Time& now) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    const std::string child = frameName(transform.child_frame_id);
    const auto known = by_child_.find(child);
    if (known == by_child_.end() || is_static || !known->second.is_static) {
      by_child_[child] = {{frameName(transform.header.frame_id), publisher}, is_static, now};
    }
  }
}

std::optional<FrameParent> FrameParents::parentOf(const std::string& child, const ros::Time& now) const {
  const auto found = by_child_.find(child);
  if (found == by_child_.end()) {
    return std::nullopt;
  }
  const Entry& entry = found->second;
  const double age = (now - entry.heard).toSec();
  const bool present = entry.is_static || (age >= 0.0 && age <= kTimeout);  // negative after time went back
  return present ? std::optional<FrameParent>(entry.parent) : std::nullopt;
}

}  // namespace map_matcher::ros_common
