#include "map_matcher/ros/lidar_scrubber_server.hpp"

#include <ros/console.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/detection_messages.hpp"
#include "map_matcher/ros/scan_conversions.hpp"

namespace map_matcher {
namespace {

constexpr std::uint32_t kScanQueue = 10;
constexpr double kWarningPeriod = 5.0;          // [s]
constexpr double kMaxFuture = 1.0;              // [s] detections may be stamped this much after the newest scan
const ros::WallDuration kWaitingPeriod(0.005);  // between two looks at waiting scans

LidarScrubberServerOptions checked(LidarScrubberServerOptions options) {
  std::vector<std::string>& topics = options.detection_topics;
  if (topics.empty() || std::find(topics.begin(), topics.end(), "") != topics.end()) {
    throw std::invalid_argument("~detection_topics holds " + std::to_string(topics.size()) +
                                " names, expected one or more, none of them empty");
  }
  if (std::set<std::string>(topics.begin(), topics.end()).size() != topics.size()) {
    throw std::invalid_argument("~detection_topics holds a name twice, expected different ones");
  }
  if (options.silence_error < options.silence_warning) {
    throw std::invalid_argument("~silence_error is " + std::to_string(options.silence_error) +
                                ", expected at least ~silence_warning = " + std::to_string(options.silence_warning) +
                                " s");
  }
  options.fixed_frame = frameName(options.fixed_frame);
  return options;
}

}  // namespace

LidarScrubberServer::LidarScrubberServer(ros::NodeHandle node, const ros::NodeHandle& private_node,
                                         const LidarScrubberServerOptions& options)
    : options_(checked(options)),
      cache_(options_.scrubbing.cache),
      waiting_scans_(ros::WallDuration(options_.sync_timeout)),
      detectors_(options_.detection_topics, options_.silence_warning, options_.silence_error,
                 options_.scrubbing.cache.cache_duration),
      tf_listener_(tf_, node),
      poses_(tf_, options_.fixed_frame),
      veto_(node, tf_, options_.wall_veto_distance),
      display_(node),
      diagnostics_(node, private_node, record_, detectors_),
      scan_publisher_(node.advertise<sensor_msgs::LaserScan>("scan_scrubbed", kScanQueue)) {
  detectors_.restart(ros::Time::now());
  for (const std::string& topic : options_.detection_topics) {
    detection_subscribers_.push_back(std::make_unique<DetectionSubscriber>(
        node, topic, [this](DetectionSet set) { onDetections(std::move(set)); },
        [this, topic](const std::string& reason) { onBadDetections(topic, reason); }));
  }
  scan_subscriber_ = node.subscribe<sensor_msgs::LaserScan>(
      "scan", kScanQueue, [this](const sensor_msgs::LaserScanConstPtr& scan) { onScan(scan); });
  if (options_.mode == "synchronised") {
    waiting_timer_ = node.createSteadyTimer(kWaitingPeriod, [this](const auto& /*event*/) { releaseWaiting(); });
  }
}

void LidarScrubberServer::onScan(const sensor_msgs::LaserScanConstPtr& scan) {
  const ros::Time now = ros::Time::now();
  if (record_.scans == 0) {
    detectors_.restart(now);
  }
  ++record_.scans;
  record_.last_scan = now;
  try {
    checkLayout(*scan);
    noticeJumps(*scan);
  } catch (const MessageError& error) {
    ++record_.dropped;
    record_.last_problem = error.what();
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "scan dropped (" << record_.dropped << " so far): " << error.what());
    return;
  }
  if (isWithheld(now)) {
    return;
  }
  if (options_.mode == "synchronised") {
    waiting_scans_.add(scan, ros::SteadyTime::now());
    releaseWaiting();
  } else {
    scrub(scan);
  }
}

void LidarScrubberServer::releaseWaiting() {
  for (const WaitingScans::Released& released : waiting_scans_.release(ros::SteadyTime::now())) {
    record_.timed_out += released.answered ? 0 : 1;
    scrub(released.scan);
  }
}

bool LidarScrubberServer::isWithheld(const ros::Time& now) {
  if (options_.on_silence != "drop") {
    return false;
  }
  const std::vector<std::string> silent = detectors_.silentTopics(now);
  if (silent.empty() && detectors_.allHeard()) {
    return false;
  }
  ++record_.withheld;
  ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "scan withheld (" << record_.withheld << " so far), since nothing comes on "
                                                             << (silent.empty() ? "a detection topic" : silent.front())
                                                             << " and ~on_silence is drop");
  return true;
}

/// Detections of another time or another laser say nothing about this scan.
void LidarScrubberServer::noticeJumps(const sensor_msgs::LaserScan& scan) {
  const std::string frame = frameOf(scan.header);
  const Stamp stamp = stampOf(scan.header.stamp);
  const bool went_back = seconds(scan_stamp_ - stamp) > options_.scrubbing.cache.cache_duration;
  if (!scan_frame_.empty() && (went_back || frame != scan_frame_)) {
    ROS_WARN_STREAM((went_back ? "the stamps of the scans went back"
                               : "the frame of the scans is now " + frame + " instead of " + scan_frame_)
                    << ": the detections so far are forgotten");
    cache_.clear();
    detectors_.restart(ros::Time::now());
  }
  scan_frame_ = frame;
  scan_stamp_ = went_back ? stamp : std::max(stamp, scan_stamp_);
}

