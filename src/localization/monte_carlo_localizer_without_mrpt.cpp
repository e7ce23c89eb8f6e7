/// \file
/// What stands in for monte_carlo_localizer.cpp in a build without MRPT: nothing but the sentence that says so.
#include <stdexcept>

#include "map_matcher/localization/monte_carlo_localizer.hpp"
#include "map_matcher/parameters/option_check.hpp"

namespace map_matcher::localization {

class MonteCarloLocalizer::Impl {};

bool MonteCarloLocalizer::available() { return false; }

MonteCarloLocalizer::MonteCarloLocalizer(const grid::OccupancyGrid& /*map*/, const MonteCarloOptions& options) {
  parameters::throwIfAny(problemsWith(options));
  throw std::runtime_error(
      "Monte-Carlo localization is MRPT's, and MRPT (mrpt-slam) was not found when this was built; install "
      "it as scripts/packages.txt names it, and build again");
}

MonteCarloLocalizer::~MonteCarloLocalizer() = default;

void MonteCarloLocalizer::reset() {}

bool MonteCarloLocalizer::add(const grid::Rigid2& /*T_odom_base*/, const std::vector<scan::MountedScan>& /*scans*/) {
  return false;
}

MonteCarloEstimate MonteCarloLocalizer::estimate() const { return {}; }

}  // namespace map_matcher::localization
