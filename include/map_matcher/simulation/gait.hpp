/// \file
/// How the feet of a walking person move.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>

namespace map_matcher::simulation {

/// Two feet that take turns. The stance foot stays where it is on the ground; the swing foot moves from where it was
/// lifted to where it lands with a speed that rises and falls as a sine, half a step length ahead of the body as it
/// will be then. Faster people take longer and more steps: step length by step frequency is 0.39 m s (Sekiya, Nagasaki:
/// "Reproducibility of the walking patterns of normal young adults", 1998), so sqrt(0.39 v) is the step length at speed
/// v. Somebody who stops closes the last step; who stands keeps both feet still.
class Gait {
 public:
  /// Whether a leg may be at a place of the map frame [m].
  using Footing = std::function<bool(const Eigen::Vector2d&)>;

  /// Stands at `centre` [m] and looks along `heading` [rad]. `half_width` [m]: a foot's distance from the middle.
  Gait(const Eigen::Vector2d& centre, double heading, double half_width);

  /// Moves the feet to where they are `period` [s] later, when the body has come to `centre` [m] with this heading
  /// [rad] and velocity [m/s]. A swing foot that has no footing is taken nearer to the body, which has footing
  /// everywhere within half_width.
  void step(const Eigen::Vector2d& centre, double heading, const Eigen::Vector2d& velocity, double period,
            const Footing& footing);

  /// Left and right foot in the map frame [m].
  const std::array<Eigen::Vector2d, 2>& feet() const { return feet_; }

  /// Index of the foot that swings; std::nullopt when both stand.
  std::optional<std::size_t> swingFoot() const { return swing_foot_; }

 private:
  Eigen::Vector2d besideBody(std::size_t foot, const Eigen::Vector2d& centre, double heading) const;
  void startStep(const Eigen::Vector2d& centre, double heading, const Eigen::Vector2d& velocity);

  double half_width_;
  std::array<Eigen::Vector2d, 2> feet_;
  std::optional<std::size_t> swing_foot_;
  std::size_t next_foot_ = 0;
  Eigen::Vector2d lift_off_ = Eigen::Vector2d::Zero();  // where the swing foot was lifted
  double progress_ = 0.0;                               // of the step, from 0 to 1
};

}  // namespace map_matcher::simulation
