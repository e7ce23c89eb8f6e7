#include "map_matcher/simulation/place_index.hpp"

namespace map_matcher::simulation {

PlaceIndex::PlaceIndex(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double bin_size)
    : low_(low),
      bin_size_(bin_size),
      width_(1 + static_cast<int>((high.x() - low.x()) / bin_size)),
      height_(1 + static_cast<int>((high.y() - low.y()) / bin_size)),
      bins_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

void PlaceIndex::clear() {
  for (std::vector<std::size_t>& bin : bins_) {
    bin.clear();
  }
}

void PlaceIndex::insert(std::size_t number, const Eigen::Vector2d& point) {
  bins_[indexOf(binOf(point))].push_back(number);
}

}  // namespace map_matcher::simulation
