#include "map_matcher/simulation/drive.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/yielding.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kControlPeriod = 0.02;  // [s] at most
constexpr double kPeoplePeriod = 0.07;   // [s] at most
constexpr double kWarmUp = 5.0;          // [s] that people walk before the drive begins
constexpr double kRoomAtStart = 0.5;     // [m] around the robot where nobody is at first
constexpr double kSpareDistance = 0.05;  // [m] to people, more than the robot needs
constexpr double kInReach = 2.0;         // [m] beyond where the robot can stop: people farther away are not in its way
constexpr double kLingering = 0.3;       // [m] a robot that got no farther does not get on

/// Streams of the seed.
enum Stream : std::uint64_t {
  kWay = 1,
  kLidarNoise = 2,
  kOdometryNoise = 3,
  kPeople = 4,
  kMoreLidarsNoise = 100,
  kDetectors = 200
};

std::vector<std::string> problemsOfDrive(DriveOptions options) {
  std::vector<std::string> problems = parameters::problemsOf(parametersOf(options));
  std::vector<grid::Rigid2> poses = options.more_lidars;
  poses.insert(poses.begin(), options.lidar.T_base_lidar);
  for (const grid::Rigid2& pose : poses) {
    if (!(pose.translation().norm() <= options.robot.radius)) {
      std::ostringstream text;
      text << "lidar_x, lidar_y are " << pose.x << ", " << pose.y << ", expected a place within radius ("
           << options.robot.radius << " m), so that no wall comes there";
      problems.push_back(text.str());
    }
  }
  if (options.explore && !options.waypoints.empty()) {
    problems.emplace_back("there are waypoints, expected none for a robot that explores");
  }
  const std::optional<grid::Rigid2>& start = options.start;
  if (start && !(start->translation().allFinite() && std::isfinite(start->yaw))) {
    std::ostringstream text;
    text << "start is (" << start->x << ", " << start->y << ") m with yaw " << start->yaw
         << " rad, expected finite numbers";
    problems.push_back(text.str());
  }
  return problems;
}

const DriveOptions& checked(const DriveOptions& options) {
  parameters::throwIfAny(problemsOfDrive(options));
  return options;
}

ItineraryOptions itineraryOf(const DriveOptions& options) {
  return {options.robot.radius, options.min_waypoint_distance, options.start, options.area, options.waypoints,
          options.explore};
}

/// Parts of a period that are not longer than `longest` [s].
int numParts(double period, double longest) { return static_cast<int>(std::ceil(period / longest - 1e-9)); }

}  // namespace

parameters::ParameterList parametersOf(DriveOptions& options) {
  parameters::ParameterList parameters{
      {"duration", "s", "Length of the drive; along given waypoints it may end sooner.", &options.duration, 0.1, 36000},
      {"rate", "Hz", "Scans and odometry readings.", &options.rate, 0.5, 200.0},
      {"min_waypoint_distance", "m", "Straight distance of a random waypoint from the last, where possible.",
       &options.min_waypoint_distance, 0.0, 1000.0},
      {"patience", "s", "A robot that people hold up so long goes to another random waypoint.", &options.patience, 0.5,
       36000.0},
  };
  for (const parameters::ParameterList& part :
       {parametersOf(options.lidar), parametersOf(options.robot), parametersOf(options.odometry),
        parametersOf(options.pedestrians), parametersOf(options.detector)}) {
    parameters.insert(parameters.end(), part.begin(), part.end());
  }
  return parameters;
}

void equipAsPepper(DriveOptions& options) {
  options.robot.radius = 0.3;  // the report's section 3.3.2
  options.robot.max_speed = 0.55;
  options.robot.max_acceleration = 0.55;
  options.lidar.beams = 811;
  options.lidar.field_of_view = LidarOptions{}.field_of_view;
  options.lidar.T_base_lidar = {0.245, 0.0, 0.0};
  options.more_lidars = {{-0.245, 0.0, M_PI}};
  options.rate = 15.0;
}

