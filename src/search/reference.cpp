#include "map_matcher/search/reference.hpp"

#include <limits>
#include <utility>

#include "map_matcher/work/deadline.hpp"
#include "map_matcher/work/stopwatch.hpp"

namespace map_matcher::search {
namespace {

/// Resolutions that differ by less than this share are the same.
constexpr double kSameResolution = 1e-6;

}  // namespace

Reference::Reference(grid::OccupancyGrid grid, const SearchOptions& options)
    : grid_(std::move(grid)), options_(options) {}

Reference::Prepared Reference::at(double session_resolution, const work::StopToken& stop) const {
  const bool coarser = session_resolution > grid_.resolution() * (1.0 + kSameResolution);
  const double resolution = coarser ? session_resolution : grid_.resolution();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (prepared_.map && prepared_.map->resolution() == resolution) {
    return prepared_;
  }
  work::Stopwatch watch;
  try {
    const work::Deadline no_deadline(std::numeric_limits<double>::infinity(), stop);
    auto map = std::make_shared<const SearchReference>(grid_, resolution, options_, no_deadline);
    prepared_ = {std::move(map), watch.lap()};
    return prepared_;
  } catch (const work::DeadlinePassed&) {
    return {};
  }
}

const grid::SeenSpace& Reference::seen() const {
  std::call_once(seen_made_,
                 [this] { seen_.emplace(grid_, options_.reference_map_cell_offset, options_.occupied_threshold); });
  return *seen_;
}

}  // namespace map_matcher::search
