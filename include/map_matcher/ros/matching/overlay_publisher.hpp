/// \file
/// The match as rviz shows it.
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "map_matcher/search/matched_cells.hpp"

namespace map_matcher::ros_matching {

/// Publishes the session map's occupied cells in the session frame: those on walls of the reference map in red, as
/// figure 8 of the report, the others in blue. rviz moves them with the session frame. Not thread-safe.
class OverlayPublisher {
 public:
  explicit OverlayPublisher(ros::NodeHandle node);

  /// Shows these cells of a session map in `frame`, whose edges are `resolution` long [m], instead of those before.
  void publish(const search::MatchedCells& cells, const std::string& frame, double resolution);

  /// Takes the cells away.
  void clear();

 private:
  std::string frame_;  // of the cells that are shown
  ros::Publisher matched_;
  ros::Publisher unmatched_;
};

}  // namespace map_matcher::ros_matching
