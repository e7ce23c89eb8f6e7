#include "map_matcher/simulation/drive.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/simulation/path_follower.hpp"
#include "map_matcher/simulation/path_planner.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/world.hpp"

namespace map_matcher {
namespace {

constexpr double kPlanningMargin = 0.08;  // [m] that planned ways keep beyond the robot's radius
constexpr double kControlPeriod = 0.02;   // [s] at most
constexpr int kWaypointTrials = 100;      // random places looked at for one that is far enough away

/// Streams of the seed.
enum Stream : std::uint64_t { kWay = 1, kLidarNoise = 2, kOdometryNoise = 3 };

std::string pointText(const Eigen::Vector2d& p) {
  std::ostringstream text;
  text << "(" << p.x() << ", " << p.y() << ") m";
  return text.str();
}

std::vector<std::string> problemsOfDrive(DriveOptions options) {
  std::vector<std::string> problems = problemsOf(parametersOf(options));
  const double offset = options.lidar.T_base_lidar.translation().norm();
  if (offset > options.robot.radius) {
    std::ostringstream text;
    text << "lidar_x, lidar_y are " << options.lidar.T_base_lidar.x << ", " << options.lidar.T_base_lidar.y
         << ", expected a place within radius (" << options.robot.radius << " m), so that no wall comes there";
    problems.push_back(text.str());
  }
  const std::optional<Rigid2>& start = options.start;
  if (start && !(start->translation().allFinite() && std::isfinite(start->yaw))) {
    problems.push_back("start is " + pointText(start->translation()) + " with yaw " + std::to_string(start->yaw) +
                       " rad, expected finite numbers");
  }
  return problems;
}

/// Where the robot starts and where it goes next.
class Itinerary {
 public:
  Itinerary(const World& world, const DriveOptions& options)
      : world_(world),
        options_(options),
        planner_(world, options.robot.radius + kPlanningMargin),
        random_(options.seed, kWay),
        start_(chooseStart()),
        last_place_(start_.translation()) {
    for (std::size_t i = 0; i < options_.waypoints.size(); ++i) {
      const Eigen::Vector2d& from = i == 0 ? last_place_ : options_.waypoints[i - 1];
      given_ways_.push_back(plan(from, options_.waypoints[i], "waypoint " + std::to_string(i + 1)));
    }
  }

  const Rigid2& start() const { return start_; }

  /// The way from the last waypoint to the next one, std::nullopt after the last.
  std::optional<Path> nextWay() {
    if (options_.waypoints.empty()) {
      const Eigen::Vector2d from = std::exchange(last_place_, randomPlaceFarFrom(last_place_));
      return plan(from, last_place_, "the next waypoint");
    }
    if (num_given_ == given_ways_.size()) {
      return std::nullopt;
    }
    return given_ways_[num_given_++];
  }

 private:
  Rigid2 chooseStart() {
    const std::vector<Eigen::Vector2d>& places = planner_.places();
    if (places.empty()) {
      std::ostringstream text;
      text << "the map has no free place for a robot of radius " << options_.robot.radius << " m";
      throw std::invalid_argument(text.str());
    }
    if (!options_.start) {
      const Eigen::Vector2d place = places[random_.index(places.size())];
      return {place.x(), place.y(), random_.uniform(-M_PI, M_PI)};
    }
    const Eigen::Vector2d place = options_.start->translation();
    if (!world_.isClear(place, options_.robot.radius)) {
      std::ostringstream text;
      text << "start is " << pointText(place) << ", expected a place with " << options_.robot.radius
           << " m of free space around it";
      throw std::invalid_argument(text.str());
    }
    return {place.x(), place.y(), normalizeAngle(options_.start->yaw)};
  }

  Eigen::Vector2d randomPlaceFarFrom(const Eigen::Vector2d& position) {
    const std::vector<Eigen::Vector2d>& places = planner_.places();
    Eigen::Vector2d farthest = position;
    for (int i = 0; i < kWaypointTrials && (farthest - position).norm() < options_.min_waypoint_distance; ++i) {
      const Eigen::Vector2d& place = places[random_.index(places.size())];
      if ((place - position).norm() > (farthest - position).norm()) {
        farthest = place;
      }
    }
    return farthest;
  }

  Path plan(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const std::string& name) const {
    std::optional<Path> way = planner_.plan(from, to);
    if (!way) {
      std::ostringstream text;
      text << name << " is " << pointText(to) << ", expected a place with " << options_.robot.radius + kPlanningMargin
           << " m of free space around it and on a way from " << pointText(from);
      throw std::invalid_argument(text.str());
    }
    return *std::move(way);
  }

  const World& world_;
  const DriveOptions& options_;
  PathPlanner planner_;
  RandomNumbers random_;
  Rigid2 start_;
  Eigen::Vector2d last_place_;    // the last random waypoint
  std::vector<Path> given_ways_;  // to the waypoints of the options
  std::size_t num_given_ = 0;     // how many of them were handed out
};

/// Moves the robot on by `period`, in control periods of equal length; the way's end stops it.
void follow(PathFollower& follower, DifferentialDrive& robot, double period) {
  const auto num_commands = static_cast<int>(std::ceil(period / kControlPeriod));
  const double command_period = period / num_commands;
  for (int i = 0; i < num_commands; ++i) {
    robot.drive(follower.command(robot, command_period), command_period);
  }
}

}  // namespace

ParameterList parametersOf(DriveOptions& options) {
  ParameterList parameters{
      {"duration", "s", "Length of the drive; along given waypoints it may end sooner.", &options.duration, 0.1, 36000},
      {"rate", "Hz", "Scans and odometry readings.", &options.rate, 0.5, 200.0},
      {"min_waypoint_distance", "m", "Straight distance of a random waypoint from the last, where possible.",
       &options.min_waypoint_distance, 0.0, 1000.0},
  };
  for (const ParameterList& part :
       {parametersOf(options.lidar), parametersOf(options.robot), parametersOf(options.odometry)}) {
    parameters.insert(parameters.end(), part.begin(), part.end());
  }
  return parameters;
}

Drive simulateDrive(const OccupancyGrid& map, const DriveOptions& options) {
  throwIfAny(problemsOfDrive(options));
  const World world(map);
  Itinerary itinerary(world, options);
  DifferentialDrive robot(options.robot, itinerary.start());
  Odometry odometry(options.odometry, robot.T_map_base(), RandomNumbers(options.seed, kOdometryNoise));
  Lidar lidar(options.lidar, RandomNumbers(options.seed, kLidarNoise));

  Drive drive;
  drive.T_base_lidar = options.lidar.T_base_lidar;
  std::optional<Path> way = itinerary.nextWay();
  std::optional<PathFollower> follower;
  const auto num_steps = static_cast<std::size_t>(std::floor(options.duration * options.rate + 1e-9)) + 1;
  for (std::size_t i = 0; i < num_steps && way; ++i) {
    odometry.read(robot.T_map_base());
    drive.steps.push_back({static_cast<double>(i) / options.rate, robot.T_map_base(), odometry.T_odom_base(),
                           robot.velocity(), lidar.scan(world, robot.T_map_base())});
    if (!follower) {
      follower.emplace(world, *way);
    }
    follow(*follower, robot, 1.0 / options.rate);
    if (follower->arrived()) {
      drive.visited.push_back(way->back());
      way = itinerary.nextWay();
      follower.reset();
    }
  }
  return drive;
}

}  // namespace map_matcher
