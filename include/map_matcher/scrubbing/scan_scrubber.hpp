/// \file
/// Finds the beams of a scan that end on people.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "map_matcher/scan/beams_near.hpp"
#include "map_matcher/scan/planar_scan.hpp"

namespace map_matcher::scrubbing {

/// A circle around a detected person, in the laser frame.
struct Disc {
  Eigen::Vector2d centre{0.0, 0.0};  ///< [m]
  double radius = 0.3;               ///< [m]
};

/// Finds which measured points of a scan lie in any of some discs, borders included (report section 2.2). Keeps its
/// memory from scan to scan: after the first scan of a size nothing is allocated. Not thread-safe.
class ScanScrubber {
 public:
  /// Indices of the beams whose points lie in a disc, in rising order. A beam whose range is not finite or not within
  /// [range_min, range_max] measured no point. Discs that are not finite hold no point. The layout must be valid. The
  /// reference holds until the next call.
  const std::vector<std::uint32_t>& beamsInside(const scan::ScanLayout& layout, const std::vector<float>& ranges,
                                                const std::vector<Disc>& discs);

  const scan::ScanLayout& layout() const { return layout_; }  ///< Of the last scan.

  /// Number of points that the last scan measured.
  int numPoints() const { return num_points_; }

  /// The point of a beam of the last scan, in the laser frame [m]; nan when it measured none.
  Eigen::Vector2d point(std::uint32_t beam) const { return {x_[beam], y_[beam]}; }

 private:
  void prepareDirections(const scan::ScanLayout& layout, std::size_t num_beams);
  void placePoints(const std::vector<float>& ranges);
  void markInside(const Disc& disc);
  void markRange(const Disc& disc, const scan::BeamRange& beams);

  scan::ScanLayout layout_;
  std::vector<double> cosines_;  // of the beams' directions
  std::vector<double> sines_;
  std::vector<double> x_;  // of the points [m]; nan where there is none
  std::vector<double> y_;
  std::vector<std::uint8_t> inside_;  // whether the point lies in a disc
  std::vector<std::uint32_t> beams_;
  int num_points_ = 0;
};

}  // namespace map_matcher::scrubbing
