#include "map_matcher/ros/bag_trial.hpp"

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <map_matcher/PersonDetections.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <deque>
#include <map>

#include "map_matcher/ros/conversions.hpp"
#include "map_matcher/ros/detection_messages.hpp"
#include "map_matcher/ros/scan_conversions.hpp"

namespace map_matcher {
namespace {

const ros::Duration kTfPatience(1.0);  // how long after a scan its transforms may come
const ros::Duration kTfHistory(30.0);  // transforms kept
constexpr double kMaxTruthGap = 10.0;  // [s] between two true poses that are interpolated

class BagTrial {
 public:
  BagTrial(const BagTrialRequest& request, Trial& trial) : request_(request), trial_(trial), tf_(kTfHistory) {
    openBag(bag_, request.bag);
    const BagTopics topics = topicsOf(bag_);
    scan_topic_ = chooseScanTopic(request.bag, topics, request.scan_topic);
    for (const std::string& topic : request.detection_topics) {
      detection_topics_.push_back(chooseTopic(request.bag, topics, topic));
    }
    if (!request.truth_topic.empty()) {
      readTruth(chooseTopic(request.bag, topics, request.truth_topic));
    }
  }

  BagTrialResult run() {
    takeStaticTransforms(bag_, tf_);
    rosbag::View view(bag_);
    for (const rosbag::MessageInstance& message : view) {
      take(message);
      drain(message.getTime() - kTfPatience);
    }
    drain(ros::TIME_MAX);
    if (result_.scans == result_.scans_left_out) {
      throw BagError("bag '" + request_.bag + "': none of the " + std::to_string(result_.scans) + " scans of " +
                     scan_topic_ + " could be used: " + result_.last_problem);
    }
    return result_;
  }

 private:
  struct Waiting {
    sensor_msgs::LaserScanConstPtr scan;
    ros::Time recorded;
  };

  void readTruth(const std::string& topic) {
    rosbag::View view(bag_, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& message : view) {
      if (const auto pose = message.instantiate<geometry_msgs::PoseStamped>()) {
        truth_[pose->header.stamp.toSec()] = fromMessage(pose->pose, "the true pose");
      }
    }
    if (truth_.empty()) {
      throw BagError("topic '" + topic + "' of bag '" + request_.bag + "' holds no geometry_msgs/PoseStamped");
    }
  }

  void take(const rosbag::MessageInstance& message) {
    const std::string& topic = message.getTopic();
    if (topic == "/tf") {
      if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
        takeTransforms(*transforms, false, tf_);
      }
    } else if (topic == scan_topic_) {
      ++result_.scans;
      queue_.push_back({message.instantiate<sensor_msgs::LaserScan>(), message.getTime()});
    } else if (std::find(detection_topics_.begin(), detection_topics_.end(), topic) != detection_topics_.end()) {
      takeDetections(message);
    }
  }

  void takeDetections(const rosbag::MessageInstance& message) {
    DetectionSet set;
    if (const auto poses = message.instantiate<geometry_msgs::PoseArray>()) {
      set = fromMessage(*poses, message.getTopic());
    } else if (const auto scored = message.instantiate<PersonDetections>()) {
      set = fromMessage(*scored, message.getTopic());
    }
    trial_.add(TrialDetections{seconds(set.stamp), message.getTime().toSec(), 0, set.detections});
  }

  void drain(const ros::Time& deadline) {
    for (; !queue_.empty(); queue_.pop_front()) {
      try {
        play(*queue_.front().scan);
      } catch (const tf2::TransformException& error) {
        if (queue_.front().recorded >= deadline) {
          return;
        }
        leaveOut(error);
      } catch (const std::runtime_error& error) {
        leaveOut(error);
      }
    }
  }

  void leaveOut(const std::exception& error) {
    ++result_.scans_left_out;
    result_.last_problem = error.what();
  }

  void play(const sensor_msgs::LaserScan& message) {
    const ros::Time stamp = message.header.stamp;
    const auto odometry = tf_.lookupTransform(frameName(request_.odom_frame), frameName(request_.base_frame), stamp);
    const auto mount = tf_.lookupTransform(frameName(request_.base_frame), frameOf(message.header), stamp);
    TrialStep step;
    step.time = stamp.toSec();
    step.T_odom_base = projectToPlane(odometry.transform, "the odometry");
    step.truth = truthAt(step.time);
    step.scans.push_back({fromMessage(message), laserMountFrom(mount.transform)});
    trial_.add(step);
  }

  /// Between the two nearest true poses.
  std::optional<Rigid2> truthAt(double time) const {
    const auto after = truth_.lower_bound(time);
    if (after == truth_.end() || (after == truth_.begin() && after->first > time)) {
      return std::nullopt;
    }
    if (after->first == time) {
      return after->second;
    }
    const auto before = std::prev(after);
    const double gap = after->first - before->first;
    if (gap > kMaxTruthGap) {
      return std::nullopt;
    }
    const double part = (time - before->first) / gap;
    const Rigid2 T = before->second.inverse() * after->second;
    return before->second * Rigid2{part * T.x, part * T.y, part * T.yaw};
  }

  const BagTrialRequest& request_;
  Trial& trial_;
  rosbag::Bag bag_;
  std::string scan_topic_;
  std::vector<std::string> detection_topics_;
  std::map<double, Rigid2> truth_;  // by the stamp [s]
  tf2::BufferCore tf_;
  std::deque<Waiting> queue_;
  BagTrialResult result_;
};

}  // namespace

BagTrialResult playBag(const BagTrialRequest& request, Trial& trial) { return BagTrial(request, trial).run(); }

}  // namespace map_matcher
