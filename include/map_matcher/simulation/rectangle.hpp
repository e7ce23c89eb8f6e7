/// \file
/// Upright rectangles of a floor plan.
#pragma once

#include <Eigen/Core>

namespace map_matcher::simulation {

/// A rectangle along the axes of a floor plan [m].
struct Rectangle {
  double x_min = 0.0;
  double y_min = 0.0;
  double x_max = 0.0;
  double y_max = 0.0;

  double width() const { return x_max - x_min; }      ///< Along x [m]; negative when there is nothing in it.
  double height() const { return y_max - y_min; }     ///< Along y [m]; negative when there is nothing in it.
  double area() const { return width() * height(); }  ///< [m^2]
  Eigen::Vector2d centre() const { return {0.5 * (x_min + x_max), 0.5 * (y_min + y_max)}; }  ///< [m]
};

/// Whether a point [m] lies in a rectangle or on its edge.
bool contains(const Rectangle& rectangle, const Eigen::Vector2d& p);

/// Distance between two rectangles along the axis on which they are farther apart [m]: positive when they are apart,
/// minus the smaller overlap when they are not. Two squares that touch with their corners are 0 apart.
double separation(const Rectangle& a, const Rectangle& b);

}  // namespace map_matcher::simulation
