#include "map_matcher/ros/mapping/session_mapper_server.hpp"

#include <ros/console.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "map_matcher/ros/common/conversions.hpp"

namespace map_matcher::ros_mapping {
namespace {

constexpr std::uint32_t kScanQueue = 10;
constexpr double kWarningPeriod = 5.0;        // [s]
const ros::WallDuration kWaitingPeriod(5.0);  // between two words about what is missing

void expectOther(const char* name, const std::string& value, const char* other_name, const std::string& other) {
  if (value.empty() || value == other) {
    throw std::invalid_argument("~" + std::string(name) + " is \"" + value + "\", expected a name other than ~" +
                                other_name + " = \"" + other + "\"");
  }
}

/// The options with the slashes of former times taken off; throws unless the three frames differ and there is a topic.
SessionMapperServerOptions checked(SessionMapperServerOptions options) {
  options.map_frame = ros_common::frameName(options.map_frame);
  options.mapping.odom_frame = ros_common::frameName(options.mapping.odom_frame);
  options.mapping.base_frame = ros_common::frameName(options.mapping.base_frame);
  expectOther("map_frame", options.map_frame, "odom_frame", options.mapping.odom_frame);
  expectOther("odom_frame", options.mapping.odom_frame, "base_frame", options.mapping.base_frame);
  expectOther("base_frame", options.mapping.base_frame, "map_frame", options.map_frame);
  if (options.scan_topics.empty()) {
    throw std::invalid_argument("~scan_topics is an empty list, expected at least one topic");
  }
  return options;
}

}  // namespace

SessionMapperServer::SessionMapperServer(ros::NodeHandle node, const ros::NodeHandle& /*private_node*/,
                                         const SessionMapperServerOptions& options)
    : options_(checked(options)),
      mapping_(options_.mapping),
      tf_listener_(tf_),
      map_publisher_(node.advertise<nav_msgs::OccupancyGrid>("map", 1, true)),
      metadata_publisher_(node.advertise<nav_msgs::MapMetaData>("map_metadata", 1, true)) {
  subscribe(node);
  map_service_ = node.advertiseService<nav_msgs::GetMap::Request, nav_msgs::GetMap::Response>(
      "dynamic_map", [this](auto& /*request*/, auto& response) { return onGetMap(response); });
  if (options_.transform_publish_period > 0.0) {
    tick_timer_ = node.createTimer(ros::Duration(options_.transform_publish_period),
                                   [this](const ros::TimerEvent& /*event*/) { onTick(); });
  }
  waiting_timer_ = node.createWallTimer(kWaitingPeriod, [this](const auto& /*event*/) { tellWhatIsMissing(); });
}

void SessionMapperServer::subscribe(ros::NodeHandle& node) {
  for (std::size_t i = 0; i < options_.scan_topics.size(); ++i) {
    lasers_.push_back(std::make_unique<Laser>());
    Laser& laser = *lasers_.back();
    laser.subscriber.subscribe(node, options_.scan_topics[i], kScanQueue);
    laser.filter = std::make_unique<ScanFilter>(laser.subscriber, tf_, options_.mapping.odom_frame, kScanQueue, node);
    laser.filter->setTargetFrames({options_.mapping.odom_frame, options_.mapping.base_frame});
    laser.filter->registerCallback(boost::function<void(const sensor_msgs::LaserScanConstPtr&)>(
        [this, i](const sensor_msgs::LaserScanConstPtr& scan) { onScan(i, scan); }));
  }
}

void SessionMapperServer::onScan(std::size_t laser, const sensor_msgs::LaserScanConstPtr& scan) {
  try {
    const MappingUpdate update = mapping_.addScan(*scan, tf_, laser);
    ++scans_taken_;
    ++lasers_[laser]->taken;
    tell(update);
    if (update.snapshot) {
      publish(*update.snapshot);
    }
  } catch (const std::runtime_error& error) {  // MessageError and tf2::TransformException
    ++scans_dropped_;
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "scan dropped (" << scans_dropped_ << " so far): " << error.what());
  }
}

bool SessionMapperServer::onGetMap(nav_msgs::GetMap::Response& response) const {
  const auto snapshot = mapping_.snapshot();
  if (!snapshot) {
    ROS_WARN("dynamic_map: there is no map before the first scan is drawn");
    return false;
  }
  response.map = messageOf(*snapshot);
  return true;
}

