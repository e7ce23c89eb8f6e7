#include "map_matcher/scrubbing/scan_scrubber.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace map_matcher {
namespace {

constexpr double kTurn = 2.0 * M_PI;
constexpr double kBeamMargin = 1.0;  // [beams] looked at beyond the edges of a disc, for rounding

}  // namespace

const std::vector<std::uint32_t>& ScanScrubber::beamsInside(const ScanLayout& layout, const std::vector<float>& ranges,
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

void ScanScrubber::prepareDirections(const ScanLayout& layout, std::size_t num_beams) {
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
  const auto last_beam = static_cast<double>(cosines_.size()) - 1.0;
  if (!(distance - disc.radius <= layout_.range_max)) {
    return;
  }
  if (distance <= disc.radius) {
    markRange(disc, 0.0, last_beam);
    return;
  }
  const double direction = std::atan2(disc.centre.y(), disc.centre.x());
  const double half_width = std::asin(disc.radius / distance);
  const double turn = kTurn / std::abs(layout_.angle_increment);  // [beams]
  const double half_beams = half_width / std::abs(layout_.angle_increment) + kBeamMargin;
  double middle = (direction - layout_.angle_min) / layout_.angle_increment;  // [beams]
  middle -= turn * std::floor((middle + half_beams) / turn);                  // the first that may reach beam 0
  for (; middle - half_beams <= last_beam; middle += turn) {                  // a scan may hold more than one turn
    markRange(disc, middle - half_beams, middle + half_beams);
  }
}

void ScanScrubber::markRange(const Disc& disc, double first_beam, double last_beam) {
  const auto begin = static_cast<std::size_t>(std::max(0.0, std::ceil(first_beam)));
  const auto end =
      static_cast<std::size_t>(std::clamp(std::floor(last_beam) + 1.0, 0.0, static_cast<double>(inside_.size())));
  const double squared_radius = disc.radius * disc.radius;
  for (std::size_t i = begin; i < end; ++i) {
    const double dx = x_[i] - disc.centre.x();
    const double dy = y_[i] - disc.centre.y();
    inside_[i] = static_cast<std::uint8_t>(inside_[i] | static_cast<std::uint8_t>(dx * dx + dy * dy <= squared_radius));
  }
}

}  // namespace map_matcher
