#include "map_matcher/search/two_stage/rotation_bands.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace map_matcher::search {
namespace {

/// What is left free of a band's width for rounding [cells].
constexpr double kRounding = 1e-6;

}  // namespace

std::vector<RotationBand> rotationBands(const SessionCells& session, const std::vector<double>& angles) {
  const auto angle = [&angles](int rotation) { return angles[static_cast<std::size_t>(rotation)]; };
  std::vector<int> order(angles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return angle(a) < angle(b); });
  const double widest = (2.0 * kBandReach - kRounding) / std::max(1.0, farthestPoint(session));
  std::vector<RotationBand> bands;
  for (auto first = order.cbegin(); first != order.cend();) {
    const double begin = angle(*first);
    const auto end = std::find_if(first, order.cend(), [&](int n) { return angle(n) - begin > widest; });
    bands.push_back({{first, end}, 0.5 * (begin + angle(*(end - 1)))});
    first = end;
  }
  return bands;
}

}  // namespace map_matcher::search
