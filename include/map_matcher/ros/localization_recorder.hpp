/// \file
/// The localization_recorder node: how well the robot is localized, against a ground truth.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <map_matcher/MapMatch.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <deque>
#include <string>

#include "map_matcher/evaluation/localization_run.hpp"
#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher {

/// Options of the localization_recorder node. Their ranges stand in parametersOf().
struct LocalizationRecorderOptions {
  std::string directory;                 ///< Existing directory that the record is written into.
  std::string reference_frame = "map";   ///< Frame of the reference map, in which the ground truth is given.
  std::string base_frame = "base_link";  ///< Frame of the robot.
  double patience = 1.0;  ///< [s] A true pose waits so long for tf; after that the robot counts as not localized.
};

/// The parameters that fill `options`.
ParameterList parametersOf(LocalizationRecorderOptions& options);

/// Compares, at the stamp of every pose on `ground_truth` (geometry_msgs/PoseStamped, in the coordinates of the
/// reference map whatever its frame is called), where tf reference_frame <- base_frame has the robot. Remembers the
/// last accepted match on `map_match` and the last maps on `session_map` and `reference_map`. When it ends it writes
/// into `directory`: errors.csv and summary.json (see localization_run.hpp), and, after a match, session_map.yaml with
/// its image and overlay.png.
class LocalizationRecorder {
 public:
  /// Throws std::invalid_argument when the directory does not exist.
  LocalizationRecorder(ros::NodeHandle node, const ros::NodeHandle& private_node,
                       const LocalizationRecorderOptions& options);

  /// Writes the record; what cannot be written is logged.
  ~LocalizationRecorder();

  LocalizationRecorder(const LocalizationRecorder&) = delete;
  LocalizationRecorder& operator=(const LocalizationRecorder&) = delete;

 private:
  void onTruth(const geometry_msgs::PoseStampedConstPtr& message);
  void onMatch(const MapMatchConstPtr& message);
  void comparePending();
  std::optional<Rigid2> estimateAt(const ros::Time& stamp) const;
  void write() const;
  void writeMaps() const;

  const LocalizationRecorderOptions options_;
  LocalizationRun run_;
  std::deque<geometry_msgs::PoseStamped> pending_;  // true poses that wait for tf, in the order of their stamps
  nav_msgs::OccupancyGridConstPtr session_map_;
  nav_msgs::OccupancyGridConstPtr reference_map_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_{tf_};
  ros::Subscriber truth_subscriber_;
  ros::Subscriber match_subscriber_;
  ros::Subscriber session_subscriber_;
  ros::Subscriber reference_subscriber_;
};

}  // namespace map_matcher
