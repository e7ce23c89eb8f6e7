#include "map_matcher/ros/trials/bag_session_maps.hpp"

#include <nav_msgs/OccupancyGrid.h>
#include <rosbag/view.h>
#include <tf2/exceptions.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "map_matcher/ros/bags/bag_transforms.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/scan_conversions.hpp"
#include "map_matcher/ros/trials/bag_truth.hpp"

namespace map_matcher::ros_trials {
namespace {

constexpr const char* kMapType = "nav_msgs/OccupancyGrid";
constexpr double kOdometryStep = 0.2;  // [s] at which the way driven is measured

ros::Duration lengthOf(const rosbag::Bag& bag) {
  rosbag::View view(bag);
  return view.getEndTime() - view.getBeginTime();
}

class BagSessionMaps {
 public:
  BagSessionMaps(const BagSessionMapsRequest& request, trials::SessionMatching& matching)
      : request_(request), matching_(matching) {
    ros_bags::openBag(bag_, request.bag);
    const ros_bags::BagTopics topics = ros_bags::topicsOf(bag_);
    map_topic_ = ros_bags::chooseTopic(request.bag, topics, request.map_topic, {kMapType});
    ros_bags::requireTransforms(request.bag, topics, request.odom_frame);
    truth_ = readTruth(bag_, request.bag,
                       {request.truth_topic, request.truth_frame, {request.odom_frame, request.base_frame}});
  }

  BagSessionMapsResult run() {
    readTransforms();
    rosbag::View view(bag_, rosbag::TopicQuery(map_topic_));
    ros_bags::forEachMessage(bag_, view, [this](const rosbag::MessageInstance& message) {
      ++result_.maps;
      try {
        match(*ros_bags::readMessage<nav_msgs::OccupancyGrid>(request_.bag, message));
      } catch (const ros_common::MessageError& error) {
        leaveOut(error.what());
      } catch (const tf2::TransformException& error) {
        leaveOut(error.what());
      }
    });
    if (result_.maps == result_.maps_left_out) {
      throw ros_bags::BagError("bag '" + request_.bag + "': none of the " + std::to_string(result_.maps) + " maps of " +
                               map_topic_ + " could be used: " + result_.last_problem);
    }
    return result_;
  }

 private:
  /// All of them at once: those that belong to a map may be recorded after it.
  void readTransforms() {
    tf_.emplace(lengthOf(bag_) + ros::Duration(10.0));
    tf_->takeStatic(bag_);
    rosbag::View view(bag_, rosbag::TopicQuery(std::string("/tf")));
    ros_bags::forEachMessage(bag_, view, [this](const rosbag::MessageInstance& message) {
      if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
        tf_->take(*transforms);
        for (const geometry_msgs::TransformStamped& transform : transforms->transforms) {
          stamps_.insert(transform.header.stamp);
        }
      }
    });
  }

  void leaveOut(const std::string& problem) {
    ++result_.maps_left_out;
    result_.last_problem = problem;
  }

  grid::Rigid2 poseOfBase(const std::string& frame, const ros::Time& stamp) const {
    return ros_common::projectToPlane(
        tf_->buffer()
            .lookupTransform(ros_common::frameName(frame), ros_common::frameName(request_.base_frame), stamp)
            .transform,
        "the pose of " + request_.base_frame + " in " + frame);
  }

  void match(const nav_msgs::OccupancyGrid& message) {
    const ros::Time stamp = message.header.stamp;
    grid::OccupancyGrid map = ros_common::fromMessage(message);
    trials::TrialQuery query;
    query.T_session_base = poseOfBase(ros_common::frameOf(message.header), stamp);
    if (!first_) {
      true_alignment_ = alignmentAtTheBegin(ros_common::frameOf(message.header));
    }
    driveTo(stamp);
    query.time = stamp.toSec();
    query.session_age = (stamp - *first_).toSec();
    query.travelled = travelled_;
    query.truth = truth_ ? truth_->at(query.time) : std::nullopt;
    query.true_alignment = true_alignment_;
    matching_.match(std::move(map), std::move(query));
  }

  /// T_reference_session where tf first knows the robot in the session frame, before the mapper has drifted.
  std::optional<grid::Rigid2> alignmentAtTheBegin(const std::string& session_frame) const {
    for (const ros::Time& stamp : stamps_) {
      const std::optional<grid::Rigid2> truth = truth_ ? truth_->at(stamp.toSec()) : std::nullopt;
      if (truth && tf_->buffer().canTransform(session_frame, ros_common::frameName(request_.base_frame), stamp)) {
        return *truth * poseOfBase(session_frame, stamp).inverse();
      }
    }
    return std::nullopt;
  }

  /// Follows the odometry from where it was at the map before.
  void driveTo(const ros::Time& stamp) {
    if (!first_) {
      first_ = stamp;
      driven_until_ = stamp;
      last_odometry_ = poseOfBase(request_.odom_frame, stamp);
    }
    while (driven_until_ < stamp) {
      driven_until_ = std::min(stamp, driven_until_ + ros::Duration(kOdometryStep));
      const grid::Rigid2 odometry = poseOfBase(request_.odom_frame, driven_until_);
      travelled_ += (odometry.translation() - last_odometry_.translation()).norm();
      last_odometry_ = odometry;
    }
  }

  const BagSessionMapsRequest& request_;
  trials::SessionMatching& matching_;
  rosbag::Bag bag_;
  std::string map_topic_;
  std::optional<BagTruth> truth_;
  std::optional<ros_bags::BagTransforms> tf_;
  std::optional<ros::Time> first_;  // stamp of the first map
  ros::Time driven_until_;
  grid::Rigid2 last_odometry_;
  double travelled_ = 0.0;
  std::set<ros::Time> stamps_;                  // of all transforms
  std::optional<grid::Rigid2> true_alignment_;  // of the session, where it is known
  BagSessionMapsResult result_;
};

}  // namespace

BagSessionMapsResult matchSessionMaps(const BagSessionMapsRequest& request, trials::SessionMatching& matching) {
  return BagSessionMaps(request, matching).run();
}

}  // namespace map_matcher::ros_trials
