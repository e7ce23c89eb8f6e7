#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

#include "map_matcher/scan/beams_near.hpp"

namespace map_matcher::scan {
namespace {

/// How often each beam is visited.
std::vector<int> visitsOf(double angle_min, double angle_increment, std::size_t num_beams, double bearing,
                          double half_width, double margin) {
  std::vector<int> visits(num_beams, 0);
  visitBeamsNear(angle_min, angle_increment, num_beams, bearing, half_width, margin, [&](const BeamRange& beams) {
    for (std::size_t i = beams.begin; i < beams.end; ++i) {
      ++visits.at(i);
    }
  });
  return visits;
}

class BeamsNear : public testing::TestWithParam<unsigned> {
 protected:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  }

  std::mt19937 random{GetParam()};
};

TEST_P(BeamsNear, AreVisitedOnceAndHardlyAnyOthers) {
  const double angle_min = uniform(-20.0, 20.0);
  const double increment = (random() % 2 == 0 ? 1.0 : -1.0) * uniform(0.001, 0.3);
  const double bearing = uniform(-M_PI, M_PI);
  const double half_width = uniform(0.0, 0.5 * M_PI);

  const std::vector<int> visits = visitsOf(angle_min, increment, random() % 5000, bearing, half_width, 1.0);

  const bool windows_touch = 2.0 * (half_width + 1.5 * std::abs(increment)) >= 2.0 * M_PI;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const double angle = angle_min + static_cast<double>(i) * increment;
    const double away = std::abs(std::remainder(angle - bearing, 2.0 * M_PI));
    if (away <= half_width || windows_touch) {
      EXPECT_EQ(visits[i], 1) << i;
    } else if (away > half_width + 1.01 * std::abs(increment)) {
      EXPECT_EQ(visits[i], 0) << i;
    }
  }
}

TEST_P(BeamsNear, AreNeverVisitedTwiceWhateverTheAnglesAre) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const double absurd[] = {kNan, kInf, -kInf, 0.0, 1e-310, -1e-310, 1e-30, 1e8, -1e8, 1e30, -1e30, 1e300, 0.01};
  const auto any = [&] { return absurd[random() % std::size(absurd)]; };

  for (const int visits : visitsOf(any(), any(), random() % 1000, uniform(-M_PI, M_PI), uniform(0.0, 1.5), 1.0)) {
    EXPECT_LE(visits, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, BeamsNear, testing::Range(0U, 500U));

}  // namespace
}  // namespace map_matcher::scan
