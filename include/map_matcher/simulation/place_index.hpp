/// \file
/// Who is near.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace map_matcher::simulation {

/// Points of the plane sorted into square bins, so that those near a place are found without looking at the others.
class PlaceIndex {
 public:
  /// For points within a box [m]; those outside count to the bins at its edge. `bin_size` [m] is positive.
  PlaceIndex(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double bin_size);

  /// Forgets all points.
  void clear();

  /// Adds a point with the number that it goes by.
  void insert(std::size_t number, const Eigen::Vector2d& point);

  /// Calls `visit(number)` for every point within `distance` [m] of a place, and for some that are farther away; always
  /// in the same order.
  template <typename Visit>
  void visitNear(const Eigen::Vector2d& place, double distance, Visit&& visit) const {
    const Bin first = binOf(place.array() - distance);
    const Bin last = binOf(place.array() + distance);
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) {
        for (const std::size_t number : bins_[indexOf({x, y})]) {
          visit(number);
        }
      }
    }
  }

 private:
  struct Bin {
    int x;
    int y;
  };

  Bin binOf(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d bin = (point - low_) / bin_size_;
    return {std::clamp(static_cast<int>(bin.x()), 0, width_ - 1),
            std::clamp(static_cast<int>(bin.y()), 0, height_ - 1)};
  }
  std::size_t indexOf(const Bin& bin) const {
    return static_cast<std::size_t>(bin.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(bin.x);
  }

  Eigen::Vector2d low_;
  double bin_size_;
  int width_;
  int height_;
  std::vector<std::vector<std::size_t>> bins_;
};

}  // namespace map_matcher::simulation