DriveSimulation::DriveSimulation(const grid::OccupancyGrid& map, const DriveOptions& options)
    : options_(checked(options)),
      world_(map),
      itinerary_(world_, itineraryOf(options), RandomNumbers(options.seed, kWay)),
      robot_(options.robot, itinerary_.start()),
      odometry_(options.odometry, robot_.T_map_base(), RandomNumbers(options.seed, kOdometryNoise)),
      lingers_at_(robot_.T_map_base().translation()) {
  equip(map);
  if (!options_.explore) {
    way_ = itinerary_.nextWay(itinerary_.start().translation());
  }
}

/// Lidars, and people and detectors where they were asked for.
void DriveSimulation::equip(const grid::OccupancyGrid& map) {
  T_base_lidar_ = options_.more_lidars;
  T_base_lidar_.insert(T_base_lidar_.begin(), options_.lidar.T_base_lidar);
  const bool has_people = options_.pedestrians.people > 0 || options_.pedestrians.density > 0.0;
  for (std::size_t i = 0; i < T_base_lidar_.size(); ++i) {
    LidarOptions lidar = options_.lidar;
    lidar.T_base_lidar = T_base_lidar_[i];
    lidars_.emplace_back(lidar, RandomNumbers(options_.seed, i == 0 ? kLidarNoise : kMoreLidarsNoise + i));
    if (has_people) {
      detectors_.emplace_back(map, options_.detector, RandomNumbers(options_.seed, kDetectors + i));
    }
  }
  if (has_people) {
    const Circle kept_free{robot_.T_map_base().translation(), options_.robot.radius + kRoomAtStart};
    people_.emplace(world_, options_.pedestrians, RandomNumbers(options_.seed, kPeople), kept_free);
    for (double time = 0.0; time < kWarmUp; time += kPeoplePeriod) {
      people_->step(kPeoplePeriod, sweep(kControlPeriod));
    }
  }
}

std::optional<DriveStep> DriveSimulation::next() {
  const auto num_steps = static_cast<std::size_t>(std::floor(options_.duration * options_.rate + 1e-9)) + 1;
  if (num_steps_ == num_steps) {
    return std::nullopt;
  }
  if (is_over_) {
    return std::nullopt;
  }
  if (num_steps_ > 0) {
    drive(1.0 / options_.rate);
  }
  if (!way_ && !options_.explore) {
    return std::nullopt;
  }
  odometry_.read(robot_.T_map_base());
  DriveStep step = look();
  ++num_steps_;
  if (options_.explore) {
    explore(step);
  }
  return step;
}

/// Chooses the way on from what is seen, when there is none or its goal has been seen from afar.
void DriveSimulation::explore(const DriveStep& step) {
  for (std::size_t i = 0; i < step.scans.size(); ++i) {
    itinerary_.see(step.scans[i], step.T_map_base * T_base_lidar_[i]);
  }
  if (!way_ || !itinerary_.isWorthwhile(way_->back())) {
    way_ = itinerary_.nextWay(step.T_map_base.translation());
    follower_.reset();
    is_over_ = !way_;
  }
}

/// Moves people and robot on by `period`; the end of a way stops the robot.
void DriveSimulation::drive(double period) {
  if (!follower_) {
    follower_.emplace(world_, *way_);
  }
  // By turns: people keep out of the robot's way to a stop, and the robot stops before it comes to where they are.
  const int num_turns = people_ ? numParts(period, kPeoplePeriod) : 1;
  const double turn = period / num_turns;
  const int num_commands = numParts(turn, kControlPeriod);
  for (int i = 0; i < num_turns; ++i) {
    if (people_) {
      people_->step(turn, sweep(turn / num_commands));
    }
    follow(turn, num_commands);
  }
  if (follower_->arrived()) {
    visited_.push_back(way_->back());
    way_ = options_.explore ? std::nullopt : itinerary_.nextWay(robot_.T_map_base().translation());
    follower_.reset();
  } else if (people_) {
    lookForOtherWay(period);
  }
}

