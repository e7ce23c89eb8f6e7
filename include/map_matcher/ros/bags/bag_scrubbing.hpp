/// \file
/// Scrubs the scans of a bag, without a roscore.
#pragma once

#include <string>
#include <vector>

#include "map_matcher/ros/bags/bag_reading.hpp"
#include "map_matcher/ros/scrubbing/lidar_scrubber_server_options.hpp"
#include "map_matcher/scrubbing/people_removal.hpp"

namespace map_matcher::ros_bags {

/// What to scrub in which bag.
struct BagScrubbingRequest {
  std::string bag;                                ///< Path of the bag.
  std::string scan_topic;                         ///< Topic of sensor_msgs/LaserScan; empty: the only one in the bag.
  std::string people_topic;                       ///< True positions, geometry_msgs/PoseArray; empty: not known.
  std::string output;                             ///< Path of the bag to write, replacing the file; empty: none.
  std::string scrubbed_topic = "/scan_scrubbed";  ///< Topic of the scrubbed scans in it.
  ros_scrubbing::LidarScrubberServerOptions options;  ///< on_silence and wall_veto_distance are not heeded.
};

/// The points of those scans for which the bag has the true positions of people.
struct PeopleCount {
  int scans = 0;                 ///< Scans with at least one person.
  int people = 0;                ///< Positions in them.
  std::int64_t near = 0;         ///< Points within removal_radius of a person.
  std::int64_t near_left = 0;    ///< Those of them that remained.
  std::int64_t others = 0;       ///< All other points.
  std::int64_t others_lost = 0;  ///< Those of them that were removed.
};

/// What scrubbing a bag gave.
struct BagScrubbingResult {
  std::string scan_topic;
  int scans = 0;                                 ///< Scans in the bag.
  int scans_dropped = 0;                         ///< Scans that made no sense.
  int scans_changed = 0;                         ///< Scans from which something was removed.
  int scans_too_much = 0;                        ///< Scans left as they were, since max_removed_fraction was exceeded.
  int scans_timed_out = 0;                       ///< Scans that waited in vain (mode: synchronised).
  std::int64_t detections = 0;                   ///< Detections within the limits.
  std::int64_t points = 0;                       ///< Points of all scans.
  std::int64_t removed = 0;                      ///< Those of them that were removed.
  scrubbing::PeopleRemoval::PathCounts paths{};  ///< Sets of detections by how they came into the frame of a scan.
  std::string last_problem;                      ///< The latest reason why a message could not be used; empty: none.
  PeopleCount people;
};

/// Does with the scans and detections of a bag, in the order and at the times in which they were recorded, what the
/// lidar_scrubber does. The output holds all messages of the bag and the scrubbed scans. Throws BagError for a bag that
/// cannot be read or written or lacks a topic.
BagScrubbingResult scrubBag(const BagScrubbingRequest& request);

}  // namespace map_matcher::ros_bags
