/// \file
/// The overlay_recorder node: keeps what the last match of a run looked like.
#pragma once

#include <map_matcher/MapMatch.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "map_matcher/grid/rigid2.hpp"
#include "map_matcher/parameters/parameter.hpp"

namespace map_matcher::ros_evaluation {

/// Options of the overlay_recorder node. Their ranges stand in parametersOf().
struct OverlayRecorderOptions {
  std::string directory;  ///< Existing directory that the files are written into.
};

/// The parameters that fill `options`.
parameters::ParameterList parametersOf(OverlayRecorderOptions& options);

/// Remembers the last accepted match on `map_match` and the last maps on `session_map` and `reference_map`. When it
/// ends it writes session_map.yaml with its image, and after a match overlay.png, into the directory.
class OverlayRecorder {
 public:
  /// Throws std::invalid_argument when the directory does not exist.
  OverlayRecorder(ros::NodeHandle node, const ros::NodeHandle& private_node, const OverlayRecorderOptions& options);

  /// Writes the files; what cannot be written is logged.
  ~OverlayRecorder();

  OverlayRecorder(const OverlayRecorder&) = delete;
  OverlayRecorder& operator=(const OverlayRecorder&) = delete;

 private:
  void onMatch(const MapMatchConstPtr& message);
  void write() const;

  const OverlayRecorderOptions options_;
  std::optional<grid::Rigid2> T_reference_session_;
  nav_msgs::OccupancyGridConstPtr session_map_;
  nav_msgs::OccupancyGridConstPtr reference_map_;
  ros::Subscriber match_subscriber_;
  ros::Subscriber session_subscriber_;
  ros::Subscriber reference_subscriber_;
};

}  // namespace map_matcher::ros_evaluation
