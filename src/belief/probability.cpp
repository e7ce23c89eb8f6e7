#include "map_matcher/belief/probability.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::belief {
namespace {

// Fitted by scripts/fit_probability.
constexpr double kBias = -10.1;
constexpr double kMarginWeight = 18.8;
constexpr double kSeenThroughWeight = -18.2;
constexpr double kWallsWeight = 3.66;

constexpr double kMostWalls = 30.0;  // [m]; more say no more

}  // namespace

double probabilityOf(const ProbabilityFeatures& features) {
  const double margin = std::clamp(features.margin, 0.0, kLargestMargin);
  const double walls = std::log(1.0 + std::clamp(features.walls, 0.0, kMostWalls));
  const double evidence =
      kBias + kMarginWeight * margin + kSeenThroughWeight * features.seen_through + kWallsWeight * walls;
  return 1.0 / (1.0 + std::exp(-evidence));
}

double probabilityOf(const Findings& findings) {
  if (findings.candidates.empty()) {
    return 0.0;
  }
  const Candidate& best = findings.candidates.front();
  return probabilityOf({findings.search.margin, best.space.throughShare(), best.space.agreeing()});
}

}  // namespace map_matcher::belief
