/// \file
/// The services of the map_matcher node.
#pragma once

#include <map_matcher/MatchToReference.h>
#include <map_matcher/SetReferenceMap.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>

#include <functional>
#include <future>
#include <optional>

#include "map_matcher/ros/matching/session_map.hpp"

namespace map_matcher::ros_matching {

/// Serves `match_to_reference`, `set_reference_map` and `~match_now` on a thread of its own, so that a caller who waits
/// for a search keeps neither tf nor maps waiting.
class MatchServices {
 public:
  /// What the services act on; called on the services' thread.
  struct Actions {
    std::function<ReferenceMapList()> references;                         ///< The reference maps in use.
    std::function<belief::MatchOptions()> options;                        ///< The node's.
    std::function<void(const nav_msgs::OccupancyGrid&)> set_reference;    ///< Throws MessageError.
    std::function<std::optional<std::future<MapMatch>>()> match_session;  ///< Nothing when there is no session map.
    std::function<void(MapMatch&)> complete;                              ///< Fills in the header's stamp and counts.
  };

  MatchServices(ros::NodeHandle node, ros::NodeHandle private_node, Actions actions);

  /// Stops a search that a caller waits for.
  ~MatchServices();

  MatchServices(const MatchServices&) = delete;
  MatchServices& operator=(const MatchServices&) = delete;

 private:
  bool onMatchToReference(MatchToReference::Request& request, MatchToReference::Response& response);
  bool onSetReferenceMap(SetReferenceMap::Request& request, SetReferenceMap::Response& response);
  bool onMatchNow(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  Actions actions_;
  work::StopToken stop_;
  ros::CallbackQueue queue_;
  ros::ServiceServer match_to_reference_;
  ros::ServiceServer set_reference_map_;
  ros::ServiceServer match_now_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

/// The node's options with those that the request overrides: not zero and not NaN. Not checked.
belief::MatchOptions optionsOf(const MatchToReference::Request& request, const belief::MatchOptions& node_options);

/// The priors of a request. Throws std::invalid_argument that names each value that is not finite or out of range.
search::Constraints constraintsOf(const MatchToReference::Request& request);

}  // namespace map_matcher::ros_matching
