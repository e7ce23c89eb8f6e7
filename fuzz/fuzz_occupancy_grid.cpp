// Two nav_msgs/OccupancyGrid, one as the reference map and one as a session map in it, with the priors of a request:
// what is refused is refused with MessageError or std::invalid_argument, all else is searched, judged and told.
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <stdexcept>

#include "map_matcher/belief/session_tracker.hpp"
#include "map_matcher/ros/common/conversions.hpp"
#include "map_matcher/ros/matching/match_messages.hpp"
#include "map_matcher/ros/matching/match_services.hpp"
#include "messages.hpp"

namespace map_matcher {
namespace {

MatchToReference::Request takePriors(fuzz::Bytes& bytes) {
  MatchToReference::Request request;
  request.use_heading_prior = static_cast<std::uint8_t>(bytes.choose(1));
  request.use_window_prior = static_cast<std::uint8_t>(bytes.choose(1));
  if (request.use_heading_prior) {
    request.heading = fuzz::takeCoordinate(bytes);
    request.heading_half_width = fuzz::takeCoordinate(bytes);
  }
  if (request.use_window_prior) {
    request.window_centre_x = fuzz::takeCoordinate(bytes);
    request.window_centre_y = fuzz::takeCoordinate(bytes);
    request.window_half_size_x = fuzz::takeCoordinate(bytes);
    request.window_half_size_y = fuzz::takeCoordinate(bytes);
  }
  return request;
}

/// Ends a search by the work that was done, so that the same input always does the same.
work::Deadline deadlineOf(long most_looks) {
  const auto looks = std::make_shared<std::atomic<long>>(0);
  return work::Deadline([looks, most_looks] { return ++*looks > most_looks; });
}

void check(const MapMatch& match) {
  const bool has_pose = std::isfinite(match.x) && std::isfinite(match.y) && std::isfinite(match.yaw);
  if (match.status == MapMatch::MATCHED && !has_pose) {
    __builtin_trap();
  }
  if (!(match.probability >= 0.0 && match.probability <= 1.0) || match.hit_cells > match.total_cells) {
    __builtin_trap();
  }
}

/// What the node does with the maps.
void match(fuzz::Bytes& bytes) {
  belief::MatchOptions options;
  options.search.min_session_cells = 1 + bytes.choose(15);
  options.search.search = bytes.choose(3) != 0 ? "exact" : "two_stage";
  options.search.hit_tolerance = 0.05 * bytes.choose(3);
  options.search.threads = 1;
  const MatchToReference::Request request = takePriors(bytes);
  const auto robot = Eigen::Vector2d(fuzz::takeCoordinate(bytes), fuzz::takeCoordinate(bytes));
  const nav_msgs::OccupancyGrid reference_message = fuzz::takeMap(bytes);
  const ros_matching::SessionMapPtr session = ros_matching::sessionMapOf(fuzz::takeMap(bytes));
  const auto reference = std::make_shared<const ros_matching::ReferenceMap>(
      ros_common::fromMessage(reference_message), options.search, ros_common::frameOf(reference_message.header));
  const belief::ReferenceMaps maps = ros_matching::searched({reference});
  const search::MapMatcher matcher(options.search);
  belief::SessionTracker tracker(options);
  tracker.arrive(traitsOf(*session, "/mapper"));
  const belief::Findings findings =
      findPlaces(matcher, maps, session->grid, options, {}, ros_matching::constraintsOf(request), deadlineOf(500));
  check(ros_matching::toMessage(tracker.conclude(findings, maps, session->grid, robot)));
}

}  // namespace
}  // namespace map_matcher

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace map_matcher;
  fuzz::Bytes bytes(data, size);
  try {
    match(bytes);
  } catch (const ros_common::MessageError&) {
    return 0;
  } catch (const std::invalid_argument&) {  // a prior of the request, or a map that is too large for the search
    return 0;
  }
  return 0;
}
