#include "map_matcher/simulation/gait.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::simulation {
namespace {

constexpr double kWalkingRatio = 0.39;    // [m s] step length by step frequency
constexpr double kLowestFrequency = 0.8;  // [Hz] of steps, however slow they are
constexpr double kStandstill = 0.05;      // [m/s] slower people take no step but to close the last one
constexpr double kClosed = 0.12;          // [m] off its place beside the body a foot may remain

double stepFrequency(double speed) { return std::max(kLowestFrequency, std::sqrt(speed / kWalkingRatio)); }

}  // namespace

Gait::Gait(const Eigen::Vector2d& centre, double heading, double half_width)
    : half_width_(half_width), feet_{besideBody(0, centre, heading), besideBody(1, centre, heading)} {}

void Gait::step(const Eigen::Vector2d& centre, double heading, const Eigen::Vector2d& velocity, double period,
                const Footing& footing) {
  const double speed = velocity.norm();
  const double frequency = stepFrequency(speed);
  if (!swing_foot_) {
    startStep(centre, heading, velocity);
  }
  double to_go = frequency * period;  // [steps]
  while (swing_foot_) {
    const std::size_t foot = *swing_foot_;
    const double advance = std::min(to_go, 1.0 - progress_);
    progress_ += advance;
    to_go -= advance;
    // Where the body is when this step ends, and half a step length ahead of that.
    const Eigen::Vector2d landing =
        besideBody(foot, centre, heading) + velocity * ((1.0 - progress_ - to_go) / frequency + 0.5 / frequency);
    const Eigen::Vector2d wanted = lift_off_ + (landing - lift_off_) * (0.5 - 0.5 * std::cos(M_PI * progress_));
    const Eigen::Vector2d safe = besideBody(foot, centre, heading);
    double share = 1.0;
    while (share > 0.0 && !footing(safe + (wanted - safe) * share)) {
      share -= 0.25;
    }
    feet_[foot] = safe + (wanted - safe) * share;
    if (progress_ < 1.0) {
      return;
    }
    startStep(centre, heading, velocity);
  }
}

/// Puts the swing foot down and lifts the next, when there is a reason to.
void Gait::startStep(const Eigen::Vector2d& centre, double heading, const Eigen::Vector2d& velocity) {
  progress_ = 0.0;
  if (swing_foot_) {
    next_foot_ = 1 - *swing_foot_;
    swing_foot_.reset();
  }
  const auto off_place = [&](std::size_t foot) { return (feet_[foot] - besideBody(foot, centre, heading)).norm(); };
  if (velocity.norm() < kStandstill && off_place(next_foot_) <= kClosed) {
    next_foot_ = 1 - next_foot_;
    if (off_place(next_foot_) <= kClosed) {
      return;
    }
  }
  swing_foot_ = next_foot_;
  lift_off_ = feet_[next_foot_];
}

/// The place of a foot of somebody who stands.
Eigen::Vector2d Gait::besideBody(std::size_t foot, const Eigen::Vector2d& centre, double heading) const {
  const double side = foot == 0 ? half_width_ : -half_width_;
  return centre + side * Eigen::Vector2d(-std::sin(heading), std::cos(heading));
}

}  // namespace map_matcher::simulation
