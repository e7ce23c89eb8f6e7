#include "map_matcher/ros/matching/match_services.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/common/names.hpp"
#include "map_matcher/ros/matching/match_messages.hpp"

namespace map_matcher::ros_matching {
namespace {

constexpr std::chrono::milliseconds kStopPeriod{20};  // how often a caller who waits is looked after

void requireValid(belief::MatchOptions options) {
  parameters::throwIfAny(parameters::problemsOf(parametersOf(options)));
}

bool overrides(double value) { return value != 0.0 && !std::isnan(value); }

/// A field of a request, finite and not below `min`.
parameters::Parameter field(const char* name, const char* unit, double& value,
                            double min = -std::numeric_limits<double>::infinity()) {
  return {name, unit, "", &value, min, std::numeric_limits<double>::infinity(), {}};
}

}  // namespace

MatchServices::MatchServices(ros::NodeHandle node, ros::NodeHandle private_node, Actions actions)
    : actions_(std::move(actions)) {
  node.setCallbackQueue(&queue_);
  private_node.setCallbackQueue(&queue_);
  match_to_reference_ =
      node.advertiseService(ros_common::names::kMatchToReference, &MatchServices::onMatchToReference, this);
  set_reference_map_ =
      node.advertiseService(ros_common::names::kSetReferenceMap, &MatchServices::onSetReferenceMap, this);
  match_now_ = private_node.advertiseService(ros_common::names::kMatchNow, &MatchServices::onMatchNow, this);
  spinner_.start();
}

MatchServices::~MatchServices() {
  stop_.requestStop();
  spinner_.stop();
}

bool MatchServices::onMatchToReference(MatchToReference::Request& request, MatchToReference::Response& response) {
  try {
    const belief::MatchOptions options = optionsOf(request, actions_.options());
    requireValid(options);
    response.match = matchMessage(options, actions_.references(), request.session_map, constraintsOf(request), stop_);
  } catch (const std::invalid_argument& error) {
    response.match = refusal(MapMatch::INVALID_REQUEST, error.what());
  } catch (const std::exception& error) {
    response.match = refusal(MapMatch::FAILED, error.what());
  }
  actions_.complete(response.match);
  return true;
}

bool MatchServices::onSetReferenceMap(SetReferenceMap::Request& request, SetReferenceMap::Response& response) {
  try {
    actions_.set_reference(request.reference_map);
    response.accepted = true;
    response.message = "a reference map of " + std::to_string(request.reference_map.info.width) + " x " +
                       std::to_string(request.reference_map.info.height) + " cells is in use";
  } catch (const ros_common::MessageError& error) {
    response.accepted = false;
    response.message = error.what();
  }
  return true;
}

bool MatchServices::onMatchNow(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  std::optional<std::future<MapMatch>> answer = actions_.match_session();
  if (!answer) {
    response.message = "there is no session map yet";
    return true;
  }
  while (answer->wait_for(kStopPeriod) != std::future_status::ready) {
    if (stop_.stopRequested()) {
      response.message = "the node is shutting down";
      return true;
    }
  }
  try {
    const MapMatch match = answer->get();
    response.success = match.status == MapMatch::MATCHED;
    response.message = match.status_text + ": " + match.reason;
  } catch (const std::future_error&) {
    response.message = "a newer map came before the search began; its answer is on the topic map_match";
  }
  return true;
}

belief::MatchOptions optionsOf(const MatchToReference::Request& request, const belief::MatchOptions& node_options) {
  belief::MatchOptions options = node_options;
  if (overrides(request.acceptance_ratio)) {
    options.search.coarse.acceptance_ratio = request.acceptance_ratio;
    options.belief.min_hit_ratio = request.acceptance_ratio;
  }
  if (overrides(request.rotation_downsampling)) {
    options.search.coarse.rotation_downsampling = request.rotation_downsampling;
  }
  if (request.hits_sample_threshold != 0) {
    options.search.hits_sample_threshold = request.hits_sample_threshold == -1 ? 0 : request.hits_sample_threshold;
  }
  return options;
}

search::Constraints constraintsOf(const MatchToReference::Request& request) {
  MatchToReference::Request values = request;
  search::Constraints constraints;
  if (request.use_heading_prior) {
    parameters::throwIfAny(parameters::problemsOf(
        {field("heading", "rad", values.heading), field("heading_half_width", "rad", values.heading_half_width, 0.0)}));
    constraints.heading = search::HeadingPrior{};
    constraints.heading->yaw = request.heading;
    if (request.heading_half_width > 0.0) {
      constraints.heading->half_width = request.heading_half_width;
    }
  }
  if (request.use_window_prior) {
    parameters::throwIfAny(parameters::problemsOf({field("window_centre_x", "m", values.window_centre_x),
                                                   field("window_centre_y", "m", values.window_centre_y),
                                                   field("window_half_size_x", "m", values.window_half_size_x, 0.0),
                                                   field("window_half_size_y", "m", values.window_half_size_y, 0.0)}));
    constraints.window = search::WindowPrior{{request.window_centre_x, request.window_centre_y},
                                             {request.window_half_size_x, request.window_half_size_y}};
  }
  return constraints;
}

}  // namespace map_matcher::ros_matching
