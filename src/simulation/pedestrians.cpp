#include "map_matcher/simulation/pedestrians.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kPlanningMargin = 0.02;     // [m] that planned ways keep beyond the body
constexpr int kWayTrials = 20;               // goals that are looked at for one with a way out
constexpr double kWidestLane = 0.6;          // [m] that people keep to the right of the planned way, at most
constexpr double kArrived = 0.8;             // [m] from a goal
constexpr double kWayAhead = 2.0;            // [m] of the planned way that are looked at
constexpr double kSight = 2.5;               // [m] others farther away are not minded
constexpr std::size_t kManyInSight = 64;     // others, in a crowd of 3 people per square metre
constexpr double kRelaxation = 0.3;          // [s] in which a velocity comes near the wanted one
constexpr double kHeldUpShare = 0.3;         // of their speed: who is slower is held up
constexpr std::size_t kStepsToDecision = 2;  // nobody decides anew more often
constexpr double kPatience = 2.0;            // [s] before who is held up goes somewhere else
constexpr double kEscape = 0.7;              // [m] of a way that have to be free for somebody who is held up
constexpr double kTurnRate = 4.0;            // [rad/s] of somebody who walks
constexpr double kTurnSpeed = 0.1;           // [m/s] slower people do not turn
constexpr double kRobotNear = 0.6;           // [m] from the robot: who stands there steps aside
constexpr double kStepAsideAfter = 1.5;      // [s]
constexpr double kStepAsideSpeed = 0.5;      // [m/s]
constexpr double kShoulders = 0.05;          // [m] between two people at first, at least
constexpr double kHalfStance = 0.09;         // [m] from a foot to the middle
constexpr double kLegVariation = 0.15;       // of the mean leg radius
constexpr double kLongestPeriod = 0.1;       // [s] that people move on at once
constexpr int kPlaceTrials = 300;            // random places that are looked at for a person
constexpr int kGroupTrials = 20;             // random places that are looked at for a group
constexpr std::size_t kLargestGroup = 5;     // people who stand together
constexpr double kGroupSpacing = 0.7;        // [m] between neighbours in a group

double distanceToSweep(const RobotSweep& robot, const Eigen::Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& centre : robot.centres) {
    nearest = std::min(nearest, (centre - p).squaredNorm());
  }
  return std::sqrt(nearest) - robot.radius;
}

Eigen::Vector2d direction(double heading) { return {std::cos(heading), std::sin(heading)}; }

/// A heading turned towards another by `largest` [rad] at most.
double turnedTowards(double heading, double wanted, double largest) {
  return grid::normalizeAngle(heading + std::clamp(grid::normalizeAngle(wanted - heading), -largest, largest));
}

PlaceIndex indexOver(const std::vector<Eigen::Vector2d>& places) {
  Eigen::Vector2d low = places.empty() ? Eigen::Vector2d::Zero() : places.front();
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  return PlaceIndex(low, high, 0.5);
}

const PedestrianOptions& checked(const PedestrianOptions& options) {
  PedestrianOptions copy = options;
  parameters::throwIfAny(parameters::problemsOf(parametersOf(copy)));
  return options;
}

}  // namespace

parameters::ParameterList parametersOf(PedestrianOptions& options) {
  return {
      {"people", "", "People in the building; 0: as many as the density says.", &options.people, 0, 5000},
      {"density", "1/m^2", "People per area of free space, when people is 0.", &options.density, 0.0, 3.0},
      {"standing_share", "", "Share of the people who stand in groups.", &options.standing_share, 0.0, 1.0},
      {"walking_speed", "m/s", "Mean speed of people with nobody in their way.", &options.speed, 0.2, 2.0},
      {"walking_speed_sigma", "m/s", "Standard deviation of that speed.", &options.speed_sigma, 0.0, 0.5},
      {"body_radius", "m", "Space around a person that no wall and nobody else enters.", &options.body_radius, 0.165,
       0.4},
      {"leg_radius", "m", "Mean radius of a leg.", &options.leg_radius, 0.03, 0.065},
  };
}

