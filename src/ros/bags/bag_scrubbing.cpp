#include "map_matcher/ros/bags/bag_scrubbing.hpp"

#include <geometry_msgs/PoseArray.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "map_matcher/ros/bags/bag_detections.hpp"
#include "map_matcher/ros/bags/bag_transforms.hpp"
#include "map_matcher/ros/bags/bag_writing.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/detection_messages.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"
#include "map_matcher/ros/common/tf_transforms.hpp"

namespace map_matcher::ros_bags {
namespace {

std::vector<bool> marked(const std::vector<std::uint32_t>& beams, std::size_t num_beams) {
  std::vector<bool> marks(num_beams, false);
  for (const std::uint32_t beam : beams) {
    marks[beam] = true;
  }
  return marks;
}

/// Goes through a bag once, as the lidar_scrubber would have when it was recorded.
class BagScrubbing {
 public:
  explicit BagScrubbing(const BagScrubbingRequest& request)
      : request_(request),
        transforms_(tf_.buffer()),
        poses_(transforms_, ros_common::frameName(request.options.fixed_frame)),
        removal_(
            request.options.scrubbing,
            [this](const scrubbing::FrameAt& set, const scrubbing::FrameAt& scan) { return poses_.lookUp(set, scan); },
            request.options.waits() ? std::optional<double>(request.options.sync_timeout) : std::nullopt) {
    openBag(bag_, request.bag);
    const BagTopics topics = topicsOf(bag_);
    result_.scan_topic = chooseScanTopic(request.bag, topics, request.scan_topic);
    detections_.emplace(request.bag, topics, request.options.detection_topics);
    if (!request.people_topic.empty()) {
      readPeople(chooseTopic(request.bag, topics, request.people_topic, {"geometry_msgs/PoseArray"}));
    }
    if (!request.output.empty()) {
      openOutput(topics);
    }
  }

  BagScrubbingResult run() {
    tf_.takeStatic(bag_);
    rosbag::View view(bag_);
    forEachMessage(bag_, view, [this](const rosbag::MessageInstance& message) {
      copy(message);
      now_ = message.getTime();
      const std::string& topic = message.getTopic();
      if (topic == "/tf") {
        onTransforms(message);
      } else if (topic == result_.scan_topic) {
        onScan(message);
      } else if (detections_->has(message)) {
        onDetections(message);
      }
      removal_.release(ros_common::stampOf(now_));
    });
    now_ = ros::TIME_MAX;
    removal_.release(ros_common::stampOf(now_));
    if (result_.last_problem.empty()) {
      result_.last_problem = detections_->lastProblem();
    }
    if (output_) {
      output_->close();
    }
    result_.paths = removal_.paths();
    return result_;
  }

 private:
  void readPeople(const std::string& topic) {
    rosbag::View view(bag_, rosbag::TopicQuery(topic));
    forEachMessage(bag_, view, [&](const rosbag::MessageInstance& message) {
      const scrubbing::DetectionSet set =
          ros_common::fromMessage(*readMessage<geometry_msgs::PoseArray>(request_.bag, message), topic);
      if (!set.detections.empty()) {
        people_[set.stamp] = set;
      }
    });
    if (people_.empty()) {
      throw BagError("topic '" + topic + "' of bag '" + request_.bag + "' shows nobody, expected people");
    }
  }

  void openOutput(const BagTopics& topics) {
    if (topics.count(request_.scrubbed_topic) > 0) {
      throw BagError("bag '" + request_.bag + "' has a topic '" + request_.scrubbed_topic +
                     "' already, expected another name for the scrubbed scans");
    }
    if (files::isSameFile(request_.output, request_.bag)) {
      throw BagError("the output is '" + request_.output + "', the bag itself, expected another file");
    }
    output_.emplace(request_.output, rosbag::compression::LZ4);
  }

  void copy(const rosbag::MessageInstance& message) {
    if (output_) {
      output_->copy(message);
    }
  }

  void onTransforms(const rosbag::MessageInstance& message) {
    if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
      tf_.take(*transforms);
    }
  }

  void onDetections(const rosbag::MessageInstance& message) {
    if (std::optional<scrubbing::DetectionSet> set = detections_->read(message)) {
      result_.detections += removal_.add(std::move(*set)).used;
    }
  }

