#include "map_matcher/ros/people_removal.hpp"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <utility>

#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/detection_messages.hpp"
#include "map_matcher/ros/scan_conversions.hpp"
#include "map_matcher/scrubbing/range_removal.hpp"

namespace map_matcher {

PeopleRemoval::PeopleRemoval(const tf2::BufferCore& tf, const std::string& fixed_frame, const ScrubbingOptions& options)
    : options_(options), poses_(tf, frameName(fixed_frame)), cache_(options.cache) {}

std::optional<std::string> PeopleRemoval::onScan(const sensor_msgs::LaserScan& scan) {
  checkLayout(scan);
  const std::string frame = frameOf(scan.header);
  const Stamp stamp = stampOf(scan.header.stamp);
  std::optional<std::string> reason;
  if (!scan_frame_.empty() && frame != scan_frame_) {
    reason = "the frame of the scans is now " + frame + " instead of " + scan_frame_;
  } else if (seconds(newest_scan_ - stamp) > options_.cache.cache_duration) {
    reason = "the stamps of the scans went back by " + std::to_string(seconds(newest_scan_ - stamp)) + " s";
  }
  if (reason) {
    cache_.clear();
  }
  scan_frame_ = frame;
  newest_scan_ = reason ? stamp : std::max(stamp, newest_scan_);
  return reason;
}

ScrubbedScan PeopleRemoval::scrub(const sensor_msgs::LaserScanConstPtr& scan) {
  const std::string frame = frameOf(scan->header);
  const Stamp stamp = stampOf(scan->header.stamp);
  discs_ = cache_.discsAt(stamp, [&](const DetectionSet& set) { return poseOf(set, {frame, stamp}); });
  cache_.forget(stamp);
  RangeRemoval removal = removeRanges(layoutOf(*scan), scan->ranges, discs_, options_, scrubber_);
  ScrubbedScan scrubbed{scan, std::move(removal.removed), removal.near_people, removal.points};
  if (!scrubbed.removed.empty()) {
    const auto message = boost::make_shared<sensor_msgs::LaserScan>(*scan);
    message->ranges = std::move(removal.ranges);
    scrubbed.scan = message;
  }
  return scrubbed;
}

std::optional<Eigen::Isometry3d> PeopleRemoval::poseOf(const DetectionSet& set, const FrameAt& scan) {
  const DetectionPose pose = poses_.lookUp({set.frame, set.stamp}, scan);
  ++paths_[static_cast<std::size_t>(pose.path)];
  if (pose.path == PosePath::kNone) {
    unknown_frame_ = set.frame;
  }
  return pose.T_scan_set;
}

}  // namespace map_matcher