std::vector<Circle> legsOf(const std::vector<Person>& people) {
  std::vector<Circle> legs;
  legs.reserve(2 * people.size());
  for (const Person& person : people) {
    legs.insert(legs.end(), person.legs.begin(), person.legs.end());
  }
  return legs;
}

Pedestrians::Pedestrians(const World& world, const PedestrianOptions& options, const RandomNumbers& random,
                         const std::optional<Circle>& kept_free)
    : world_(world),
      options_(checked(options)),
      random_(random),
      planner_(world, options.body_radius + kPlanningMargin),
      index_(indexOver(planner_.places())) {
  const double by_density = options.density * planner_.coveredArea();
  const auto count = static_cast<std::size_t>(options.people > 0 ? options.people : std::lround(by_density));
  if (count == 0 || planner_.places().empty()) {
    return;
  }
  errands_.emplace(planner_, random_);
  populate(count, kept_free);
  updatePeople();
}

/// First the groups, while there is room for them, then everybody else.
void Pedestrians::populate(std::size_t count, const std::optional<Circle>& kept_free) {
  const auto standing = static_cast<std::size_t>(std::lround(options_.standing_share * static_cast<double>(count)));
  while (walkers_.size() < standing) {
    const std::size_t size = std::min(standing - walkers_.size(), 2 + random_.index(kLargestGroup - 1));
    if (!placeGroup(size, kept_free)) {
      break;
    }
  }
  bool found_room = true;
  while (found_room && walkers_.size() < count) {
    found_room = false;
    for (int i = 0; i < kPlaceTrials && !found_room; ++i) {
      found_room = place(randomPlace(), random_.uniform(-M_PI, M_PI), walkers_.size() < standing, kept_free);
    }
  }
}

/// Puts people on a circle, looking at its centre; false when there is no room for even one of them.
bool Pedestrians::placeGroup(std::size_t size, const std::optional<Circle>& kept_free) {
  const double ring = 0.5 * kGroupSpacing / std::sin(M_PI / static_cast<double>(std::max<std::size_t>(size, 2)));
  bool placed = false;
  for (int i = 0; i < kGroupTrials && !placed; ++i) {
    const Eigen::Vector2d centre = randomPlace();
    const double first = random_.uniform(-M_PI, M_PI);
    for (std::size_t k = 0; k < size; ++k) {
      const double angle = first + 2.0 * M_PI * static_cast<double>(k) / static_cast<double>(size);
      const double from_centre = ring * random_.uniform(0.9, 1.2);
      const double heading = grid::normalizeAngle(angle + M_PI + random_.uniform(-0.3, 0.3));
      placed = place(centre + from_centre * direction(angle), heading, true, kept_free) || placed;
    }
  }
  return placed;
}

/// Adds somebody, unless there is no room.
bool Pedestrians::place(const Eigen::Vector2d& position, double heading, bool stands,
                        const std::optional<Circle>& kept_free) {
  const double radius = options_.body_radius;
  bool is_free = world_.isClear(position, radius + kPlanningMargin) &&
                 !(kept_free && (position - kept_free->centre).norm() < kept_free->radius + radius);
  index_.visitNear(position, 2.0 * radius + kShoulders, [&](std::size_t other) {
    is_free = is_free && (position - bodies_[other].position).norm() >= 2.0 * radius + kShoulders;
  });
  if (!is_free) {
    return false;
  }
  const double speed = options_.speed + options_.speed_sigma * std::clamp(random_.gaussian(), -2.0, 2.0);
  const double leg_radius = options_.leg_radius * random_.uniform(1.0 - kLegVariation, 1.0 + kLegVariation);
  const double half_width = std::min(kHalfStance, radius - leg_radius);
  const auto goal = stands ? std::nullopt : std::optional(errands_->randomGoal(position, random_));
  index_.insert(walkers_.size(), position);
  bodies_.push_back({position, Eigen::Vector2d::Zero(), radius});
  walkers_.push_back({heading, std::max(speed, 0.2), leg_radius, goal, random_.uniform(0.0, kWidestLane), 0.0,
                      Eigen::Vector2d::Zero(), Gait(position, heading, half_width)});
  return true;
}

