#include "map_matcher/simulation/itinerary.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace map_matcher::simulation {
namespace {

constexpr double kPlanningMargin = 0.08;  // [m] that planned ways keep beyond the robot's radius
constexpr int kWaypointTrials = 100;      // random places looked at for one that is far enough away

std::string pointText(const Eigen::Vector2d& p) {
  std::ostringstream text;
  text << "(" << p.x() << ", " << p.y() << ") m";
  return text.str();
}

}  // namespace

Itinerary::Itinerary(const World& world, ItineraryOptions options, const RandomNumbers& random)
    : world_(world),
      options_(std::move(options)),
      planner_(world, options_.robot_radius + kPlanningMargin),
      random_(random),
      places_(randomPlaces()),
      start_(chooseStart()),
      last_place_(start_.translation()) {
  if (options_.explore) {
    exploration_.emplace(planner_);
  }
  for (std::size_t i = 0; i < options_.waypoints.size(); ++i) {
    const Eigen::Vector2d& from = i == 0 ? last_place_ : options_.waypoints[i - 1];
    given_ways_.push_back(plan(from, options_.waypoints[i], "waypoint " + std::to_string(i + 1)));
  }
}

void Itinerary::see(const scan::PlanarScan& scan, const grid::Rigid2& T_map_lidar) {
  if (exploration_) {
    exploration_->see(scan, T_map_lidar);
  }
}

std::optional<Path> Itinerary::nextWay(const Eigen::Vector2d& position) {
  if (exploration_) {
    return exploration_->nextWay(position, std::nullopt);
  }
  if (options_.waypoints.empty()) {
    const Eigen::Vector2d from = std::exchange(last_place_, randomPlaceFarFrom(last_place_));
    return plan(from, last_place_, "the next waypoint");
  }
  if (num_given_ == given_ways_.size()) {
    return std::nullopt;
  }
  return given_ways_[num_given_++];
}

std::optional<Path> Itinerary::otherWay(const Eigen::Vector2d& position, const Eigen::Vector2d& goal) {
  if (exploration_) {
    return exploration_->nextWay(position, goal);
  }
  if (!options_.waypoints.empty()) {
    return planner_.plan(position, options_.waypoints[num_given_ - 1]);
  }
  const Eigen::Vector2d place = randomPlaceFarFrom(position);
  std::optional<Path> way = planner_.plan(position, place);
  if (way) {
    last_place_ = place;
  }
  return way;
}

std::vector<Eigen::Vector2d> Itinerary::randomPlaces() const {
  const std::optional<Rectangle>& area = options_.area;
  std::vector<Eigen::Vector2d> places;
  std::copy_if(planner_.places().begin(), planner_.places().end(), std::back_inserter(places),
               [&area](const Eigen::Vector2d& place) { return !area || contains(*area, place); });
  if (places.empty()) {
    std::ostringstream text;
    text << "the map has no free place for a robot of radius " << options_.robot_radius << " m";
    if (area) {
      text << " in the area from " << pointText({area->x_min, area->y_min}) << " to "
           << pointText({area->x_max, area->y_max});
    }
    throw std::invalid_argument(text.str());
  }
  return places;
}

grid::Rigid2 Itinerary::chooseStart() {
  if (!options_.start) {
    const Eigen::Vector2d place = places_[random_.index(places_.size())];
    return {place.x(), place.y(), random_.uniform(-M_PI, M_PI)};
  }
  const Eigen::Vector2d place = options_.start->translation();
  if (!world_.isClear(place, options_.robot_radius)) {
    std::ostringstream text;
    text << "start is " << pointText(place) << ", expected a place with " << options_.robot_radius
         << " m of free space around it";
    throw std::invalid_argument(text.str());
  }
  return {place.x(), place.y(), grid::normalizeAngle(options_.start->yaw)};
}

Eigen::Vector2d Itinerary::randomPlaceFarFrom(const Eigen::Vector2d& position) {
  Eigen::Vector2d farthest = position;
  for (int i = 0; i < kWaypointTrials && (farthest - position).norm() < options_.min_waypoint_distance; ++i) {
    const Eigen::Vector2d& place = places_[random_.index(places_.size())];
    if ((place - position).norm() > (farthest - position).norm()) {
      farthest = place;
    }
  }
  return farthest;
}

Path Itinerary::plan(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const std::string& name) const {
  std::optional<Path> way = planner_.plan(from, to);
  if (!way) {
    std::ostringstream text;
    text << name << " is " << pointText(to) << ", expected a place with " << options_.robot_radius + kPlanningMargin
         << " m of free space around it and on a way from " << pointText(from);
    throw std::invalid_argument(text.str());
  }
  return *std::move(way);
}

}  // namespace map_matcher::simulation
