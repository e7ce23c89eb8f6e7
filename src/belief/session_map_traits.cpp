#include "map_matcher/belief/session_map_traits.hpp"

#include <cstring>
#include <functional>
#include <sstream>
#include <string_view>

namespace map_matcher::belief {
namespace {

std::uint64_t mixed(std::uint64_t digest, std::uint64_t value) {
  constexpr std::uint64_t kPrime = 0x100000001b3;  // FNV-1a
  return (digest ^ value) * kPrime;
}

std::uint64_t bitsOf(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

std::string whyAnotherSession(const SessionMapTraits& last, const SessionMapTraits& next) {
  std::ostringstream why;
  if (next.frame != last.frame) {
    why << "its frame is \"" << next.frame << "\", not \"" << last.frame << "\"";
  } else if (next.publisher != last.publisher) {
    why << "it comes from " << next.publisher << ", not " << last.publisher;
  } else if (next.resolution != last.resolution) {
    why << "its cells are " << next.resolution << " m wide, not " << last.resolution << " m";
  } else if (next.stamp && last.stamp && *next.stamp < *last.stamp) {
    why << "its stamp is " << *last.stamp - *next.stamp << " s before that of the last one";
  } else if (static_cast<double>(next.known_cells) < kKeptShare * static_cast<double>(last.known_cells)) {
    why << "it has " << next.known_cells << " known cells, the last one had " << last.known_cells;
  }
  return why.str();
}

std::uint64_t digestOf(const grid::OccupancyGrid& map) {
  const grid::GridGeometry& geometry = map.geometry();
  std::uint64_t digest = 0xcbf29ce484222325;  // FNV-1a
  for (const double value : {geometry.resolution, geometry.T_map_grid.x, geometry.T_map_grid.y, geometry.T_map_grid.yaw,
                             static_cast<double>(geometry.width), static_cast<double>(geometry.height)}) {
    digest = mixed(digest, bitsOf(value));
  }
  const auto* cells = reinterpret_cast<const char*>(map.values().data());
  return mixed(digest, std::hash<std::string_view>{}(std::string_view(cells, map.values().size())));
}

}  // namespace map_matcher::belief