Eigen::Vector2d Pedestrians::randomPlace() {
  const std::vector<Eigen::Vector2d>& places = planner_.places();
  return places[random_.index(places.size())];
}

/// A goal for somebody who is held up: one whose way is free at first, where there is one.
std::size_t Pedestrians::goalWithAWayOut(std::size_t index) {
  const Eigen::Vector2d& position = bodies_[index].position;
  std::size_t goal = 0;
  bool is_free = false;
  for (int i = 0; i < kWayTrials && !is_free; ++i) {
    goal = errands_->randomGoal(position, random_);
    const std::vector<Eigen::Vector2d> way = errands_->waysTo(goal).ahead(position, kEscape);
    if (way.empty()) {
      continue;
    }
    is_free = true;
    index_.visitNear(way.back(), kEscape, [&](std::size_t other) {
      const double distance = (bodies_[other].position - way.back()).norm();
      is_free = is_free && (other == index || distance > 2.0 * options_.body_radius);
    });
  }
  return goal;
}

void Pedestrians::step(double period, const RobotSweep& robot) {
  const double bounded = std::min(period, kLongestPeriod);
  index_.clear();
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    index_.insert(i, bodies_[i].position);
  }
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    move(i, bounded, robot);
    moveFeet(i, bounded, robot);
  }
  ++num_steps_;
  updatePeople();
}

/// One after the other: each sees where those before have gone, so that no two can go to the same place.
void Pedestrians::move(std::size_t index, double period, const RobotSweep& robot) {
  Walker& walker = walkers_[index];
  Mover& body = bodies_[index];
  if ((num_steps_ + index) % kStepsToDecision == 0) {
    const double since_last = period * static_cast<double>(kStepsToDecision);
    walker.wanted = walker.goal ? walk(index, since_last, robot) : stand(index, since_last, robot);
  }
  body.velocity += (walker.wanted - body.velocity) * std::min(1.0, period / kRelaxation);

  // Straight on, or past what is in the way, or not at all.
  const double speed = body.velocity.norm();
  const double heading = std::atan2(body.velocity.y(), body.velocity.x());
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  for (const double turn : {0.0, -0.8, 0.8, -1.5, 1.5}) {
    const Eigen::Vector2d tried = direction(heading + turn) * speed * std::max(0.2, std::cos(turn));
    if (speed > 0.0 && mayStandAt(index, body.position + tried * period, robot)) {
      velocity = tried;
      break;
    }
  }
  body.velocity = velocity;
  body.position += velocity * period;
  if (velocity.norm() > kTurnSpeed) {
    walker.heading = turnedTowards(walker.heading, std::atan2(velocity.y(), velocity.x()), kTurnRate * period);
  }
}

/// The velocity of somebody on the way to a goal; chooses the next goal.
Eigen::Vector2d Pedestrians::walk(std::size_t index, double period, const RobotSweep& robot) {
  Walker& walker = walkers_[index];
  const Mover& body = bodies_[index];
  walker.held_up = body.velocity.norm() < kHeldUpShare * walker.speed ? walker.held_up + period : 0.0;
  const bool arrived = (errands_->placeOf(*walker.goal) - body.position).norm() < kArrived;
  if (arrived || walker.held_up > kPatience) {
    walker.goal = arrived ? errands_->randomGoal(body.position, random_) : goalWithAWayOut(index);
    walker.held_up = random_.uniform(0.0, 0.5 * kPatience);  // people who block each other do not try again together
  }
  const std::vector<Eigen::Vector2d> way = errands_->waysTo(*walker.goal).ahead(body.position, kWayAhead);
  if (way.empty()) {
    return Eigen::Vector2d::Zero();
  }
  // The farthest place on the way that can be walked to straight on, by a few samples.
  Eigen::Vector2d target = way.front();
  for (std::size_t i = std::min<std::size_t>(4, way.size() - 1); i < way.size(); i += 4) {
    const Eigen::Vector2d middle = 0.5 * (body.position + way[i]);
    if (i > 4 && !world_.isClear(middle, body.radius)) {
      break;
    }
    target = way[i];
  }
  const Eigen::Vector2d ahead = (target - body.position).normalized();
  const Eigen::Vector2d in_lane = target + walker.lane * Eigen::Vector2d(ahead.y(), -ahead.x());
  target = world_.isClear(in_lane, body.radius) ? in_lane : target;
  return steer(world_, body, target, walker.speed, moversNear(index, robot));
}

