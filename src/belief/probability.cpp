#include "map_matcher/belief/probability.hpp"

#include <algorithm>
#include <cmath>

namespace map_matcher::belief {
namespace {

// Fitted by scripts/fit_probability.
constexpr double kBias = -8.0;
constexpr double kMarginWeight = 60.0;
constexpr double kWorthWeight = 12.0;
constexpr double kSeenThroughWeight = -15.0;
constexpr double kWallsWeight = 1.0;

constexpr double kMostWalls = 30.0;  // [m] that say something

}  // namespace

double probabilityOf(const ProbabilityFeatures& features) {
  const double margin = std::clamp(features.margin, 0.0, kLargestMargin);
  const double walls = std::log(1.0 + std::clamp(features.walls, 0.0, kMostWalls));
  const double evidence = kBias + kMarginWeight * margin + kWorthWeight * features.worth +
                          kSeenThroughWeight * features.seen_through + kWallsWeight * walls;
  return 1.0 / (1.0 + std::exp(-evidence));
}

double probabilityOf(const Findings& findings) {
  if (findings.candidates.empty()) {
    return 0.0;
  }
  const Candidate& best = findings.candidates.front();
  return probabilityOf({findings.search.margin, best.worth, best.space.throughShare(), best.space.agreeing()});
}

}  // namespace map_matcher::belief