void LidarScrubberServer::onDetections(DetectionSet set) {
  DetectorRecord& record = detectors_.record(set.source);
  const ros::Time now = ros::Time::now();
  if (!record_.last_scan.isZero()) {
    record.last_delay = seconds(scan_stamp_ - set.stamp);
    const double newest = (now - record_.last_scan).toSec() + kMaxFuture;  // [s] after the last scan
    if (-record.last_delay > newest) {
      onBadDetections(set.source, "the stamp is " + std::to_string(-record.last_delay) +
                                      " s after the newest scan's, expected at most " + std::to_string(newest) + " s");
      return;
    }
  }
  ++record.messages;
  record.last_heard = now;
  const LeftOut left_out = applyLimits(set, options_.scrubbing.limits);
  if (left_out.not_finite + left_out.too_many > 0) {
    ROS_WARN_STREAM_THROTTLE(
        kWarningPeriod, set.source << ": left out " << left_out.not_finite
                                   << " detections without a finite position within 10 km and " << left_out.too_many
                                   << " beyond max_detections = " << options_.scrubbing.limits.max_detections);
  }
  record.left_out += left_out.total();
  record.on_walls += veto_.apply(set);
  record.detections += static_cast<std::int64_t>(set.detections.size());
  waiting_scans_.onDetections(set.frame, set.stamp);
  cache_.add(std::move(set));
  releaseWaiting();
}

void LidarScrubberServer::onBadDetections(const std::string& topic, const std::string& reason) {
  DetectorRecord& record = detectors_.record(topic);
  ++record.bad_messages;
  if (reason != record.last_problem) {
    ROS_ERROR_STREAM(topic << ": detections dropped: " << reason);
  }
  record.last_problem = reason;
}

void LidarScrubberServer::scrub(const sensor_msgs::LaserScanConstPtr& scan) {
  const std::string frame = frameOf(scan->header);
  const Stamp stamp = stampOf(scan->header.stamp);
  const ScanLayout layout = layoutOf(*scan);
  const std::vector<Disc>& discs = discsFor({frame, stamp});
  cache_.forget(stamp);
  const std::vector<std::uint32_t>& beams = scrubber_.beamsInside(layout, scan->ranges, discs);
  const double most = options_.scrubbing.max_removed_fraction * scrubber_.numPoints();
  record_.last_removed = 0;
  if (static_cast<double>(beams.size()) > most) {
    ++record_.too_much;
    ROS_WARN_STREAM_THROTTLE(
        kWarningPeriod, "scan passed as it is ("
                            << record_.too_much << " so far): " << beams.size() << " of " << scrubber_.numPoints()
                            << " points are near people, expected at most " << options_.scrubbing.max_removed_fraction
                            << " of them (max_removed_fraction)");
    scan_publisher_.publish(scan);
    return;
  }
  publishWithout(scan, layout, beams);
  display_.show(scan->header, scrubber_, beams, discs);
}

const std::vector<Disc>& LidarScrubberServer::discsFor(const FrameAt& scan) {
  return cache_.discsAt(scan.stamp, [&](const DetectionSet& set) {
    const DetectionPose pose = poses_.lookUp({set.frame, set.stamp}, scan);
    ++record_.paths[static_cast<std::size_t>(pose.path)];
    if (pose.path == PosePath::kNone) {
      ROS_WARN_STREAM_THROTTLE(kWarningPeriod, set.source << ": detections in frame " << set.frame
                                                          << " are not used, since tf does not connect it with "
                                                          << scan.frame << ", the frame of the scans");
    } else if (pose.path == PosePath::kSensorFrame && !options_.fixed_frame.empty()) {
      ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "tf does not know "
                                                   << scan.frame << " in " << options_.fixed_frame
                                                   << " at the scan's stamp: detections are used as if the robot stood "
                                                      "still");
    }
    return pose.T_scan_set;
  });
}

void LidarScrubberServer::publishWithout(const sensor_msgs::LaserScanConstPtr& scan, const ScanLayout& layout,
                                         const std::vector<std::uint32_t>& beams) {
  if (beams.empty()) {
    scan_publisher_.publish(scan);
    return;
  }
  const auto scrubbed = boost::make_shared<sensor_msgs::LaserScan>(*scan);
  const float range = removedRange(options_.scrubbing.removed_range, layout);
  for (const std::uint32_t beam : beams) {
    scrubbed->ranges[beam] = range;
  }
  record_.last_removed = beams.size();
  record_.removed_beams += static_cast<std::int64_t>(beams.size());
  scan_publisher_.publish(sensor_msgs::LaserScanConstPtr(scrubbed));
}

}  // namespace map_matcher
