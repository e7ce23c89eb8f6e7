#include "map_matcher/ros/bag_trial.hpp"

#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "map_matcher/evaluation/simulated_trial.hpp"
#include "map_matcher/ros/bag_scan_queue.hpp"
#include "map_matcher/ros/bag_transforms.hpp"
#include "map_matcher/ros/bag_truth.hpp"
#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/scan_conversions.hpp"

namespace map_matcher {
namespace {

const ros::Duration kTfHistory(30.0);  // transforms kept
constexpr double kWayAhead = 1.5;      // [s] of the robot's way that people know
constexpr double kWayStep = 0.5;       // [s]

class BagTrial {
 public:
  BagTrial(const BagTrialRequest& request, Trial& trial, InsertedCrowd* crowd)
      : request_(request),
        trial_(trial),
        crowd_(crowd),
        tf_(kTfHistory),
        queue_([this](const sensor_msgs::LaserScan& scan) { play(scan); }) {
    openBag(bag_, request.bag);
    const BagTopics topics = topicsOf(bag_);
    scan_topic_ = chooseScanTopic(request.bag, topics, request.scan_topic);
    detection_topics_ = chooseDetectionTopics(request.bag, topics, request.detection_topics);
    requireTransforms(request.bag, topics, request.odom_frame);
    truth_ = readTruth(bag_, request.bag,
                       {request.truth_topic, request.truth_frame, {request.odom_frame, request.base_frame}});
  }

  BagTrialResult run() {
    tf_.takeStatic(bag_);
    rosbag::View view(bag_);
    forEachMessage(bag_, view, [this](const rosbag::MessageInstance& message) {
      take(message);
      queue_.release(message.getTime());
    });
    queue_.releaseAll();
    result_.scans_left_out = queue_.withoutTransforms() + queue_.refused();
    if (!queue_.lastProblem().empty()) {
      result_.last_problem = queue_.lastProblem();
    }
    if (result_.scans == result_.scans_left_out) {
      throw BagError("bag '" + request_.bag + "': none of the " + std::to_string(result_.scans) + " scans of " +
                     scan_topic_ + " could be used: " + result_.last_problem);
    }
    return result_;
  }

 private:
  void take(const rosbag::MessageInstance& message) {
    const std::string& topic = message.getTopic();
    if (topic == "/tf") {
      if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
        tf_.take(*transforms);
      }
    } else if (topic == scan_topic_) {
      ++result_.scans;
      queue_.add(message.instantiate<sensor_msgs::LaserScan>(), message.getTime());
    } else if (std::find(detection_topics_.begin(), detection_topics_.end(), topic) != detection_topics_.end()) {
      takeDetections(message);
    }
  }

  void takeDetections(const rosbag::MessageInstance& message) {
    try {
      const DetectionSet set = readDetections(message);
      trial_.add(TrialDetections{seconds(set.stamp), message.getTime().toSec(), 0, set.detections});
    } catch (const MessageError& error) {
      ++result_.detections_left_out;
      result_.last_problem = error.what();
    }
  }

  void play(const sensor_msgs::LaserScan& message) {
    const ros::Time stamp = message.header.stamp;
    const auto odometry =
        tf_.buffer().lookupTransform(frameName(request_.odom_frame), frameName(request_.base_frame), stamp);
    const auto mount = tf_.buffer().lookupTransform(frameName(request_.base_frame), frameOf(message.header), stamp);
    TrialStep step;
    step.time = stamp.toSec();
    step.T_odom_base = projectToPlane(odometry.transform, "the odometry");
    step.truth = truth_ ? truth_->at(step.time) : std::nullopt;
    step.scans.push_back({fromMessage(message), laserMountFrom(mount.transform)});
    const std::optional<DetectedPeople> detections = insertPeople(step);
    if (detections) {
      trial_.add(trialDetectionsOf(*detections, 0));
    }
    trial_.add(step);
  }

  /// Puts the crowd into the scan, where the truth tells how the robot stands to it.
  std::optional<DetectedPeople> insertPeople(TrialStep& step) {
    if (crowd_ == nullptr) {
      return std::nullopt;
    }
    if (!step.truth) {
      ++result_.scans_without_people;
      return std::nullopt;
    }
    std::vector<Rigid2> way{*step.truth};
    for (double ahead = kWayStep; ahead <= kWayAhead; ahead += kWayStep) {
      if (const auto pose = truth_->at(step.time + ahead)) {
        way.push_back(*pose);
      }
    }
    crowd_->moveOn(step.time, way);
    CrowdedScan crowded = crowd_->among(step.scans.front());
    step.scans.front().scan = std::move(crowded.scan);
    return crowded.detections;
  }

  const BagTrialRequest& request_;
  Trial& trial_;
  InsertedCrowd* crowd_;  // may be null
  rosbag::Bag bag_;
  std::string scan_topic_;
  std::vector<std::string> detection_topics_;
  std::optional<BagTruth> truth_;
  BagTransforms tf_;
  BagScanQueue queue_;
  BagTrialResult result_;
};

}  // namespace

BagTrialResult playBag(const BagTrialRequest& request, Trial& trial, InsertedCrowd* crowd) {
  if (crowd != nullptr && request.truth_topic.empty()) {
    throw BagError("people are to be inserted into the scans of bag '" + request.bag +
                   "', which takes its topic of true poses");
  }
  return BagTrial(request, trial, crowd).run();
}

}  // namespace map_matcher