  void onScan(const rosbag::MessageInstance& message) {
    const sensor_msgs::LaserScanConstPtr scan = readMessage<sensor_msgs::LaserScan>(request_.bag, message);
    ++result_.scans;
    try {
      scrubbing::RawScan raw = ros_common::rawScanOf(scan);
      if (const auto jump = removal_.onScan(raw)) {
        result_.last_problem = *jump;
      }
      // Messages in a bag's order never go back in time, as the clock that scans wait by must not.
      removal_.scrub(std::move(raw), ros_common::stampOf(now_),
                     [this, scan](const scrubbing::ScrubbedScan& scrubbed) { handOn(scan, scrubbed); });
    } catch (const ros_common::MessageError& error) {
      ++result_.scans_dropped;
      result_.last_problem = error.what();
    }
  }

  void handOn(const sensor_msgs::LaserScanConstPtr& scan, const scrubbing::ScrubbedScan& scrubbed) {
    const scrubbing::RangeRemoval& removal = scrubbed.removal;
    result_.scans_timed_out += scrubbed.answered ? 0 : 1;
    result_.scans_changed += removal.removed.empty() ? 0 : 1;
    result_.scans_too_much += scrubbed.tooMany() ? 1 : 0;
    result_.points += removal.points;
    result_.removed += static_cast<std::int64_t>(removal.removed.size());
    if (scrubbed.failure.empty()) {
      count(*scan, removal);
    } else {
      result_.last_problem = scrubbed.failure;
    }
    if (output_) {
      output_->write(request_.scrubbed_topic, timeOf(*scan), ros_common::scrubbedMessage(scan, removal));
    }
  }

  /// When the lidar_scrubber would have handed the scan on.
  ros::Time timeOf(const sensor_msgs::LaserScan& scan) const {
    if (!request_.options.waits()) {
      return now_;
    }
    const scrubbing::Stamp latest =
        ros_common::stampOf(scan.header.stamp) + scrubbing::fromSeconds(request_.options.sync_timeout);
    return std::min(now_, ros_common::rosTimeOf(latest).value_or(now_));
  }

  /// Compares with the people that were really there, where somebody knows.
  void count(const sensor_msgs::LaserScan& scan, const scrubbing::RangeRemoval& removal) {
    const auto found = people_.find(ros_common::stampOf(scan.header.stamp));
    if (found == people_.end() || found->second.frame != ros_common::frameOf(scan.header)) {
      return;
    }
    std::vector<scrubbing::Disc> discs;
    for (const scrubbing::Detection& person : found->second.detections) {
      discs.push_back({person.position.head<2>(), request_.options.scrubbing.cache.removal_radius});
    }
    scrubbing::ScanScrubber truth;
    const std::vector<std::uint32_t>& near_beams = truth.beamsInside(removal_.scrubber().layout(), scan.ranges, discs);
    const std::vector<bool> removed = marked(removal.removed, scan.ranges.size());
    const auto near = static_cast<std::int64_t>(near_beams.size());
    const auto near_removed = static_cast<std::int64_t>(
        std::count_if(near_beams.begin(), near_beams.end(), [&removed](std::uint32_t beam) { return removed[beam]; }));
    PeopleCount& people = result_.people;
    ++people.scans;
    people.people += static_cast<int>(discs.size());
    people.near += near;
    people.near_left += near - near_removed;
    people.others += removal.points - near;
    people.others_lost += static_cast<std::int64_t>(removal.removed.size()) - near_removed;
  }

  const BagScrubbingRequest& request_;
  rosbag::Bag bag_;
  std::optional<BagWriter> output_;
  std::optional<BagDetections> detections_;
  std::map<scrubbing::Stamp, scrubbing::DetectionSet> people_;
  BagTransforms tf_;
  ros_common::TfTransforms transforms_;
  scrubbing::DetectionPoses poses_;
  scrubbing::PeopleRemoval removal_;
  ros::Time now_;  // up to which the bag has been read
  BagScrubbingResult result_;
};

}  // namespace

BagScrubbingResult scrubBag(const BagScrubbingRequest& request) { return BagScrubbing(request).run(); }

}  // namespace map_matcher::ros_bags