void DriveSimulation::follow(double period, int num_commands) {
  const double command_period = period / num_commands;
  const std::vector<Circle> bodies = bodiesNear();
  const std::vector<Mover> movers = moversNear();
  for (int i = 0; i < num_commands; ++i) {
    const Velocity wanted = follower_->command(robot_, command_period, movers);
    robot_.drive(bodies.empty() ? wanted : yieldTo(bodies, robot_, wanted, command_period), command_period);
  }
}

/// Gives up a way that people block.
void DriveSimulation::lookForOtherWay(double period) {
  const Eigen::Vector2d position = robot_.T_map_base().translation();
  lingers_for_ += period;
  if ((position - lingers_at_).norm() > kLingering) {
    lingers_at_ = position;
    lingers_for_ = 0.0;
  }
  if (lingers_for_ <= options_.patience) {
    return;
  }
  lingers_for_ = 0.0;
  std::optional<Path> other = itinerary_.otherWay(position, way_->back());
  if (other) {
    way_ = std::move(other);
    follower_.reset();
  }
}

RobotSweep DriveSimulation::sweep(double command_period) const {
  const double heading = robot_.T_map_base().yaw;
  return {brakingWay(robot_, command_period), options_.robot.radius, heading,
          robot_.velocity().linear * Eigen::Vector2d(std::cos(heading), std::sin(heading))};
}

/// People in the robot's reach, as large as the robot keeps off them.
std::vector<Mover> DriveSimulation::moversNear() const {
  std::vector<Mover> movers;
  for (std::size_t i = 0; people_ && i < people_->people().size(); ++i) {
    Mover mover = people_->bodyOf(i);
    mover.radius += kDistanceToPeople + kSpareDistance;
    if ((mover.position - robot_.T_map_base().translation()).norm() < options_.robot.radius + kInReach) {
      movers.push_back(mover);
    }
  }
  return movers;
}

/// Bodies and legs that the robot could come to.
std::vector<Circle> DriveSimulation::bodiesNear() const {
  std::vector<Circle> bodies;
  const RobotOptions& limits = options_.robot;
  const double reach = limits.radius + kInReach + limits.max_speed * limits.max_speed / limits.max_acceleration;
  for (std::size_t i = 0; people_ && i < people_->people().size(); ++i) {
    const Mover& body = people_->bodyOf(i);
    if ((body.position - robot_.T_map_base().translation()).norm() < reach) {
      bodies.push_back({body.position, body.radius});
      const std::array<Circle, 2>& legs = people_->people()[i].legs;
      bodies.insert(bodies.end(), legs.begin(), legs.end());
    }
  }
  return bodies;
}

DriveStep DriveSimulation::look() {
  DriveStep step{static_cast<double>(num_steps_) / options_.rate,
                 robot_.T_map_base(),
                 odometry_.T_odom_base(),
                 robot_.velocity(),
                 {},
                 {},
                 {}};
  if (people_) {
    step.people = people_->people();
  }
  const std::vector<Circle> legs = legsOf(step.people);
  for (std::size_t i = 0; i < lidars_.size(); ++i) {
    LidarView view = lidars_[i].scanAmong(legs, world_, step.T_map_base);
    if (people_) {
      step.detections.push_back(detectors_[i].detect(view, step.people, step.T_map_base * T_base_lidar_[i], step.time));
    }
    step.scans.push_back(std::move(view.scan));
  }
  return step;
}

Drive simulateDrive(const grid::OccupancyGrid& map, const DriveOptions& options) {
  DriveSimulation simulation(map, options);
  Drive drive;
  while (std::optional<DriveStep> step = simulation.next()) {
    drive.steps.push_back(*std::move(step));
  }
  drive.T_base_lidar = simulation.lidarPoses();
  drive.visited = simulation.visited();
  drive.has_people = simulation.hasPeople();
  return drive;
}

}  // namespace map_matcher::simulation
