#include "map_matcher/ros/merging/scan_merger_server.hpp"

#include <ros/console.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"

namespace map_matcher::ros_merging {
namespace {

using ros_common::diagnostics::kError;
using ros_common::diagnostics::kOk;
using ros_common::diagnostics::kWarn;

constexpr std::uint32_t kScanQueue = 10;
constexpr double kWarningPeriod = 5.0;        // [s]
const ros::WallDuration kWorkPeriod(0.02);    // between two looks whether what is waited for has come
const ros::WallDuration kWaitingPeriod(5.0);  // between two words about what is missing
constexpr double kLongestRevolution = 1.0;    // [s]

ScanMergerServerOptions checked(ScanMergerServerOptions options) {
  options.base_frame = ros_common::frameName(options.base_frame);
  options.fixed_frame = ros_common::frameName(options.fixed_frame);
  if (options.base_frame.empty() || options.fixed_frame.empty() || options.base_frame == options.fixed_frame) {
    throw std::invalid_argument("~fixed_frame is \"" + options.fixed_frame +
                                "\", expected a frame other than ~base_frame = \"" + options.base_frame + "\"");
  }
  if (options.scan_topics.empty()) {
    throw std::invalid_argument("~scan_topics is an empty list, expected at least one topic");
  }
  if (!(options.layout.range_max > options.layout.range_min)) {
    throw std::invalid_argument("~range_max is " + std::to_string(options.layout.range_max) +
                                ", expected above ~range_min = " + std::to_string(options.layout.range_min));
  }
  return options;
}

/// From the first beam to the last one.
ros::Duration revolutionOf(const sensor_msgs::LaserScan& scan) {
  const double revolution = static_cast<double>(scan.time_increment) * static_cast<double>(scan.ranges.size() - 1);
  if (!(revolution >= 0.0 && revolution <= kLongestRevolution)) {
    throw ros_common::MessageError("time_increment is " + std::to_string(scan.time_increment) + " s for " +
                                   std::to_string(scan.ranges.size()) + " beams, expected 0 to " +
                                   std::to_string(kLongestRevolution) + " s from the first to the last");
  }
  return ros::Duration(revolution);
}

}  // namespace

ScanMergerServer::ScanMergerServer(ros::NodeHandle node, const ros::NodeHandle& private_node,
                                   const ScanMergerServerOptions& options)
    : options_(checked(options)),
      sets_(options_.scan_topics.size(), options_.times),
      lasers_(options_.scan_topics.size()),
      tf_listener_(tf_, node),
      publisher_(node.advertise<sensor_msgs::LaserScan>("merged_scan", 10)),
      report_(node, private_node) {
  for (std::size_t i = 0; i < lasers_.size(); ++i) {
    subscribers_.push_back(
        node.subscribe<sensor_msgs::LaserScan>(options_.scan_topics[i], kScanQueue, [this, i](const ScanPtr& scan) {
          guard_.run("a scan of " + options_.scan_topics[i], [&] { onScan(i, scan); });
        }));
    report_.add("scans of " + options_.scan_topics[i], [this, i](auto& status) { reportLaser(i, status); });
  }
  report_.add("merged scans", [this](auto& status) { reportMerging(status); });
  work_timer_ = node.createWallTimer(
      kWorkPeriod, [this](const auto& /*event*/) { guard_.run("the merging of scans", [this] { work(); }); });
  waiting_timer_ = node.createWallTimer(kWaitingPeriod, [this](const auto& /*event*/) { tellWhatIsMissing(); });
}

void ScanMergerServer::onScan(std::size_t laser, const ScanPtr& scan) {
  ++lasers_[laser].scans;
  try {
    ros_common::checkLayout(*scan);
    revolutionOf(*scan);
  } catch (const ros_common::MessageError& error) {
    ++lasers_[laser].refused;
    lasers_[laser].last_problem = error.what();
    ROS_WARN_STREAM_THROTTLE(kWarningPeriod, "a scan of " << options_.scan_topics[laser] << " is left out ("
                                                          << lasers_[laser].refused << " so far): " << error.what());
    return;
  }
  if (sets_.add(laser, scan->header.stamp.toSec(), scan)) {
    ROS_WARN_STREAM("the stamps of the scans of " << options_.scan_topics[laser] << " went back: it begins anew");
    pending_.reset();
    for (Laser& other : lasers_) {
      other.last_merged = 0.0;
    }
  }
  work();
}

void ScanMergerServer::work() {
  while (true) {
    const double now = ros::Time::now().toSec();
    if (!pending_) {
      pending_ = sets_.next(now);
    }
    if (!pending_ || !merge(*pending_, now - pending_->stamp > 2.0 * options_.times.patience)) {
      return;
    }
    pending_.reset();
  }
}

/// Whether the set is done with; false: it waits for tf.
bool ScanMergerServer::merge(const Set& set, bool is_late) {
  const auto leading = std::find_if(set.scans.begin(), set.scans.end(), [&set](const auto& scan) {
    return scan && (*scan)->header.stamp.toSec() == set.stamp;
  });
  const sensor_msgs::LaserScan& leader = ***leading;
  std::vector<scan::MovingScan> scans;
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < lasers_.size(); ++i) {
    auto moving = set.scans[i] ? placed(**set.scans[i], leader.header.stamp) : std::nullopt;
    if (moving) {
      scans.push_back(std::move(*moving));
      parts.push_back(i);
    } else if (set.scans[i] && !is_late) {
      return false;
    } else if (set.scans[i]) {
      lasers_[i].last_problem = tf_problem_;
      ROS_WARN_STREAM_THROTTLE(kWarningPeriod,
                               "a scan of " << options_.scan_topics[i] << " is left out: " << tf_problem_);
    }
  }
  if (scans.empty()) {
    ++dropped_;
    return true;
  }
  for (const std::size_t laser : parts) {
    ++lasers_[laser].merged;
    lasers_[laser].last_merged = set.stamp;
  }
  scan::PlanarScan merged = scan::mergeScans(scans, options_.layout);
  const auto message = boost::make_shared<sensor_msgs::LaserScan>();
  message->header.stamp = leader.header.stamp;
  message->header.frame_id = options_.base_frame;
  message->angle_min = static_cast<float>(merged.angle_min);
  message->angle_increment = static_cast<float>(merged.angle_increment);
  message->angle_max = static_cast<float>(merged.angle_min + merged.angle_increment * (options_.layout.num_beams - 1));
  message->scan_time = leader.scan_time;
  message->range_min = static_cast<float>(merged.range_min);
  message->range_max = static_cast<float>(merged.range_max);
  message->ranges = std::move(merged.ranges);
  publisher_.publish(message);
  ++published_;
  tellOfSilence(set);
  return true;
}

