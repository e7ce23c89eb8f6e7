/// \file
/// Names of the map_matcher node's topics and services, all relative: they can be remapped and pushed into a namespace.
#pragma once

namespace map_matcher::ros_common::names {

constexpr const char* kNode = "map_matcher";

constexpr const char* kSessionMap = "session_map";      ///< In: nav_msgs/OccupancyGrid.
constexpr const char* kReferenceMap = "reference_map";  ///< In; private, out: the one in use. OccupancyGrid, latched.
constexpr const char* kMapMatch = "map_match";          ///< Out: map_matcher/MapMatch, latched.
constexpr const char* kMatchPose = "match_pose";        ///< Out: geometry_msgs/PoseWithCovarianceStamped, latched.
constexpr const char* kRobotPose = "robot_pose";        ///< Out: geometry_msgs/PoseWithCovarianceStamped.
constexpr const char* kInitialPose = "initialpose";     ///< In and out: geometry_msgs/PoseWithCovarianceStamped.
constexpr const char* kSpeech = "speech";               ///< Out: std_msgs/String.
constexpr const char* kMap = "map";                     ///< Out: nav_msgs/OccupancyGrid, the reference map, latched.
constexpr const char* kMapMetadata = "map_metadata";    ///< Out: nav_msgs/MapMetaData of it, latched.
constexpr const char* kMatchedCells = "matched_cells";  ///< Out: visualization_msgs/Marker, latched.
constexpr const char* kUnmatchedCells = "unmatched_cells";  ///< Out: visualization_msgs/Marker, latched.
constexpr const char* kOtherPlaces = "other_places";        ///< Out: visualization_msgs/Marker, latched.
constexpr const char* kMatchText = "match_text";            ///< Out: visualization_msgs/Marker, latched.

constexpr const char* kMatchToReference = "match_to_reference";     ///< Service: map_matcher/MatchToReference.
constexpr const char* kSetReferenceMap = "set_reference_map";       ///< Service: map_matcher/SetReferenceMap.
constexpr const char* kChangeMap = "change_map";                    ///< Service: nav_msgs/LoadMap.
constexpr const char* kStaticMap = "static_map";                    ///< Service: nav_msgs/GetMap.
constexpr const char* kMatchNow = "match_now";                      ///< Service, private: std_srvs/Trigger.
constexpr const char* kReset = "reset";                             ///< Service, private: std_srvs/Empty.
constexpr const char* kGlobalLocalization = "global_localization";  ///< Service: std_srvs/Empty.

}  // namespace map_matcher::ros_common::names
