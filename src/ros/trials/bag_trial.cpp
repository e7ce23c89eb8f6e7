#include "map_matcher/ros/trials/bag_trial.hpp"

#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <optional>
#include <utility>

#include "map_matcher/ros/bags/bag_detections.hpp"
#include "map_matcher/ros/bags/bag_scan_queue.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"
#include "map_matcher/ros/trials/bag_truth.hpp"
#include "map_matcher/trials/simulated_trial.hpp"

namespace map_matcher::ros_trials {
namespace {

constexpr double kWayAhead = 1.5;  // [s] of the robot's way that people know
constexpr double kWayStep = 0.5;   // [s]

class BagTrial {
 public:
  BagTrial(const BagTrialRequest& request, trials::Trial& trial, simulation::InsertedCrowd* crowd)
      : request_(request), trial_(trial), crowd_(crowd) {
    ros_bags::openBag(bag_, request.bag);
    const ros_bags::BagTopics topics = ros_bags::topicsOf(bag_);
    scan_topic_ = ros_bags::chooseScanTopic(request.bag, topics, request.scan_topic);
    detections_.emplace(request.bag, topics, request.detection_topics);
    ros_bags::requireTransforms(request.bag, topics, request.odom_frame);
    truth_ = readTruth(bag_, request.bag,
                       {request.truth_topic, request.truth_frame, {request.odom_frame, request.base_frame}});
  }

  BagTrialResult run() {
    ros_bags::BagScanQueue queue(
        bag_, request_.bag, [&](const sensor_msgs::LaserScan& scan, std::size_t /*laser*/) { play(scan, queue.tf()); });
    rosbag::View view(bag_);
    ros_bags::forEachMessage(bag_, view, [&](const rosbag::MessageInstance& message) {
      if (message.getTopic() == scan_topic_) {
        ++result_.scans;
        queue.addScan(message);
      } else if (detections_->has(message)) {
        takeDetections(message);
      }
      queue.read(message);
    });
    queue.finish();
    result_.scans_left_out = queue.withoutTransforms() + queue.refused();
    result_.detections_left_out = detections_->leftOut();
    result_.last_problem = queue.lastProblem().empty() ? detections_->lastProblem() : queue.lastProblem();
    if (result_.scans == result_.scans_left_out) {
      throw ros_bags::BagError("bag '" + request_.bag + "': none of the " + std::to_string(result_.scans) +
                               " scans of " + scan_topic_ + " could be used: " + result_.last_problem);
    }
    return result_;
  }

 private:
  void takeDetections(const rosbag::MessageInstance& message) {
    if (const std::optional<scrubbing::DetectionSet> set = detections_->read(message)) {
      trial_.add(
          trials::TrialDetections{scrubbing::seconds(set->stamp), message.getTime().toSec(), 0, set->detections});
    }
  }

  void play(const sensor_msgs::LaserScan& message, const tf2::BufferCore& tf) {
    const ros::Time stamp = message.header.stamp;
    const auto odometry = tf.lookupTransform(ros_common::frameName(request_.odom_frame),
                                             ros_common::frameName(request_.base_frame), stamp);
    const auto mount =
        tf.lookupTransform(ros_common::frameName(request_.base_frame), ros_common::frameOf(message.header), stamp);
    trials::TrialStep step;
    step.time = stamp.toSec();
    step.T_odom_base = ros_common::projectToPlane(odometry.transform, "the odometry");
    step.truth = truth_ ? truth_->at(step.time) : std::nullopt;
    step.scans.push_back({ros_common::fromMessage(message), ros_common::laserMountFrom(mount.transform)});
    const std::optional<simulation::DetectedPeople> detections = insertPeople(step);
    if (detections) {
      trial_.add(trials::trialDetectionsOf(*detections, 0));
    }
    trial_.add(step);
  }

  /// Puts the crowd into the scan, where the truth tells how the robot stands to it.
  std::optional<simulation::DetectedPeople> insertPeople(trials::TrialStep& step) {
    if (crowd_ == nullptr) {
      return std::nullopt;
    }
    if (!step.truth) {
      ++result_.scans_without_people;
      return std::nullopt;
    }
    std::vector<grid::Rigid2> way{*step.truth};
    for (double ahead = kWayStep; ahead <= kWayAhead; ahead += kWayStep) {
      if (const auto pose = truth_->at(step.time + ahead)) {
        way.push_back(*pose);
      }
    }
    crowd_->moveOn(step.time, way);
    simulation::CrowdedScan crowded = crowd_->among(step.scans.front());
    step.scans.front().scan = std::move(crowded.scan);
    return crowded.detections;
  }

  const BagTrialRequest& request_;
  trials::Trial& trial_;
  simulation::InsertedCrowd* crowd_;  // may be null
  rosbag::Bag bag_;
  std::string scan_topic_;
  std::optional<ros_bags::BagDetections> detections_;
  std::optional<BagTruth> truth_;
  BagTrialResult result_;
};

}  // namespace

BagTrialResult playBag(const BagTrialRequest& request, trials::Trial& trial, simulation::InsertedCrowd* crowd) {
  if (crowd != nullptr && request.truth_topic.empty()) {
    throw ros_bags::BagError("people are to be inserted into the scans of bag '" + request.bag +
                             "', which takes its topic of true poses");
  }
  return BagTrial(request, trial, crowd).run();
}

}  // namespace map_matcher::ros_trials
