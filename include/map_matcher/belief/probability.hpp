/// \file
/// How likely a place is to be right.
#pragma once

#include "map_matcher/belief/findings.hpp"

namespace map_matcher::belief {

/// What the probability is a function of.
struct ProbabilityFeatures {
  double margin = 0.0;        ///< By how much the place is known to be ahead of any other, 0 to kLargestMargin.
  double seen_through = 0.0;  ///< FreeSpace::throughShare().
  double walls = 0.0;         ///< FreeSpace::agreeing() [m].
};

/// Larger margins say no more than this one; no search looks farther.
constexpr double kLargestMargin = 0.2;

/// Probability that a place is right, 0 to 1: a logistic function that scripts/fit_probability fits to simulated and
/// recorded places, right and wrong ones.
double probabilityOf(const ProbabilityFeatures& features);

/// The same of the first candidate of an exact search; 0 without one.
double probabilityOf(const Findings& findings);

}  // namespace map_matcher::belief
