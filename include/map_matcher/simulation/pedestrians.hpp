/// \file
/// A crowd that walks through a building.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "map_matcher/parameters/parameter.hpp"
#include "map_matcher/simulation/circle.hpp"
#include "map_matcher/simulation/errands.hpp"
#include "map_matcher/simulation/gait.hpp"
#include "map_matcher/simulation/path_planner.hpp"
#include "map_matcher/simulation/place_index.hpp"
#include "map_matcher/simulation/random_numbers.hpp"
#include "map_matcher/simulation/steering.hpp"
#include "map_matcher/simulation/world.hpp"

namespace map_matcher::simulation {

/// The crowd of the report's section 3.3.2. Ranges stand in parametersOf().
struct PedestrianOptions {
  int people = 0;               ///< How many; 0: as many as the density says.
  double density = 0.0;         ///< [1/m^2] People per area of free space that people can get to.
  double standing_share = 0.3;  ///< Share of them who stand in groups.
  double speed = 1.0;           ///< [m/s] Mean speed of those who walk, where nobody is in the way.
  double speed_sigma = 0.2;     ///< [m/s] Standard deviation of that speed from person to person.
  double body_radius = 0.18;    ///< [m] Nobody's centre is nearer to a wall, nor to another's than twice this.
  double leg_radius = 0.065;    ///< [m] Mean radius of a leg where the lidar sees it; people differ by 15 %.
};

/// The parameters that fill `options`.
parameters::ParameterList parametersOf(PedestrianOptions& options);

/// What can be seen of somebody at one instant.
struct Person {
  Eigen::Vector2d position;    ///< Centre between the legs in the map frame [m].
  double heading = 0.0;        ///< [rad] In the map frame.
  std::array<Circle, 2> legs;  ///< Left and right, in the map frame.
};

/// The legs of people: left and right of the first, left and right of the second, and so on.
std::vector<Circle> legsOf(const std::vector<Person>& people);

/// The robot as people have to avoid it.
struct RobotSweep {
  std::vector<Eigen::Vector2d> centres;  ///< Where the robot is now and on its way to a stop [m]; one or more.
  double radius = 0.0;                   ///< [m] Of the robot.
  double heading = 0.0;                  ///< [rad] In the map frame.
  Eigen::Vector2d velocity{0.0, 0.0};    ///< [m/s]
};

/// People who walk between random places, or stand in groups, and never touch a wall, each other or the robot. Walkers
/// go along planned ways, keep to the right, get past others by steer(), and choose another goal when they are held up;
/// who stands steps aside for a robot that waits there. The same random numbers give the same crowd. Not thread-safe.
class Pedestrians {
 public:
  static constexpr double kDistanceToRobot = 0.1;  ///< [m] from a body or leg to the robot, at least.

  /// `world` must outlive the crowd. Nobody begins within `kept_free`. When the building is too full, there are fewer
  /// people than asked for. Throws std::invalid_argument that names every option out of its range.
  Pedestrians(const World& world, const PedestrianOptions& options, const RandomNumbers& random,
              const std::optional<Circle>& kept_free);

  /// Moves everybody on by `period` [s]; longer ones than 0.1 s are taken for that. Nobody comes nearer than
  /// kDistanceToRobot to the sweep; who is nearer already comes no nearer still.
  void step(double period, const RobotSweep& robot);

  /// Everybody, always in the same order.
  const std::vector<Person>& people() const { return people_; }

  /// A person's body, which no wall, no other body and no robot touches.
  const Mover& bodyOf(std::size_t person) const { return bodies_[person]; }

 private:
  struct Walker {
    double heading;
    double speed;                     // [m/s] where nobody is in the way
    double leg_radius;                // [m]
    std::optional<std::size_t> goal;  // who has none stands
    double lane;                      // [m] to the right of planned ways
    double held_up;                   // [s] for how long; of who stands: how long the robot has been near
    Eigen::Vector2d wanted;           // velocity that was last decided on
    Gait gait;
  };

  void populate(std::size_t count, const std::optional<Circle>& kept_free);
  bool placeGroup(std::size_t size, const std::optional<Circle>& kept_free);
  bool place(const Eigen::Vector2d& position, double heading, bool stands, const std::optional<Circle>& kept_free);
  Eigen::Vector2d randomPlace();
  std::size_t goalWithAWayOut(std::size_t index);
  Eigen::Vector2d wantedVelocity(std::size_t index, double period, const RobotSweep& robot);
  Eigen::Vector2d walk(std::size_t index, double period, const RobotSweep& robot);
  Eigen::Vector2d stand(std::size_t index, double period, const RobotSweep& robot);
  std::vector<Mover> moversNear(std::size_t index, const RobotSweep& robot) const;
  bool mayStandAt(std::size_t index, const Eigen::Vector2d& position, const RobotSweep& robot) const;
  void move(std::size_t index, double period, const RobotSweep& robot);
  void moveFeet(std::size_t index, double period, const RobotSweep& robot);
  void updatePeople();

  const World& world_;
  PedestrianOptions options_;
  RandomNumbers random_;
  PathPlanner planner_;
  std::optional<Errands> errands_;  // none where nobody is
  std::vector<Walker> walkers_;
  std::vector<Mover> bodies_;  // of the walkers; by themselves, since everybody looks at those of many others
  PlaceIndex index_;
  std::size_t num_steps_ = 0;
  std::vector<Person> people_;
};

}  // namespace map_matcher::simulation
