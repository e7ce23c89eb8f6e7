#include "map_matcher/ros/bag_scrubbing.hpp"

#include <geometry_msgs/PoseArray.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <optional>

#include "map_matcher/ros/bag_transforms.hpp"
#include "map_matcher/ros/bag_writing.hpp"
#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/detection_messages.hpp"
#include "map_matcher/ros/waiting_scans.hpp"

namespace map_matcher {
namespace {

const ros::Duration kTfHistory(30.0);  // transforms kept

/// Times of a bag as times that never go back, which messages in a bag's order do not.
ros::SteadyTime steady(const ros::Time& time) { return {time.sec, time.nsec}; }

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
        tf_(kTfHistory),
        removal_(tf_.buffer(), request.options.fixed_frame, request.options.scrubbing),
        waiting_(ros::WallDuration(request.options.sync_timeout)) {
    openBag(bag_, request.bag);
    const BagTopics topics = topicsOf(bag_);
    result_.scan_topic = chooseScanTopic(request.bag, topics, request.scan_topic);
    detection_topics_ = chooseDetectionTopics(request.bag, topics, request.options.detection_topics);
    if (!request.people_topic.empty()) {
      readPeople(chooseTopic(request.bag, topics, request.people_topic));
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
      const std::string& topic = message.getTopic();
      if (topic == "/tf") {
        onTransforms(message);
      } else if (topic == result_.scan_topic) {
        onScan(message);
      } else if (std::find(detection_topics_.begin(), detection_topics_.end(), topic) != detection_topics_.end()) {
        onDetections(message);
      }
      release(message.getTime());
    });
    release(ros::TIME_MAX);
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
      if (const auto people = message.instantiate<geometry_msgs::PoseArray>()) {
        const DetectionSet set = fromMessage(*people, topic);
        if (!set.detections.empty()) {
          people_[set.stamp] = set;
        }
      }
    });
    if (people_.empty()) {
      throw BagError("topic '" + topic + "' of bag '" + request_.bag +
                     "' shows nobody, expected people in messages of geometry_msgs/PoseArray");
    }
  }

  void openOutput(const BagTopics& topics) {
    if (topics.count(request_.scrubbed_topic) > 0) {
      throw BagError("bag '" + request_.bag + "' has a topic '" + request_.scrubbed_topic +
                     "' already, expected another name for the scrubbed scans");
    }
    if (isSameFile(request_.output, request_.bag)) {
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
    try {
      DetectionSet set = readDetections(message);
      applyLimits(set, request_.options.scrubbing.limits);
      result_.detections += static_cast<std::int64_t>(set.detections.size());
      waiting_.onDetections(set.frame, set.stamp);
      removal_.add(std::move(set));
    } catch (const MessageError& error) {
      result_.last_problem = error.what();
    }
  }

  void onScan(const rosbag::MessageInstance& message) {
    const auto scan = message.instantiate<sensor_msgs::LaserScan>();
    ++result_.scans;
    try {
      if (const auto jump = removal_.onScan(*scan)) {
        result_.last_problem = *jump;
      }
    } catch (const MessageError& error) {
      ++result_.scans_dropped;
      result_.last_problem = error.what();
      return;
    }
    if (request_.options.mode == "synchronised") {
      waiting_.add(scan, steady(message.getTime()));
    } else {
      scrub(scan, message.getTime());
    }
  }

  void release(const ros::Time& now) {
    for (const WaitingScans::Released& released : waiting_.release(steady(now))) {
      result_.scans_timed_out += released.answered ? 0 : 1;
      scrub(released.scan, std::min(now, released.scan->header.stamp + ros::Duration(request_.options.sync_timeout)));
    }
  }

  void scrub(const sensor_msgs::LaserScanConstPtr& scan, const ros::Time& time) {
    const ScrubbedScan scrubbed = removal_.scrub(scan);
    result_.scans_changed += scrubbed.removed.empty() ? 0 : 1;
    result_.scans_too_much += scrubbed.tooMany() ? 1 : 0;
    result_.points += scrubbed.points;
    result_.removed += static_cast<std::int64_t>(scrubbed.removed.size());
    count(*scan, scrubbed);
    if (output_) {
      output_->write(request_.scrubbed_topic, time, scrubbed.scan);
    }
  }

  /// Compares with the people that were really there, where somebody knows.
  void count(const sensor_msgs::LaserScan& scan, const ScrubbedScan& scrubbed) {
    const auto found = people_.find(stampOf(scan.header.stamp));
    if (found == people_.end() || found->second.frame != frameOf(scan.header)) {
      return;
    }
    std::vector<Disc> discs;
    for (const Detection& person : found->second.detections) {
      discs.push_back({person.position.head<2>(), request_.options.scrubbing.cache.removal_radius});
    }
    ScanScrubber truth;
    const std::vector<std::uint32_t>& near_beams = truth.beamsInside(removal_.scrubber().layout(), scan.ranges, discs);
    const std::vector<bool> removed = marked(scrubbed.removed, scan.ranges.size());
    const auto near = static_cast<std::int64_t>(near_beams.size());
    const auto near_removed = static_cast<std::int64_t>(
        std::count_if(near_beams.begin(), near_beams.end(), [&removed](std::uint32_t beam) { return removed[beam]; }));
    PeopleCount& people = result_.people;
    ++people.scans;
    people.people += static_cast<int>(discs.size());
    people.near += near;
    people.near_left += near - near_removed;
    people.others += scrubbed.points - near;
    people.others_lost += static_cast<std::int64_t>(scrubbed.removed.size()) - near_removed;
  }

  const BagScrubbingRequest& request_;
  rosbag::Bag bag_;
  std::optional<BagWriter> output_;
  std::vector<std::string> detection_topics_;
  std::map<Stamp, DetectionSet> people_;
  BagTransforms tf_;
  PeopleRemoval removal_;
  WaitingScans waiting_;
  BagScrubbingResult result_;
};

}  // namespace

BagScrubbingResult scrubBag(const BagScrubbingRequest& request) { return BagScrubbing(request).run(); }

}  // namespace map_matcher