/// The scan where its laser was, in base_frame at the time `target`; none where tf does not know it (yet).
std::optional<scan::MovingScan> ScanMergerServer::placed(const sensor_msgs::LaserScan& scan, const ros::Time& target) {
  const std::string frame = ros_common::frameName(scan.header.frame_id);
  const auto mount_at = [&](const ros::Time& stamp) {
    return ros_common::laserMountFrom(
        tf_.lookupTransform(options_.base_frame, target, frame, stamp, options_.fixed_frame).transform);
  };
  try {
    const scan::LaserMount first = mount_at(scan.header.stamp);
    const scan::LaserMount last = mount_at(scan.header.stamp + revolutionOf(scan));
    return scan::MovingScan{ros_common::fromMessage(scan), first.T_base_laser, last.T_base_laser, first.upside_down};
  } catch (const std::runtime_error& error) {  // MessageError and tf2::TransformException
    tf_problem_ = error.what();
    return std::nullopt;
  }
}

void ScanMergerServer::tellOfSilence(const Set& set) {
  for (std::size_t i = 0; i < lasers_.size(); ++i) {
    Laser& laser = lasers_[i];
    if (laser.last_merged == 0.0) {
      laser.last_merged = set.stamp;  // the beginning, from which its silence counts
    }
    const bool silent = set.stamp - laser.last_merged > options_.times.silence;
    if (silent && !laser.silent) {
      ROS_WARN_STREAM("no scan of " << options_.scan_topics[i] << " could be merged for " << options_.times.silence
                                    << " s, expected scans and, at their stamps, tf " << options_.fixed_frame << " <- "
                                    << options_.base_frame << " <- the laser: the others go on without it");
    } else if (!silent && laser.silent) {
      ROS_INFO_STREAM("scans of " << options_.scan_topics[i] << " are merged again");
    }
    laser.silent = silent;
  }
}

void ScanMergerServer::tellWhatIsMissing() {
  if (published_ > 0) {
    return;
  }
  for (const ros::Subscriber& subscriber : subscribers_) {
    if (subscriber.getNumPublishers() == 0) {
      ROS_INFO_STREAM("waiting for a publisher of " << subscriber.getTopic());
    } else {
      ROS_INFO_STREAM("waiting for a scan on " << subscriber.getTopic() << " and, at its stamp, tf "
                                               << options_.fixed_frame << " <- " << options_.base_frame
                                               << " <- the laser");
    }
  }
}

void ScanMergerServer::reportLaser(std::size_t laser, diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const Laser& record = lasers_[laser];
  if (record.scans == 0) {
    status.summary(kWarn, "no scan yet");
  } else if (record.merged == 0) {
    status.summary(kError,
                   "none of its scans could be merged: " +
                       (record.last_problem.empty() ? "they fit no other laser's in time" : record.last_problem));
  } else if (record.silent) {
    status.summary(kError, "silent: the merged scan goes on without it");
  } else {
    status.summary(kOk, "merged");
  }
  status.add("scans", record.scans);
  status.add("merged", record.merged);
  status.add("refused", record.refused);
  status.add("last problem", record.last_problem);
}

void ScanMergerServer::reportMerging(diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (published_ == published_at_last_report_) {
    status.summary(kWarn, published_ == 0 ? "none yet" : "none since the last report");
  } else {
    status.summary(kOk, "scans are merged");
  }
  published_at_last_report_ = published_;
  status.add("published", published_);
  status.add("dropped", dropped_);
  status.add("failures", guard_.failures());
  status.add("last failure", guard_.lastFailure());
}

}  // namespace map_matcher::ros_merging
