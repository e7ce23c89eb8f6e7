#include "map_matcher/ros/scrubbing/lidar_scrubber_server.hpp"

#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>
#include <utility>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/detection_messages.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"

namespace map_matcher::ros_scrubbing {
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

scrubbing::DetectorLimits limitsOf(const LidarScrubberServerOptions& options) {
  return {options.silence_warning, options.silence_error, options.scrubbing.cache.cache_duration};
}

/// Of a clock that never goes back.
scrubbing::Stamp steadyNow() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

LidarScrubberServer::LidarScrubberServer(ros::NodeHandle node, const ros::NodeHandle& private_node,
                                         const LidarScrubberServerOptions& options)
    : options_(checked(options)),
      detectors_(options_.detection_topics, limitsOf(options_)),
      tf_listener_(tf_, node),
      transforms_(tf_),
      poses_(transforms_, ros_common::frameName(options_.fixed_frame)),
      removal_(
          options_.scrubbing,
          [this](const scrubbing::FrameAt& set, const scrubbing::FrameAt& scan) { return poses_.lookUp(set, scan); },
          options_.waits() ? std::optional<double>(options_.sync_timeout) : std::nullopt),
      veto_(node, transforms_, options_.wall_veto_distance),
      display_(node),
      diagnostics_(node, private_node, {record_, detectors_, removal_, veto_, guard_}),
      scan_publisher_(node.advertise<sensor_msgs::LaserScan>("scan_scrubbed", kScanQueue)),
      reconfiguration_(private_node, options_,
                       [this](const LidarScrubberServerOptions& changed) { onOptions(changed); }) {
  detectors_.restart(ros_common::rosNow());
  for (const std::string& topic : options_.detection_topics) {
    detection_subscribers_.push_back(std::make_unique<DetectionSubscriber>(
        node, topic, [this](scrubbing::DetectionSet set) { onDetections(std::move(set)); },
        [this, topic](const std::string& reason) {
          guard_.run("bad detections", [&] { onBadDetections(topic, reason); });
        }));
  }
  scan_subscriber_ = node.subscribe<sensor_msgs::LaserScan>(
      "scan", kScanQueue, [this](const sensor_msgs::LaserScanConstPtr& scan) { onScan(scan); });
  if (options_.waits()) {
    waiting_timer_ = node.createSteadyTimer(kWaitingPeriod, [this](const auto& /*event*/) {
      guard_.run("waiting scans", [this] { removal_.release(steadyNow()); });
    });
  }
}

void LidarScrubberServer::onScan(const sensor_msgs::LaserScanConstPtr& scan) {
  if (!guard_.run("scan", [&] { takeScan(scan); })) {
    handOnAsItIs(scan);
  }
}

void LidarScrubberServer::onDetections(scrubbing::DetectionSet set) {
  guard_.run("detections of " + set.source, [&] { takeDetections(std::move(set)); });
}

void LidarScrubberServer::onOptions(const LidarScrubberServerOptions& options) {
  options_ = checked(options);
  detectors_.setLimits(limitsOf(options_));
  removal_.setOptions(options_.scrubbing);
}

void LidarScrubberServer::takeScan(const sensor_msgs::LaserScanConstPtr& scan) {
  const scrubbing::Stamp now = ros_common::rosNow();
  if (record_.scans == 0) {
    detectors_.restart(now);
  }
  ++record_.scans;
  record_.last_scan = now;
  if (std::optional<scrubbing::RawScan> raw = usable(scan, now)) {
    removal_.scrub(std::move(*raw), steadyNow(),
                   [this, scan](const scrubbing::ScrubbedScan& scrubbed) { handOn(scan, scrubbed); });
  }
}

/// The scan when it makes sense.
std::optional<scrubbing::RawScan> LidarScrubberServer::usable(const sensor_msgs::LaserScanConstPtr& scan,
                                                              scrubbing::Stamp now) {
  try {
    scrubbing::RawScan raw = ros_common::rawScanOf(scan);
    if (const auto jump = removal_.onScan(raw)) {
      ROS_WARN_STREAM(*jump << ": the detections so far are forgotten");
      detectors_.restart(now);
    }
    return raw;
  } catch (const ros_common::MessageError& error) {
    ++record_.dropped;
    record_.last_problem = error.what();
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "scan dropped (" << record_.dropped << " so far): " << error.what());
    return std::nullopt;
  }
}

void LidarScrubberServer::takeDetections(scrubbing::DetectionSet set) {
  const scrubbing::Stamp now = ros_common::rosNow();
  scrubbing::DetectorRecord& record = detectors_.record(set.source);
  if (isFromTheFuture(record, set, now)) {
    return;
  }
  detectors_.onDetections(set, now);
  const scrubbing::Veto veto = veto_.at({set.frame, set.stamp});
  ++(veto ? record_.with_veto : record_.without_veto);
  const std::string source = set.source;
  const scrubbing::AddedDetections added = removal_.add(std::move(set), veto);
  if (added.left_out.not_finite + added.left_out.too_many > 0) {
    ROS_WARN_STREAM_THROTTLE(
        kWarningPeriod, source << ": left out " << added.left_out.not_finite
                               << " detections without a finite position within 10 km and " << added.left_out.too_many
                               << " beyond max_detections = " << options_.scrubbing.limits.max_detections);
  }
  record.left_out += added.left_out.total();
  record.on_walls += added.vetoed;
  record.detections += added.used;
  removal_.release(steadyNow());
}