void SessionMapperServer::onTick() {
  const ros::Time now = ros::Time::now();
  const ros_common::RisingClock::Tick tick = clock_.tick(now);
  if (tick == ros_common::RisingClock::Tick::kWentBack && mapping_.mapper().hasMap()) {
    ROS_WARN("time went back: a new session begins");
    mapping_.beginNewSession();
    for (const std::unique_ptr<Laser>& laser : lasers_) {
      laser->filter->clear();
    }
  }
  if (tick != ros_common::RisingClock::Tick::kAdvanced || !mapping_.mapper().hasMap()) {
    return;
  }
  geometry_msgs::TransformStamped message;
  message.header.stamp = now + ros::Duration(options_.tf_delay);
  message.header.frame_id = options_.map_frame;
  message.child_frame_id = options_.mapping.odom_frame;
  message.transform = ros_common::toTransformMessage(mapping_.mapper().T_session_odom());
  tf_broadcaster_.sendTransform(message);
}

void SessionMapperServer::tellWhatIsMissing() {
  if (mapping_.mapper().hasMap()) {
    tellWhichLasersAreSilent();
    return;
  }
  if (scans_taken_ > 0) {
    ROS_INFO("waiting for a scan that shows walls");
    return;
  }
  for (const std::unique_ptr<Laser>& laser : lasers_) {
    const ros::Subscriber& subscriber = laser->subscriber.getSubscriber();
    if (subscriber.getNumPublishers() == 0) {
      ROS_INFO_STREAM("waiting for a publisher of " << subscriber.getTopic());
    } else {
      ROS_INFO_STREAM("waiting for a scan on " << subscriber.getTopic() << " and, at its stamp, tf "
                                               << options_.mapping.odom_frame << " <- " << options_.mapping.base_frame
                                               << " <- the laser");
    }
  }
}

void SessionMapperServer::tellWhichLasersAreSilent() {
  const ros::Time now = ros::Time::now();
  const bool time_stands = now - last_look_ < ros::Duration(0.5 * kWaitingPeriod.toSec());  // a bag that is held up
  last_look_ = now;
  if (time_stands) {
    return;
  }
  for (const std::unique_ptr<Laser>& laser : lasers_) {
    const bool silent = laser->taken == 0;
    const std::string& topic = laser->subscriber.getSubscriber().getTopic();
    if (silent && !laser->silent) {
      ROS_WARN_STREAM("no scan of " << topic << " could be used for " << kWaitingPeriod.toSec()
                                    << " s, expected scans and, at their stamps, tf " << options_.mapping.odom_frame
                                    << " <- " << options_.mapping.base_frame << " <- the laser: the map goes on "
                                    << (lasers_.size() > 1 ? "with what other lasers see" : "when they come"));
    } else if (!silent && laser->silent) {
      ROS_INFO_STREAM("scans of " << topic << " are drawn again");
    }
    laser->silent = silent;
    laser->taken = 0;
  }
}

void SessionMapperServer::tell(const MappingUpdate& update) const {
  if (update.new_session) {
    ROS_WARN("the stamps of the scans went back: a new session begins");
  }
  if (update.report.new_session) {
    ROS_WARN_STREAM(update.report.alarm);
  } else if (!update.report.alarm.empty()) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, update.report.alarm);
  }
  const mapping::ScanOutcome outcome = update.report.outcome;
  if (outcome == mapping::ScanOutcome::kNotFitting || outcome == mapping::ScanOutcome::kMapFull) {
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "scan not drawn: " << update.report.reason);
  }
}

void SessionMapperServer::publish(const SessionSnapshot& snapshot) {
  const nav_msgs::OccupancyGrid message = messageOf(snapshot);
  ROS_DEBUG_STREAM("map of " << message.info.width << " x " << message.info.height << " cells");
  map_publisher_.publish(message);
  metadata_publisher_.publish(message.info);
}

nav_msgs::OccupancyGrid SessionMapperServer::messageOf(const SessionSnapshot& snapshot) const {
  return ros_common::toMessage(snapshot.map, options_.map_frame, snapshot.stamp);
}

}  // namespace map_matcher::ros_mapping
