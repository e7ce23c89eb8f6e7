/// \file
/// The match as rviz shows it.
#pragma once

#include <map_matcher/MapMatch.h>
#include <ros/node_handle.h>
#include <visualization_msgs/Marker.h>

#include <string>

#include "map_matcher/belief/answer.hpp"
#include "map_matcher/ros/matching/reference_map.hpp"
#include "map_matcher/search/matched_cells.hpp"

namespace map_matcher::ros_matching {

/// Publishes, latched, what rviz draws over the maps. In the session frame, so that rviz moves them with it: the
/// session map's occupied cells, those on walls of the reference map in red, as figure 8 of the report, the others in
/// blue. In the frame of the reference map: where else these cells may lie, and how the session stands, as text. Not
/// thread-safe.
class OverlayPublisher {
 public:
  explicit OverlayPublisher(ros::NodeHandle node);

  /// Shows these cells of a session map in `frame`, whose edges are `resolution` long [m], instead of those before.
  void publish(const search::MatchedCells& cells, const std::string& frame, double resolution);

  /// Shows all `cells` of a session map at the places that `answer` knows but does not announce, two at most, instead
  /// of those before: the best one, unless that is matched, and the best one elsewhere. Those in another reference map
  /// than that of the answer are left out. `frame` is that map's, `resolution` that of the session map [m].
  void publishOtherPlaces(const search::MatchedCells& cells, const belief::Answer& answer, const std::string& frame,
                          double resolution);

  /// Writes above `reference` how the session stands after `report`.
  void write(const MapMatch& report, const ReferenceMap& reference);

  /// Takes all of it away.
  void clear();

 private:
  /// A topic with the one marker that rviz has of it.
  class LatchedMarker {
   public:
    LatchedMarker(ros::NodeHandle& node, const std::string& topic);
    void show(visualization_msgs::Marker marker);
    void clear();

   private:
    ros::Publisher publisher_;
    std::string topic_;
    std::string frame_;  // of what is shown
  };

  LatchedMarker matched_;
  LatchedMarker unmatched_;
  LatchedMarker other_places_;
  LatchedMarker text_;
};

}  // namespace map_matcher::ros_matching