bool LidarScrubberServer::isFromTheFuture(scrubbing::DetectorRecord& record, const scrubbing::DetectionSet& set,
                                          scrubbing::Stamp now) {
  if (record_.last_scan == scrubbing::Stamp(0)) {
    return false;
  }
  record.last_delay = scrubbing::seconds(removal_.newestScan() - set.stamp);
  const double latest = scrubbing::seconds(now - record_.last_scan) + kMaxFuture;  // [s] after the newest scan
  if (-record.last_delay <= latest) {
    return false;
  }
  onBadDetections(set.source, "a stamp lies " + std::to_string(-record.last_delay) +
                                  " s after the newest scan's, expected at most " + std::to_string(latest) + " s");
  return true;
}

void LidarScrubberServer::onBadDetections(const std::string& topic, const std::string& reason) {
  scrubbing::DetectorRecord& record = detectors_.record(topic);
  ++record.bad_messages;
  record.last_problem = reason;
  ROS_ERROR_STREAM_THROTTLE(
      kWarningPeriod, topic << ": detections dropped (" << record.bad_messages << " messages so far): " << reason);
}

void LidarScrubberServer::handOn(const sensor_msgs::LaserScanConstPtr& scan, const scrubbing::ScrubbedScan& scrubbed) {
  bool is_settled = false;
  guard_.run("scrubbed scan", [&] {
    const scrubbing::Stamp now = ros_common::rosNow();
    record_.timed_out += scrubbed.answered ? 0 : 1;
    detectors_.onScan(ros_common::stampOf(scan->header.stamp), now);
    if (!isWithheld(scrubbed, now)) {
      scan_publisher_.publish(ros_common::scrubbedMessage(scan, scrubbed.removal));
    }
    is_settled = true;
    tellOf(scan, scrubbed);
  });
  if (!is_settled) {
    handOnAsItIs(scan);
  }
}

bool LidarScrubberServer::isWithheld(const scrubbing::ScrubbedScan& scrubbed, scrubbing::Stamp now) {
  if (!scrubbed.failure.empty()) {
    guard_.fail("scan", scrubbed.failure);
  }
  if (options_.on_silence != "drop") {
    return false;
  }
  if (!scrubbed.failure.empty()) {
    withhold("it could not be scrubbed");
    return true;
  }
  const std::vector<std::string> useless = detectors_.uselessTopics(now);
  if (useless.empty()) {
    return false;
  }
  withhold("nothing comes on " + useless.front() + ", or all of it too late,");
  return true;
}

/// For a scan with which something went wrong.
void LidarScrubberServer::handOnAsItIs(const sensor_msgs::LaserScanConstPtr& scan) {
  guard_.run("scan as it is", [&] {
    if (options_.on_silence == "drop") {
      withhold("it could not be scrubbed");
    } else {
      scan_publisher_.publish(scan);
    }
  });
}

void LidarScrubberServer::withhold(const std::string& reason) {
  ++record_.withheld;
  ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "scan withheld (" << record_.withheld << " so far), since " << reason
                                                             << " and ~on_silence is drop");
}

void LidarScrubberServer::tellOf(const sensor_msgs::LaserScanConstPtr& scan, const scrubbing::ScrubbedScan& scrubbed) {
  const scrubbing::RangeRemoval& removal = scrubbed.removal;
  record_.last_removed = removal.removed.size();
  record_.removed_beams += static_cast<std::int64_t>(removal.removed.size());
  tellOfPaths();
  if (scrubbed.tooMany()) {
    ++record_.too_much;
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "scan passed as it is ("
                                                 << record_.too_much << " so far): " << removal.near_people << " of "
                                                 << removal.points << " points are near people, expected at most "
                                                 << options_.scrubbing.max_removed_fraction
                                                 << " of them (max_removed_fraction)");
  }
  if (scrubbed.failure.empty()) {
    display_.show(scan->header, removal_.scrubber(), removal.removed, removal_.discs());
  }
}

void LidarScrubberServer::tellOfPaths() {
  const scrubbing::PeopleRemoval::PathCounts before = std::exchange(record_.paths, removal_.paths());
  const auto taken = [&](scrubbing::PosePath path) {
    const auto index = static_cast<std::size_t>(path);
    return record_.paths[index] > before[index];
  };
  if (taken(scrubbing::PosePath::kNone)) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "detections in frame " << removal_.unknownFrame()
                                                                    << " are not used, since tf does not connect it "
                                                                       "with the frame of the scans");
  }
  if (taken(scrubbing::PosePath::kSensorFrame) && !options_.fixed_frame.empty()) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "tf does not know the laser in " << options_.fixed_frame
                                                                              << " at the stamps of the scans: "
                                                                                 "detections are used as if the robot "
                                                                                 "stood still");
  }
}

}  // namespace map_matcher::ros_scrubbing
