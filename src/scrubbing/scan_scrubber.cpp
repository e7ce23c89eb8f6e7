#include "map_matcher/scrubbing/scan_scrubber.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace map_matcher::scrubbing {
namespace {

constexpr double kBeamMargin = 1.0;  // [beams] looked at beyond the edges of a disc, for rounding

}  // namespace

const std::vector<std::uint32_t>& ScanScrubber::beamsInside(const scan::ScanLayout& layout,
                                                            const std::vector<float>& ranges,
                                                            const std::vector<Disc>& discs) {
  prepareDirections(layout, ranges.size());
  placePoints(ranges);
  inside_.assign(ranges.size(), 0);
  for (const Disc& disc : discs) {
    markInside(disc);
  }
  beams_.clear();
  for (std::size_t i = 0; i < inside_.size(); ++i) {
    if (inside_[i] != 0) {
      beams_.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return beams_;
}

void ScanScrubber::prepareDirections(const scan::ScanLayout& layout, std::size_t num_beams) {
  if (layout == layout_ && num_beams == cosines_.size()) {
    return;  // sines and cosines take longer than all the rest
  }
  layout_ = layout;
  cosines_.resize(num_beams);
  sines_.resize(num_beams);
  x_.resize(num_beams);
  y_.resize(num_beams);
  beams_.reserve(num_beams);
  for (std::size_t i = 0; i < num_beams; ++i) {
    const double angle = layout.angle_min + static_cast<double>(i) * layout.angle_increment;
    cosines_[i] = std::cos(angle);
    sines_[i] = std::sin(angle);
  }
}

void ScanScrubber::placePoints(const std::vector<float>& ranges) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  num_points_ = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const auto range = static_cast<double>(ranges[i]);
    const bool measured = range >= layout_.range_min && range <= layout_.range_max;
    x_[i] = measured ? range * cosines_[i] : kNone;
    y_[i] = measured ? range * sines_[i] : kNone;
    num_points_ += measured ? 1 : 0;
  }
}

/// Only the beams that point at the disc are looked at: those within asin(radius / distance) of its centre.
void ScanScrubber::markInside(const Disc& disc) {
  const double distance = disc.centre.norm();
  if (!(distance - disc.radius <= layout_.range_max)) {
    return;
  }
  if (distance <= disc.radius) {
    markRange(disc, {0, inside_.size()});
    return;
  }
  scan::visitBeamsNear(layout_.angle_min, layout_.angle_increment, inside_.size(),
                       std::atan2(disc.centre.y(), disc.centre.x()), std::asin(disc.radius / distance), kBeamMargin,
                       [&](const scan::BeamRange& beams) { markRange(disc, beams); });
}

void ScanScrubber::markRange(const Disc& disc, const scan::BeamRange& beams) {
  const double squared_radius = disc.radius * disc.radius;
  for (std::size_t i = beams.begin; i < beams.end; ++i) {
    const double dx = x_[i] - disc.centre.x();
    const double dy = y_[i] - disc.centre.y();
    inside_[i] = static_cast<std::uint8_t>(inside_[i] | static_cast<std::uint8_t>(dx * dx + dy * dy <= squared_radius));
  }
}

}  // namespace map_matcher::scrubbing
