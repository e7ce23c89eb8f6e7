/// \file
/// The pose_evaluator node: how far the robot's pose on tf is from the truth.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <deque>
#include <optional>
#include <string>

#include "map_matcher/MapMatch.h"
#include "map_matcher/evaluation/run_record.hpp"
#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/ros/common/rising_clock.hpp"

namespace map_matcher::ros_evaluation {

/// Options of the pose_evaluator node.
struct PoseEvaluatorOptions {
  std::string map_frame = "map";              ///< tf frame of the reference map, whose coordinates the truth has.
  std::string session_frame = "session_map";  ///< tf frame of the session map.
  std::string base_frame = "base_link";       ///< tf frame of the robot.
  std::string truth_frame;                    ///< Frame that true poses must have in their header; empty: any.
  double transform_timeout = 1.0;             ///< [s] How long after a true pose its transform may come.
  std::string csv_file;                       ///< Path for a row for each true pose; empty: none.
  std::string summary_file;                   ///< Path for the figures as JSON, at the end; empty: none.
};

/// The parameters of the pose_evaluator node.
parameters::ParameterList parametersOf(PoseEvaluatorOptions& options);

/// Looks up map_frame <- base_frame on tf at the stamp of each message on `ground_truth` (geometry_msgs/PoseStamped),
/// writes both down (RunRecord), and sums up at its end: in the log, and in summary_file. The match ratio comes from
/// `map_match`. When time goes back (a bag in a loop), it sums up and begins anew.
class PoseEvaluatorServer {
 public:
  /// Throws RunRecordError when csv_file cannot be written.
  PoseEvaluatorServer(ros::NodeHandle node, const ros::NodeHandle& private_node, const PoseEvaluatorOptions& options);
  ~PoseEvaluatorServer();
  PoseEvaluatorServer(const PoseEvaluatorServer&) = delete;
  PoseEvaluatorServer& operator=(const PoseEvaluatorServer&) = delete;

 private:
  struct WaitingTruth {
    ros::Time stamp;
    grid::Rigid2 pose;
    std::optional<double> ratio;
  };

  void onTruth(const geometry_msgs::PoseStampedConstPtr& message);
  void onMatch(const MapMatchConstPtr& message);
  void onTick();
  void drainQueue(const ros::Time& now);
  std::optional<grid::Rigid2> lookUp(const std::string& child, const ros::Time& stamp) const;
  void sumUp();

  const PoseEvaluatorOptions options_;
  evaluation::RunRecord record_;
  std::deque<WaitingTruth> queue_;
  std::optional<double> ratio_;  // of the latest accepted match
  ros_common::RisingClock clock_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  ros::Subscriber truth_subscriber_;
  ros::Subscriber match_subscriber_;
  ros::WallTimer tick_timer_;
};

}  // namespace map_matcher::ros_evaluation
