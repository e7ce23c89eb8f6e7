#include "map_matcher/ros/lidar_scrubber_server.hpp"

#include <ros/console.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/detection_messages.hpp"

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
  return options;
}

}  // namespace

LidarScrubberServer::LidarScrubberServer(ros::NodeHandle node, const ros::NodeHandle& private_node,
                                         const LidarScrubberServerOptions& options)
    : options_(checked(options)),
      waiting_scans_(ros::WallDuration(options_.sync_timeout)),
      detectors_(options_.detection_topics, options_.silence_warning, options_.silence_error,
                 options_.scrubbing.cache.cache_duration),
      tf_listener_(tf_, node),
      removal_(tf_, options_.fixed_frame, options_.scrubbing),
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
  if (!isUsable(*scan, now) || isWithheld(now)) {
    return;
  }
  if (options_.mode == "synchronised") {
    waiting_scans_.add(scan, ros::SteadyTime::now());
    releaseWaiting();
  } else {
    scrub(scan);
  }
}

bool LidarScrubberServer::isUsable(const sensor_msgs::LaserScan& scan, const ros::Time& now) {
  try {
    if (const auto jump = removal_.onScan(scan)) {
      ROS_WARN_STREAM(*jump << ": the detections so far are forgotten");
      detectors_.restart(now);
    }
    return true;
  } catch (const MessageError& error) {
    ++record_.dropped;
    record_.last_problem = error.what();
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "scan dropped (" << record_.dropped << " so far): " << error.what());
    return false;
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

void LidarScrubberServer::releaseWaiting() {
  for (const WaitingScans::Released& released : waiting_scans_.release(ros::SteadyTime::now())) {
    record_.timed_out += released.answered ? 0 : 1;
    scrub(released.scan);
  }
}

void LidarScrubberServer::onDetections(DetectionSet set) {
  const ros::Time now = ros::Time::now();
  DetectorRecord& record = detectors_.record(set.source);
  if (isFromTheFuture(record, set, now)) {
    return;
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
  removal_.add(std::move(set));
  releaseWaiting();
}

bool LidarScrubberServer::isFromTheFuture(DetectorRecord& record, const DetectionSet& set, const ros::Time& now) {
  if (record_.last_scan.isZero()) {
    return false;
  }
  record.last_delay = seconds(removal_.newestScan() - set.stamp);
  const double latest = (now - record_.last_scan).toSec() + kMaxFuture;  // [s] after the newest scan
  if (-record.last_delay <= latest) {
    return false;
  }
  onBadDetections(set.source, "a stamp lies " + std::to_string(-record.last_delay) +
                                  " s after the newest scan's, expected at most " + std::to_string(latest) + " s");
  return true;
}

void LidarScrubberServer::onBadDetections(const std::string& topic, const std::string& reason) {
  DetectorRecord& record = detectors_.record(topic);
  ++record.bad_messages;
  record.last_problem = reason;
  ROS_ERROR_STREAM_THROTTLE(
      kWarningPeriod, topic << ": detections dropped (" << record.bad_messages << " messages so far): " << reason);
}

void LidarScrubberServer::scrub(const sensor_msgs::LaserScanConstPtr& scan) {
  const PeopleRemoval::PathCounts paths_before = removal_.paths();
  const ScrubbedScan scrubbed = removal_.scrub(scan);
  scan_publisher_.publish(scrubbed.scan);
  display_.show(scan->header, removal_.scrubber(), scrubbed.removed, removal_.discs());
  record_.last_removed = scrubbed.removed.size();
  record_.removed_beams += static_cast<std::int64_t>(scrubbed.removed.size());
  record_.paths = removal_.paths();
  tellOfPaths(paths_before);
  if (scrubbed.tooMany()) {
    ++record_.too_much;
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "scan passed as it is ("
                                                 << record_.too_much << " so far): " << scrubbed.near_people << " of "
                                                 << scrubbed.points << " points are near people, expected at most "
                                                 << options_.scrubbing.max_removed_fraction
                                                 << " of them (max_removed_fraction)");
  }
}

void LidarScrubberServer::tellOfPaths(const PeopleRemoval::PathCounts& before) const {
  const auto taken = [&](PosePath path) {
    const auto index = static_cast<std::size_t>(path);
    return removal_.paths()[index] > before[index];
  };
  if (taken(PosePath::kNone)) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "detections in frame " << removal_.unknownFrame()
                                                                    << " are not used, since tf does not connect it "
                                                                       "with the frame of the scans");
  }
  if (taken(PosePath::kSensorFrame) && !options_.fixed_frame.empty()) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "tf does not know the laser in " << options_.fixed_frame
                                                                              << " at the stamps of the scans: "
                                                                                 "detections are used as if the robot "
                                                                                 "stood still");
  }
}

}  // namespace map_matcher
