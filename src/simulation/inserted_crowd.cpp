#include "map_matcher/simulation/inserted_crowd.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "map_matcher/parameters/option_check.hpp"
#include "map_matcher/simulation/round_obstacles.hpp"

namespace map_matcher::simulation {
namespace {

constexpr double kPeriod = 0.07;      // [s] that people move on at once, at most
constexpr double kWarmUp = 5.0;       // [s] that people walk before the drive begins
constexpr double kLongestGap = 10.0;  // [s] that people move on between two scans, at most
constexpr double kRoomAtStart = 0.5;  // [m] around the robot where nobody is at first

/// Streams of the seed.
enum Stream : std::uint64_t { kPeople = 1, kNoise = 2, kDetector = 3 };

const InsertedCrowdOptions& checked(const InsertedCrowdOptions& options) {
  InsertedCrowdOptions copy = options;
  parameters::ParameterList parameters = parametersOf(copy.pedestrians);
  parameters.push_back({"radius", "m", "Of the robot.", &copy.robot_radius, 0.05, 2.0});
  parameters.push_back({"sigma", "m", "Of a range.", &copy.sigma, 0.0, 1.0});
  parameters::throwIfAny(parameters::problemsOf(parameters));
  return options;
}

/// The scan with its angles as seen from above, which run backwards for a laser that hangs upside down; and back.
scan::PlanarScan turnedOver(const scan::MountedScan& mounted) {
  scan::PlanarScan scan = mounted.scan;
  if (mounted.mount.upside_down) {
    scan.angle_min = -scan.angle_min;
    scan.angle_increment = -scan.angle_increment;
  }
  return scan;
}

}  // namespace

InsertedCrowd::InsertedCrowd(const grid::OccupancyGrid& map, const InsertedCrowdOptions& options)
    : world_(map),
      options_(checked(options)),
      detector_(map, options.detector, RandomNumbers(options.seed, kDetector)),
      noise_(options.seed, kNoise) {}

void InsertedCrowd::moveOn(double time, const std::vector<grid::Rigid2>& way) {
  double period = std::clamp(time - time_, 0.0, kLongestGap);
  RobotSweep sweep = sweepOf(way);
  if (people_ && period > 0.0) {
    sweep.velocity = (way.front().translation() - T_map_base_.translation()) / (time - time_);
  }
  time_ = time;
  T_map_base_ = way.front();
  if (!people_) {
    const Circle kept_free{T_map_base_.translation(), options_.robot_radius + kRoomAtStart};
    people_ =
        std::make_unique<Pedestrians>(world_, options_.pedestrians, RandomNumbers(options_.seed, kPeople), kept_free);
    period = kWarmUp;
  }
  const int num_steps = static_cast<int>(std::ceil(period / kPeriod - 1e-9));
  for (int i = 0; i < num_steps; ++i) {
    people_->step(period / num_steps, sweep);
  }
}

CrowdedScan InsertedCrowd::among(const scan::MountedScan& recorded) {
  if (!people_) {
    return {recorded.scan, std::nullopt};
  }
  const grid::Rigid2 T_map_laser = T_map_base_ * recorded.mount.T_base_laser;
  const std::vector<Circle> legs = legsOf(people_->people());
  const std::vector<std::size_t> in_sight = legsInSight(legs);
  std::vector<Circle> seen;
  seen.reserve(in_sight.size());
  for (const std::size_t leg : in_sight) {
    seen.push_back(legs[leg]);
  }
  LidarView view = insertCircles(turnedOver(recorded), seen, T_map_laser, options_.sigma, noise_);
  std::vector<int> rays_on(legs.size(), 0);
  for (std::size_t i = 0; i < in_sight.size(); ++i) {
    rays_on[in_sight[i]] = view.rays_on[i];
  }
  view.rays_on = std::move(rays_on);
  CrowdedScan crowded{recorded.scan, detector_.detect(view, people_->people(), T_map_laser, time_)};
  crowded.scan.ranges = std::move(view.scan.ranges);
  if (crowded.detections && recorded.mount.upside_down) {
    for (DetectedPerson& person : crowded.detections->people) {
      person.position.y() = -person.position.y();
    }
  }
  return crowded;
}

const std::vector<Person>& InsertedCrowd::people() const {
  static const std::vector<Person> kNobody;
  return people_ ? people_->people() : kNobody;
}

/// The robot as people have to avoid it: where it is and will be.
RobotSweep InsertedCrowd::sweepOf(const std::vector<grid::Rigid2>& way) const {
  RobotSweep sweep;
  for (const grid::Rigid2& pose : way) {
    sweep.centres.push_back(pose.translation());
  }
  sweep.radius = options_.robot_radius;
  sweep.heading = way.front().yaw;
  return sweep;
}

/// Indices of the legs that the robot does not stand on.
std::vector<std::size_t> InsertedCrowd::legsInSight(const std::vector<Circle>& legs) const {
  std::vector<std::size_t> in_sight;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if ((legs[i].centre - T_map_base_.translation()).norm() > options_.robot_radius + legs[i].radius) {
      in_sight.push_back(i);
    }
  }
  return in_sight;
}

}  // namespace map_matcher::simulation