/// The velocity of somebody who stands: none, until the robot has waited to get past.
Eigen::Vector2d Pedestrians::stand(std::size_t index, double period, const RobotSweep& robot) {
  Walker& walker = walkers_[index];
  const Mover& body = bodies_[index];
  const Eigen::Vector2d off = body.position - robot.centres.front();
  const bool is_near = off.norm() < robot.radius + body.radius + kRobotNear;
  walker.held_up = is_near ? walker.held_up + period : 0.0;
  if (walker.held_up < kStepAsideAfter) {
    return Eigen::Vector2d::Zero();
  }
  // Away from the robot and out of its way.
  const Eigen::Vector2d ahead = direction(robot.heading);
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const Eigen::Vector2d target = body.position + 0.5 * off.normalized() + left * (off.dot(left) > 0.0 ? 1.0 : -1.0);
  return steer(world_, body, target, kStepAsideSpeed, moversNear(index, robot));
}

std::vector<Mover> Pedestrians::moversNear(std::size_t index, const RobotSweep& robot) const {
  const Mover& self = bodies_[index];
  std::vector<Mover> movers;
  movers.reserve(kManyInSight);
  index_.visitNear(self.position, kSight, [&](std::size_t other) {
    const Mover& body = bodies_[other];
    if (other != index && (body.position - self.position).squaredNorm() < kSight * kSight) {
      movers.push_back(body);
    }
  });
  if ((robot.centres.front() - self.position).norm() < kSight + robot.radius) {
    movers.push_back({robot.centres.front(), robot.velocity, robot.radius + 2.0 * kDistanceToRobot});
  }
  return movers;
}

/// Whether somebody touches nothing there, or comes no nearer to what is too near already.
bool Pedestrians::mayStandAt(std::size_t index, const Eigen::Vector2d& position, const RobotSweep& robot) const {
  const Mover& self = bodies_[index];
  if (!world_.isClear(position, self.radius)) {
    return false;
  }
  const double to_robot = distanceToSweep(robot, position) - self.radius;
  if (to_robot < kDistanceToRobot && to_robot < distanceToSweep(robot, self.position) - self.radius) {
    return false;
  }
  bool is_free = true;
  // The index knows where people were before this step; since then they went half a metre at most.
  index_.visitNear(position, 2.0 * self.radius + 0.3, [&](std::size_t other) {
    const Eigen::Vector2d& p = bodies_[other].position;
    const double distance = (p - position).norm();
    is_free = is_free && (other == index || distance >= 2.0 * self.radius || distance >= (p - self.position).norm());
  });
  return is_free;
}

void Pedestrians::moveFeet(std::size_t index, double period, const RobotSweep& robot) {
  Walker& walker = walkers_[index];
  const Mover& body = bodies_[index];
  const auto footing = [&](const Eigen::Vector2d& foot) {
    return world_.isClear(foot, walker.leg_radius) &&
           distanceToSweep(robot, foot) >= walker.leg_radius + kDistanceToRobot;
  };
  walker.gait.step(body.position, walker.heading, body.velocity, period, footing);
}

void Pedestrians::updatePeople() {
  people_.resize(walkers_.size());
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    const Walker& walker = walkers_[i];
    const std::array<Eigen::Vector2d, 2>& feet = walker.gait.feet();
    people_[i] = {0.5 * (feet[0] + feet[1]),
                  walker.heading,
                  {Circle{feet[0], walker.leg_radius}, Circle{feet[1], walker.leg_radius}}};
  }
}

}  // namespace map_matcher::simulation
